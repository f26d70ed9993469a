//! Elements that are split beside others that stay whole.

use crate::ties::{GRADIENT, deviation, linear, steel, tilted};
use brinell::prelude::*;
use brinell::proof::verify::kit::split_anywhere;
use brinell::proof::verify::stream::Stream;
use std::f64::consts::FRAC_PI_2;

/// A block of 4 x 4 x 3 elements that are no parallelepipeds, some of them split.
fn refined(marked: impl Fn(usize) -> bool) -> Scene {
    let bent = |p: [f64; 3]| {
        let [x, y, z] = p;
        let wave = |a: f64, b: f64, c: f64| 0.1 * a * (1.0 - a) * (1.0 + b - c);
        tilted([x + wave(x, y, z), y + wave(y, z, x), z + wave(z, x, y)])
    };
    let side = |n| uniform(0.0, 1.0, n);
    let block = Block::new("block", side(4), side(4), side(3)).mapped(bent);
    let mut scene = SceneBuilder::new("block").body(block, steel());
    for side in ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"] {
        scene = scene.support(linear(&format!("block_{side}")));
    }
    let mut scene = scene.controls(|c| c.residual = 1e-12).build().unwrap();
    let fine = scene.mesh.split_some(|e| [marked(e); 3]).unwrap();
    scene.mesh = fine.mesh;
    scene
}

#[test]
fn a_uniform_stress_passes_from_split_elements_to_whole_ones() {
    for (name, marked) in [
        (
            "one inside",
            &(|e: usize| e == 21) as &dyn Fn(usize) -> bool,
        ),
        ("a corner", &|e: usize| e < 2 || e == 4),
        ("a chequerboard", &|e: usize| {
            (e % 4 + e / 4 % 4 + e / 16).is_multiple_of(2)
        }),
        ("a half", &|e: usize| e % 4 < 2),
    ] {
        let scene = refined(marked);
        assert!(!scene.mesh.hanging.is_empty());
        let solved = Solved::of(scene).unwrap();
        let off = deviation(solved.state());
        assert!(off < 1e-10, "{name}: {off:e}");
        // Displacements, too, of hanging nodes and others.
        let (points, u) = (&solved.scene.mesh.points, &solved.state().displacement);
        for (x, u) in points.iter().zip(u) {
            for i in 0..3 {
                let exact: f64 = (0..3).map(|j| GRADIENT[i][j] * x[j]).sum();
                assert!((u[i] - exact).abs() < 1e-12, "{name}");
            }
        }
    }
}

#[test]
fn a_uniform_stress_passes_whatever_elements_are_split_in_whatever_directions() {
    let mut stream = Stream::new(1, 0);
    for drawn in 0..12 {
        let mut scene = refined(|_| false);
        scene.mesh = split_anywhere(scene.mesh, 4, 16.0, &mut stream).unwrap();
        assert!(scene.mesh.hanging.len() > 100);
        let solved = Solved::of(scene).unwrap();
        let off = deviation(solved.state());
        assert!(off < 1e-10, "{drawn}: {off:e}");
    }
}

#[test]
fn a_uniform_pressure_passes_whatever_elements_are_split_in_whatever_directions() {
    let mut stream = Stream::new(1, 0);
    for drawn in 0..12 {
        let carrier = [Side::Upper, Side::Lower][drawn % 2];
        let (mut scene, _) = pressed_blocks(carrier, [0, 0]);
        scene.mesh = split_anywhere(scene.mesh, 3, 12.0, &mut stream).unwrap();
        assert_uniform(scene, &drawn.to_string());
    }
}

/// A quarter of a tube from 1 to 2 under pressure, plane strain; elements that begin within `split` of the axis are split.
fn tube(split: f64) -> (f64, usize) {
    let radii = uniform(1.0, 2.0, 6);
    let block = Block::new(
        "tube",
        radii,
        uniform(0.0, FRAC_PI_2, 10),
        uniform(0.0, 0.2, 1),
    );
    let mut scene = SceneBuilder::new("tube")
        .body(block.mapped(cylindrical), steel())
        .mirror(Axis::X)
        .mirror(Axis::Y)
        .plane_strain(Axis::Z)
        .load(Load::pressure("tube_x_min", 100.0))
        .controls(|c| c.residual = 1e-11)
        .build()
        .unwrap();
    let mesh = scene.mesh.clone();
    let near = |e: usize| {
        let radius = mesh.corners(e).map(|p| p[0].hypot(p[1]));
        radius.into_iter().fold(f64::INFINITY, f64::min) < split
    };
    let fine = mesh.split_some(|e| [near(e); 3]).unwrap();
    scene.mesh = fine.mesh;
    let solved = Solved::of(scene).unwrap();
    let mesh = &solved.scene.mesh;
    let nodes = mesh.surface("tube_x_min").unwrap().nodes();
    for node in nodes {
        let [x, y, _] = mesh.points[node as usize];
        // New nodes are on the true bore.
        assert!((x.hypot(y) - 1.0).abs() < 1e-9, "{}", x.hypot(y));
    }
    let off = crate::ties::off_lame(&solved, "tube_x_min");
    (off, mesh.hexes.len())
}

#[test]
fn a_tube_that_is_split_near_its_bore_is_as_good_as_one_that_is_split_throughout() {
    let [(coarse, _), (near, some), (fine, all)] = [0.0, 1.4, 3.0].map(tube);
    assert!(
        some < all && near < 0.5 * coarse && near < 2.0 * fine,
        "{coarse:e} {near:e} {fine:e}"
    );
}

