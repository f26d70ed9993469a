//! Meshes, scenes and states made by hand, with exactly known fields.
#![allow(dead_code)]

use brinell::answer::results::line_frame::LineFrame;
use brinell::model::material::Steel;
use brinell::model::mesh::{Body, Face, Mesh, Surface};
use brinell::model::scene::{ContactPair, Partner, PlaneMotion, RigidPlane, Scene, Side, Support};
use brinell::model::state::{ContactField, PlaneField, State};

pub const STEEL: Steel = Steel {
    youngs_modulus: 29500.0,
    poissons_ratio: 0.3,
    yield_stress: 100.0,
    hardening_modulus: 249.471,
};

/// The six sides of a hexahedron, counter-clockwise seen from outside: u-, u+, v-, v+, w-, w+.
const SIDES: [[usize; 4]; 6] = [
    [0, 4, 7, 3],
    [1, 2, 6, 5],
    [0, 1, 5, 4],
    [3, 7, 6, 2],
    [0, 3, 2, 1],
    [4, 5, 6, 7],
];

/// Adds a body over the grid lines `u`, `v`, `w`, placed by `map`, with a surface for each side
/// called `<name>_<side>`, side being u-, u+, v-, v+, w- or w+.
pub fn add_block(
    mesh: &mut Mesh,
    name: &str,
    lines: [&[f64]; 3],
    map: impl Fn([f64; 3]) -> [f64; 3],
) {
    let first = mesh.points.len();
    let [u, v, w] = lines;
    let index = |i: usize, j: usize, k: usize| (first + i + u.len() * (j + v.len() * k)) as u32;
    for &z in w {
        for &y in v {
            for &x in u {
                mesh.points.push(map([x, y, z]));
            }
        }
    }
    let cells = [u.len() - 1, v.len() - 1, w.len() - 1];
    let start = mesh.hexes.len();
    let mut sides: [Vec<Face>; 6] = Default::default();
    for k in 0..cells[2] {
        for j in 0..cells[1] {
            for i in 0..cells[0] {
                let (a, b, c) = (i + 1, j + 1, k + 1);
                let hex = [
                    index(i, j, k),
                    index(a, j, k),
                    index(a, b, k),
                    index(i, b, k),
                    index(i, j, c),
                    index(a, j, c),
                    index(a, b, c),
                    index(i, b, c),
                ];
                let element = mesh.hexes.len() as u32;
                mesh.hexes.push(hex);
                let outer = [
                    i == 0,
                    a == cells[0],
                    j == 0,
                    b == cells[1],
                    k == 0,
                    c == cells[2],
                ];
                for (side, _) in outer.iter().enumerate().filter(|(_, outer)| **outer) {
                    sides[side].push(Face {
                        nodes: SIDES[side].map(|n| hex[n]),
                        element,
                    });
                }
            }
        }
    }
    let elements = start..mesh.hexes.len();
    mesh.bodies.push(Body {
        name: name.to_string(),
        elements,
    });
    for (faces, side) in sides.into_iter().zip(["u-", "u+", "v-", "v+", "w-", "w+"]) {
        mesh.surfaces.push(Surface {
            name: format!("{name}_{side}"),
            faces,
        });
    }
}

/// A quarter of a block, 1 x 2 x 1, standing on a quarter of a plate, 2 x 3 x 1; origin at the
/// middle of the interface, node spacing uneven. Pressed down by 65 in all.
pub fn stack() -> Scene {
    let mut mesh = Mesh {
        source: "by hand".to_string(),
        ..Mesh::default()
    };
    let block: [&[f64]; 3] = [&[0.0, 0.25, 0.5], &[0.0, 0.2, 0.5, 1.0], &[0.0, 0.5, 1.0]];
    let plate: [&[f64]; 3] = [&[0.0, 0.4, 1.0], &[0.0, 0.7, 1.5], &[-1.0, -0.4, 0.0]];
    add_block(&mut mesh, "block", block, |p| p);
    add_block(&mut mesh, "plate", plate, |p| p);
    Scene {
        contacts: vec![ContactPair {
            name: "block-plate".to_string(),
            upper: Partner::Surface("block_w-".to_string()),
            lower: Partner::Surface("plate_w+".to_string()),
            carrier: Side::Upper,
            friction: 0.15,
            penalty_factor: 1.0,
            true_geometry: false,
        }],
        supports: vec![Support {
            name: "ground".to_string(),
            surface: "plate_w-".to_string(),
            components: [Some(0.0); 3],
            ..Support::default()
        }],
        rigid_planes: vec![RigidPlane {
            name: "top".to_string(),
            surface: "block_w+".to_string(),
            motion: [
                PlaneMotion::Held(0.0),
                PlaneMotion::Held(0.0),
                PlaneMotion::Driven(-65.0 / 4.0),
            ],
            ..RigidPlane::default()
        }],
        mirrors: vec![0, 1],
        ..Scene::bare("stack", mesh, STEEL)
    }
}

