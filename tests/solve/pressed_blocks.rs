//! Blocks that press on each other with all of their faces: what is said of loads, travels and steps.

use brinell::answer::Solved;
use brinell::answer::certify::Quantity;
use brinell::model::scene::{PlaneMotion, Step};
use brinell::prelude::{Axis, Block, Contact, Load, Scene, SceneBuilder, Steel, uniform};

const SIDE: f64 = 7.3;

fn block(name: &str, from: f64) -> Block<'_> {
    let across = || uniform(0.0, SIDE, 2);
    Block::new(name, across(), across(), uniform(from, from + SIDE, 2))
}

/// One on the other, held so that neither slides away.
fn two(steel: Steel) -> SceneBuilder {
    SceneBuilder::new("two")
        .body(block("lo", -SIDE), steel)
        .body(block("up", 0.0), steel)
        .contact(Contact::between("up_z_min", "lo_z_max"))
        .hold("lo_z_min", Axis::Z)
        .hold("lo_x_min", Axis::X)
        .hold("lo_y_min", Axis::Y)
        .hold("up_x_min", Axis::X)
        .hold("up_y_min", Axis::Y)
}

/// One on the other, held by friction.
fn rough() -> SceneBuilder {
    SceneBuilder::new("rough")
        .body(block("lo", -SIDE), Steel::elastic(210e3, 0.3))
        .body(block("up", 0.0), Steel::elastic(210e3, 0.3))
        .contact(Contact::between("up_z_min", "lo_z_max").friction(0.5))
        .fix("lo_z_min")
}

fn solved(scene: Scene) -> Solved {
    Solved::of(scene).expect("converges")
}

/// A support along x is no plane of symmetry there: 100 MPa on 7.3 mm are 730 N/mm.
#[test]
fn a_block_that_is_held_is_not_the_half_of_another() {
    let load = Load::pressure("up_z_max", 100.0);
    let scene = two(Steel::elastic(210e3, 0.3)).load(load).build();
    let solved = solved(scene.expect("a scene"));
    let line = solved.figure(Quantity::LineLoad, "up_z_min-lo_z_max");
    let line = line.expect("a line").value;
    assert!((line - 730.0).abs() < 1e-6 * 730.0, "{line}");
}

/// The travel along the load of two planes that are moved differently is a mean of both, by forces that the mesh finds; that of one
/// is known.
#[test]
fn a_mean_of_prescribed_travels_has_no_bar_of_nothing() {
    let bar = |sideways: f64| {
        let moved = [sideways, 0.0, -0.01].map(PlaneMotion::Held);
        let scene = rough().load(Load::plane("up_z_max", moved));
        let solved = solved(scene.build().expect("a scene"));
        let travel = solved.figure(Quantity::Descent, "overall");
        travel.expect("travels").bar()
    };
    assert!(bar(0.0).is_some_and(|bar| bar < 1e-9));
    assert_eq!(bar(1e-4), None);
}

/// Pressed together, and let back a little: no unloading, however small the increments are and however many iterations they take.
#[test]
fn what_goes_back_a_little_is_no_unloading_that_may_be_left_undone() {
    let certain = |ends: &[f64]| {
        let moved = [
            PlaneMotion::Free,
            PlaneMotion::Free,
            PlaneMotion::Held(-0.01),
        ];
        let mut scene = two(Steel::elastic(210e3, 0.3))
            .load(Load::plane("up_z_max", moved))
            .build()
            .expect("a scene");
        scene.steps = ends.iter().map(|end| Step::to("step", *end)).collect();
        (scene.before_unloading(), scene.before_certain_unloading())
    };
    assert_eq!(certain(&[1.0, 0.95]), (Some(0), None));
    assert_eq!(certain(&[1.0, 0.02]), (Some(0), Some(0)));
    assert_eq!(certain(&[1.0, 1.1]), (None, None));
}

/// A top that is held across takes its part of a load that leans: no interface need carry it.
#[test]
fn a_load_that_a_held_top_shares_is_missed_by_no_interface() {
    let top = [
        PlaneMotion::Held(0.0),
        PlaneMotion::Held(0.0),
        PlaneMotion::Driven(-5000.0),
    ];
    let balance = |push: f64| {
        let scene = rough()
            .load(Load::plane("up_z_max", top))
            .load(Load::traction("up_x_max", [push, 0.0, 0.0]))
            .build();
        solved(scene.expect("a scene")).answer.checks.force_balance
    };
    assert!(balance(0.0).expect("all passes") < 1e-9);
    assert_eq!(balance(20.0), None);
}
