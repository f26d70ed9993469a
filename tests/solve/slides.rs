//! A roller that slides over a block by nearly the half-width of its contact: what it presses with does not change, nor does
//! the slide count as penetration.

use brinell::answer::results::interface::interfaces;
use brinell::model::scene::PlaneMotion;
use brinell::prelude::{
    Axis, Block, Contact, Cylinder, Grading, Load, SceneBuilder, Steel, uniform,
};
use brinell::solver::solve::{Silent, solve};

const RADIUS: f64 = 10.0;
/// N, mm.
const HALF_WIDTH: f64 = 0.4;
/// Plane strain: q = π a² E / (8 R (1 − ν²)) of two alike bodies (Johnson, Contact Mechanics, (4.43)).
const LOAD: f64 = 0.125 * std::f64::consts::PI * HALF_WIDTH * HALF_WIDTH * 210e3 / (RADIUS * 0.91);

/// Largest pressure, and what of the penetration the facets do not explain, after a slide by `slide`.
fn pressed(slide: f64) -> (f64, f64) {
    let steel = || Steel::elastic(210e3, 0.3);
    let size = HALF_WIDTH / 4.0;
    let roller = Cylinder::half("roller", RADIUS, 1.0).fine(size, 0.8);
    let one = Grading::new(size, 0.8, RADIUS, 1.4).nodes(1);
    let both = (one.iter().rev().map(|x| -x))
        .chain(one.iter().skip(1).copied())
        .collect();
    let deep = one.iter().rev().map(|y| -y).collect();
    let motion = [
        PlaneMotion::Held(slide),
        PlaneMotion::Driven(-LOAD),
        PlaneMotion::Held(0.0),
    ];
    let mut scene = SceneBuilder::new("slides")
        .body(roller, steel())
        .body(
            Block::new("block", both, deep, uniform(0.0, 1.0, 1)),
            steel(),
        )
        .contact(Contact::between("roller_contact", "block_y_max").named("contact"))
        .fix("block_y_min")
        .load(Load::plane("roller_top", motion))
        .plane_strain(Axis::Z)
        .build()
        .unwrap();
    let state = solve(&mut scene, &mut Silent).expect("converges").last;
    let [contact] = interfaces(&scene, &state).try_into().expect("one");
    (contact.max_pressure, contact.unexplained_penetration)
}

#[test]
fn a_slide_over_a_flat_side_is_no_penetration() {
    let (still, none) = pressed(0.0);
    let (slid, beyond) = pressed(0.3);
    assert_eq!(none, 0.0);
    assert_eq!(beyond, 0.0);
    assert!((slid / still - 1.0).abs() < 1e-6, "{slid} {still}");
}
