//! A soft lining, one element thick, between two plates that it adheres to.

use brinell::answer::Solved;
use brinell::answer::certify::Quantity;
use brinell::model::scene::PlaneMotion;
use brinell::prelude::{Axis, Block, Load, SceneBuilder, Steel, uniform};

/// The travel of its upper plate, with its error, on a mesh of so many elements along half of it and across it.
fn travel(
    (half_length, poissons_ratio): (f64, f64),
    [along, across]: [usize; 2],
) -> (f64, Option<f64>) {
    let lining = Block::new(
        "lining",
        uniform(0.0, half_length, along),
        uniform(0.0, 1.0, 1),
        uniform(0.0, 1.0, across),
    );
    let pressed = [
        PlaneMotion::Held(0.0),
        PlaneMotion::Free,
        PlaneMotion::Driven(-20.0),
    ];
    let steel = Steel::elastic(800.0, poissons_ratio);
    let scene = SceneBuilder::new("lining")
        .body(lining.build().expect("a block"), steel)
        .fix("z_min")
        .load(Load::plane("z_max", pressed))
        .mirror(Axis::X)
        .plane_strain(Axis::Y)
        .build()
        .expect("a scene");
    let solved = Solved::of(scene).expect("converges");
    let descent = solved.figure(Quantity::Descent, "overall");
    let descent = descent.expect("travels");
    (descent.value, descent.error.total())
}

/// What flows out between both plates shears, more at either of them than in the middle: one element does not, and is too stiff, by 2 %
/// where the lining is long and may be pressed together, up to several times where not. Its claim knows.
#[test]
fn the_travel_of_a_lining_of_one_element_is_claimed_with_what_flows_out() {
    for half_length in [2.0, 6.0] {
        for poissons_ratio in [0.3, 0.4, 0.49] {
            let lining = (half_length, poissons_ratio);
            let (fine, at_most) = travel(lining, [96, 16]);
            let at_most = at_most.expect("is resolved");
            assert!(at_most < 0.02 * fine, "{fine} {at_most}");
            let (value, error) = travel(lining, [12, 1]);
            let holds = error.is_none_or(|error| (value - fine).abs() < error + at_most);
            assert!(holds, "{lining:?}: {value} {error:?} {fine}");
            let wide = error.is_none_or(|error| error > 0.2 * fine);
            assert!(
                !wide || poissons_ratio > 0.45,
                "{lining:?}: {error:?} {fine}"
            );
        }
    }
}
