//! Two rings, one on the other, in contact by the whole of their outer faces.

use brinell::answer::results::interface::interfaces;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::cylindrical;
use brinell::prelude::{Axis, Block, Contact, SceneBuilder, Steel, uniform};
use brinell::solver::solve::{Silent, solve};
use std::f64::consts::FRAC_PI_2;

/// mm.
const INNER: f64 = 5.0;
const OUTER: f64 = 10.0;
const GAP: f64 = 0.001;

/// Half of a ring about (0, `middle`), x >= 0; `near` is its outer face towards y = 0.
fn ring(name: &'static str, middle: f64) -> Mesh {
    let quarter = |from: f64| uniform(from, from + FRAC_PI_2, 12);
    let around = quarter(-FRAC_PI_2)
        .into_iter()
        .chain(quarter(0.0).into_iter().skip(1));
    let block = Block::new(
        name,
        uniform(INNER, OUTER, 4),
        around.collect(),
        uniform(0.0, 1.0, 1),
    );
    let mut mesh = block
        .mapped(move |at| {
            let [x, y, z] = cylindrical(at);
            [x, y + middle, z]
        })
        .build()
        .expect("a ring");
    let is_near =
        move |[x, y, _]: [f64; 3]| x.hypot(y - middle) > 0.95 * OUTER && y.abs() < middle.abs();
    mesh.mark("near", name, is_near);
    mesh.prefixed(&format!("{name}_"))
}

/// The force between them, the lower bore held, the upper one pressed down; by outer faces of those names.
fn force(face: &str) -> f64 {
    let middle = OUTER + 0.5 * GAP;
    let mut scene = SceneBuilder::new("stacked")
        .body(ring("upper", middle), Steel::elastic(210e3, 0.3))
        .body(ring("lower", -middle), Steel::elastic(210e3, 0.3))
        .contact(
            Contact::between(&format!("upper_{face}"), &format!("lower_{face}")).named("touch"),
        )
        .fix("lower_x_min")
        .displace("upper_x_min", [Some(0.0), Some(-0.1), Some(0.0)])
        .mirror(Axis::X)
        .plane_strain(Axis::Z)
        .build()
        .expect("a scene");
    let state = solve(&mut scene, &mut Silent).expect("converges").last;
    interfaces(&scene, &state)[0].normal_force
}

/// The far sides of both face each other, too, through both rings: they are no overlap of 40 mm.
#[test]
fn whole_faces_press_as_the_sides_that_meet_do() {
    let [whole, near] = ["x_max", "near"].map(force);
    assert!((whole / near - 1.0).abs() < 1e-9, "{whole} {near}");
    assert!(near > 0.0);
}
