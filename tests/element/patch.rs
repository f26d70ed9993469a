//! The solid patch: seven distorted hexahedra in a unit cube under a linear displacement field.
//!
//! MacNeal and Harder, *A proposed standard set of problems to test finite element accuracy*,
//! Finite Elements in Analysis and Design 1 (1985) 3, section 5 and table 2.

use crate::kit;
use brinell::model::material::Steel;
use brinell::model::mesh::{Body, Face, Mesh, Surface, surface::faces_of};
use brinell::model::scene::{ElementKind, Scene, Support};

const INNER: [[f64; 3]; 8] = [
    [0.249, 0.342, 0.192],
    [0.826, 0.288, 0.288],
    [0.850, 0.649, 0.263],
    [0.273, 0.750, 0.230],
    [0.320, 0.186, 0.643],
    [0.677, 0.305, 0.683],
    [0.788, 0.693, 0.644],
    [0.165, 0.745, 0.702],
];

/// The cube's corners, then the inner nodes; one hexahedron inside, one on each of its faces.
fn mesh() -> Mesh {
    let mut points: Vec<[f64; 3]> = (0..8)
        .map(|c: i32| {
            let right = f64::from(u8::from([1, 2].contains(&(c % 4))));
            let back = f64::from(u8::from(c % 4 >= 2));
            [right, back, f64::from(u8::from(c >= 4))]
        })
        .collect();
    points.extend(INNER);
    let hexes = vec![
        [8, 9, 10, 11, 12, 13, 14, 15],
        [0, 1, 2, 3, 8, 9, 10, 11],
        [12, 13, 14, 15, 4, 5, 6, 7],
        [0, 1, 9, 8, 4, 5, 13, 12],
        [1, 2, 10, 9, 5, 6, 14, 13],
        [2, 3, 11, 10, 6, 7, 15, 14],
        [3, 0, 8, 11, 7, 4, 12, 15],
    ];
    let faces = hexes.iter().enumerate().flat_map(|(element, hex)| {
        let outer = faces_of(hex)
            .into_iter()
            .filter(|f| f.iter().all(|n| *n < 8));
        outer.map(move |nodes| Face {
            nodes,
            element: element as u32,
        })
    });
    let boundary = Surface {
        name: "boundary".into(),
        faces: faces.collect(),
    };
    Mesh {
        source: "patch".into(),
        points,
        bodies: vec![Body {
            name: "patch".into(),
            elements: 0..hexes.len(),
        }],
        hexes,
        surfaces: vec![boundary],
        ..Mesh::default()
    }
}

/// u = ½ 10⁻³ (2x + y + z), v = ½ 10⁻³ (x + 2y + z), w = ½ 10⁻³ (x + y + 2z) on the boundary.
fn patch(steel: Steel, kind: ElementKind) -> Scene {
    let mut scene = kit::scene(mesh(), steel, kind);
    scene.supports = vec![Support {
        name: "boundary".into(),
        surface: "boundary".into(),
        components: [Some(0.0); 3],
        gradient: [
            [1e-3, 0.5e-3, 0.5e-3],
            [0.5e-3, 1e-3, 0.5e-3],
            [0.5e-3, 0.5e-3, 1e-3],
        ],
    }];
    scene
}

/// Strains are 10⁻³ throughout, so that with E = 10⁶ and ν = 1/4 every normal stress is 2000 and
/// every shear stress 400.
#[test]
fn a_linear_field_is_exact_on_a_distorted_mesh() {
    for kind in kit::KINDS {
        let mut scene = patch(Steel::elastic(1e6, 0.25), kind);
        let state = kit::last(&mut scene);
        for stress in state.stress.iter().flatten() {
            for (i, s) in stress.iter().enumerate() {
                let exact = if i < 3 { 2000.0 } else { 400.0 };
                kit::close("stress", *s, exact, 1e-9);
            }
        }
        for (x, u) in scene.mesh.points.iter().zip(&state.displacement) {
            let sum = x[0] + x[1] + x[2];
            for i in 0..3 {
                assert!((u[i] - 0.5e-3 * (sum + x[i])).abs() < 1e-12);
            }
        }
    }
}

/// The same field in a steel that yields: one state of stress everywhere.
#[test]
fn a_linear_field_is_uniform_when_the_steel_flows() {
    let steel = Steel {
        youngs_modulus: 1e6,
        poissons_ratio: 0.25,
        yield_stress: 300.0,
        hardening_modulus: 1e4,
    };
    // Equal normal strains: only shear deviates, with a trial Mises stress of √(3 · 3 · 400²).
    let (shear, trial) = (4e5, 1200.0);
    let peeq = (trial - steel.yield_stress) / (3.0 * shear + steel.hardening_modulus);
    let tau = 400.0 * (steel.yield_stress + steel.hardening_modulus * peeq) / trial;
    for kind in kit::KINDS {
        let state = kit::last(&mut patch(steel, kind));
        for (stress, peeqs) in state.stress.iter().zip(&state.peeq) {
            for (stress, p) in stress.iter().zip(peeqs) {
                kit::close("PEEQ", *p, peeq, 1e-9);
                for (i, s) in stress.iter().enumerate() {
                    kit::close("stress", *s, if i < 3 { 2000.0 } else { tau }, 1e-9);
                }
            }
        }
    }
}