/// A state without stress and displacement in which the interface of [`stack`] carries 65 as an
/// even pressure, with a tangential traction of 0.1 of it along y.
pub fn pressed(scene: &Scene) -> State {
    let pressure = 65.0 / 2.0;
    let surface = scene.mesh.surface("block_w-").unwrap();
    let nodes = surface.nodes();
    let mut area = vec![0.0; nodes.len()];
    for face in &surface.faces {
        let corner = |i: usize| scene.mesh.points[face.nodes[i] as usize];
        let (a, b) = (corner(0), corner(2));
        for node in face.nodes {
            let i = nodes.binary_search(&node).unwrap();
            area[i] += 0.25 * ((a[0] - b[0]) * (a[1] - b[1])).abs();
        }
    }
    let n = nodes.len();
    let force = area
        .iter()
        .map(|a| [0.0, 0.1 * pressure * a, -pressure * a])
        .collect();
    let at = |node: &u32| [scene.mesh.points[*node as usize]; 2];
    let field = ContactField {
        acts_at: nodes.iter().map(at).collect(),
        nodes,
        pressure: vec![pressure; n],
        multiplier: vec![pressure; n],
        gap: vec![-1e-6; n],
        traction: vec![[0.0, 0.1 * pressure, 0.0]; n],
        slip: vec![0.0; n],
        status: vec![1; n],
        area,
        force,
        sagitta: vec![0.0; n],
        penetration: 1e-6,
        at_rim: 0.0,
        unexplained: 0.0,
        unexplained_at: None,
    };
    let elements = scene.mesh.hexes.len();
    State {
        time: 1.0,
        displacement: vec![[0.0; 3]; scene.mesh.points.len()],
        stress: vec![[[0.0; 6]; 8]; elements],
        peeq: vec![[0.0; 8]; elements],
        contacts: vec![field],
        planes: vec![PlaneField {
            travel: [0.0, 0.0, -0.01],
            force: [0.0, 0.0, -65.0 / 4.0],
            ..PlaneField::default()
        }],
        ..State::default()
    }
}

/// Fills the stress of a state with a field of position.
pub fn fill_stress(scene: &Scene, state: &mut State, stress: impl Fn([f64; 3]) -> [f64; 6]) {
    let rule = brinell::answer::results::hex::GaussRule::new();
    for (element, points) in state.stress.iter_mut().enumerate() {
        let corners = scene.mesh.corners(element);
        for (k, value) in points.iter_mut().enumerate() {
            *value = stress(rule.position(k, &corners));
        }
    }
}

/// The frame of lines along an axis.
pub fn along(scene: &Scene, axis: usize) -> LineFrame {
    LineFrame::of_axis(scene, axis).unwrap()
}

/// Are the values equal to a relative 1e-12?
#[track_caller]
pub fn close(a: f64, b: f64) {
    assert!(
        (a - b).abs() <= 1e-12 * a.abs().max(b.abs()).max(1e-3),
        "{a} is not {b}"
    );
}

/// Statuses and coefficients as the pressures have them: for pressures that a test has changed.
pub fn settle(field: &mut ContactField) {
    field.multiplier.clone_from(&field.pressure);
    let status = field.pressure.iter().map(|p| u8::from(*p > 0.0));
    field.status = status.collect();
}