/// Two blocks of different steel under a uniform pressure, elements at their contact split once or twice: the pressure is
/// uniform, and no other stress appears.
#[test]
fn a_uniform_pressure_passes_where_elements_at_the_contact_are_split() {
    for carrier in [Side::Upper, Side::Lower] {
        for (upper, lower) in [(1, 0), (0, 1), (2, 0), (0, 2), (2, 1)] {
            let (scene, hanging) = pressed_blocks(carrier, [lower, upper]);
            assert!(hanging > 0);
            assert_uniform(scene, &format!("{carrier:?} {upper} {lower}"));
        }
    }
}

/// A pressure of 2, and a stress of -2 along z alone.
fn assert_uniform(scene: Scene, name: &str) {
    let solved = Solved::of(scene).unwrap();
    let state = solved.state();
    for stress in state.stress.as_flattened() {
        let [x, y, z, xy, yz, zx] = *stress;
        let other = [x, y, xy, yz, zx];
        let off = other
            .iter()
            .fold((z + 2.0).abs(), |off, s| off.max(s.abs()));
        assert!(off < 2e-8, "{name}: {off:e}");
    }
    for pressure in &state.contacts[0].pressure {
        assert!((pressure - 2.0).abs() < 2e-8, "{name}: {pressure}");
    }
}

/// The blocks, lower and upper, with so many splits of what is near one corner of the contact.
fn pressed_blocks(carrier: Side, splits: [usize; 2]) -> (Scene, usize) {
    let side = |n| uniform(0.0, 1.0, n);
    let lower = Block::new("lower", side(4), side(3), uniform(-1.0, 0.0, 2));
    let upper = Block::new("upper", side(3), side(5), uniform(0.0, 1.0, 2));
    let contact = Contact::between("upper_z_min", "lower_z_max").carried_by(carrier);
    let mut scene = SceneBuilder::new("blocks")
        .body(lower, Steel::elastic(1000.0, 0.3))
        .body(upper, Steel::elastic(3000.0, 0.2))
        .contact(contact)
        .hold("lower_x_min", Axis::X)
        .hold("upper_x_min", Axis::X)
        .hold("lower_y_min", Axis::Y)
        .hold("upper_y_min", Axis::Y)
        .hold("lower_z_min", Axis::Z)
        .load(Load::pressure("upper_z_max", 2.0))
        .controls(|c| (c.residual, c.penetration) = (1e-12, 1e-11))
        .build()
        .unwrap();
    for (body, count) in splits.into_iter().enumerate() {
        for level in 0..count {
            let mesh = &scene.mesh;
            let near = |e: usize| {
                let inside = mesh.bodies[body].elements.contains(&e);
                let close =
                    |p: &[f64; 3]| p[0].hypot(p[1] - 0.4).hypot(p[2]) < 0.4 / (1 + level) as f64;
                [inside && mesh.corners(e).iter().any(close); 3]
            };
            scene.mesh = mesh.split_some(near).unwrap().mesh;
        }
    }
    let hanging = scene.mesh.hanging.len();
    (scene, hanging)
}

/// Problem H on a mesh of two elements across the half-width a, which are split along x and y within three a of the
/// middle, and twice again up to the edge of the strip: as good as the best graded mesh, with less than half of its nodes.
#[test]
fn problem_h_split_near_the_strip_needs_half_of_the_nodes_of_a_graded_mesh() {
    use brinell::model::mesh::family::problem_h::{self, HALF_WIDTH, Sizes};
    let sizes = |across, growth| Sizes {
        across,
        growth,
        parts: 1,
    };
    let graded = problem_h::half(&sizes(15, 1.7)).unwrap();
    let mut mesh = problem_h::half(&sizes(2, 1.6)).unwrap();
    for reach in [3.0, 1.1, 1.05] {
        let near = |e: usize| {
            let corners = mesh.corners(e);
            let near = (corners.iter()).any(|p| p[0].hypot(p[1]) < reach * HALF_WIDTH);
            // In the plane, whichever of its own directions that are.
            [1, 3, 4].map(|end| near && (corners[end][2] - corners[0][2]).abs() < 1e-12)
        };
        mesh = mesh.split_some(near).unwrap().mesh;
    }
    let moving = mesh.points.len() - mesh.hanging.len();
    assert!(2 * moving < graded.points.len(), "{moving}");
    for mesh in [graded, mesh] {
        within_three_per_mille(mesh);
    }
}

/// The largest pressure, the half-width and the largest Mises stresses of both bodies.
fn within_three_per_mille(mesh: Mesh) {
    use brinell::product::converge::problem_h as h;
    let mut scene = h::case().unwrap().scene(mesh).unwrap();
    scene.controls.element = ElementKind::Enhanced;
    let solved = Solved::of(scene).unwrap();
    let read = h::read(&solved.scene, solved.state()).unwrap();
    for (name, value, limit) in [
        ("p0", read.pressure, h::PRESSURE),
        ("half-width", read.half_width, h::HALF_WIDTH),
        ("centroid, block", read.block.centroid, h::MISES_BLOCK),
        (
            "centroid, cylinder",
            read.cylinder.centroid,
            h::MISES_CYLINDER,
        ),
        ("nodal, block", read.block.nodal, h::MISES_BLOCK),
        ("nodal, cylinder", read.cylinder.nodal, h::MISES_CYLINDER),
    ] {
        assert!(
            (value / limit - 1.0).abs() < 3e-3,
            "{name}: {value} {limit}"
        );
    }
}
