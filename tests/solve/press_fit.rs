//! A pin that is pressed into its hole, and carries next to nothing.

use brinell::answer::results::interface::interfaces;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::cylindrical;
use brinell::model::scene::PlaneMotion;
use brinell::prelude::{Axis, Block, Contact, Load, SceneBuilder, Steel, uniform};
use brinell::solver::solve::{Silent, solve};
use std::f64::consts::FRAC_PI_2;

/// Radius of the hole, and by how much that of the pin is larger, mm.
const FIT: f64 = 10.0;
const OVERLAP: f64 = 0.01;

/// Half of a ring, x >= 0.
fn ring(name: &'static str, [inner, outer]: [f64; 2], cells: usize) -> Mesh {
    let block = Block::new(
        name,
        uniform(inner, outer, 4),
        uniform(-FRAC_PI_2, FRAC_PI_2, cells),
        uniform(0.0, 1.0, 1),
    );
    let mesh = block.mapped(cylindrical).build().expect("a ring");
    mesh.prefixed(&format!("{name}_"))
}

/// Mean pressure of the fit, whose pin is moved by `motion` at its bore.
fn pressure(friction: f64, motion: PlaneMotion) -> f64 {
    let pin = ring("pin", [4.0, FIT + OVERLAP], 14);
    let hub = ring("hub", [FIT, 20.0], 16);
    let bore = [PlaneMotion::Held(0.0), motion, PlaneMotion::Free];
    let mut scene = SceneBuilder::new("press fit")
        .body(pin, Steel::elastic(210e3, 0.3))
        .body(hub, Steel::elastic(210e3, 0.3))
        .contact(Contact::between("pin_x_max", "hub_x_min").friction(friction))
        .fix("hub_x_max")
        .load(Load::plane("pin_x_min", bore))
        .mirror(Axis::X)
        .plane_strain(Axis::Z)
        .build()
        .expect("a scene");
    let state = solve(&mut scene, &mut Silent).expect("converges").last;
    let fit = &interfaces(&scene, &state)[0];
    fit.pressure_integral / fit.area
}

/// What overlaps all round is not moved until one side only touches: with friction the pin would stay there.
#[test]
fn a_pin_stays_in_the_middle_of_its_hole() {
    for friction in [0.0, 0.2] {
        let held = pressure(friction, PlaneMotion::Held(0.0));
        let loaded = pressure(friction, PlaneMotion::Driven(-1.0));
        assert!((loaded / held - 1.0).abs() < 0.01, "{loaded} {held}");
    }
}
