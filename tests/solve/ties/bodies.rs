//! Bodies of several parts behave as one.

use super::*;
use std::f64::consts::FRAC_PI_2;

/// A quarter of a tube from 1 to 2, meshed as two shells that meet at 1.4; `n` elements around the inner one.
fn shells(n: usize) -> SceneBuilder {
    let height = || uniform(0.0, 0.2, 1);
    let shell = |name, radii, around| {
        Block::new(name, radii, uniform(0.0, FRAC_PI_2, around), height()).mapped(cylindrical)
    };
    let inner = shell("inner", uniform(1.0, 1.4, n / 3), n);
    let outer = shell("outer", uniform(1.4, 2.0, n / 3), 3 * n / 4);
    SceneBuilder::new("tube")
        .body(inner, steel())
        .body(outer, steel())
        .tie(Tie::between("inner_x_max", "outer_x_min"))
        .controls(|c| c.residual = 1e-12)
}

#[test]
fn round_shells_that_turn_as_one_are_free_of_stress() {
    let angle = 1e-3;
    for turn in [
        [[0.0, -angle, 0.0], [angle, 0.0, 0.0], [0.0; 3]],
        [[0.0, 0.0, angle], [0.0; 3], [-angle, 0.0, 0.0]],
    ] {
        let scene = shells(12).support(Support {
            gradient: turn,
            ..linear("outer_x_max")
        });
        let solved = Solved::of(scene.build().unwrap()).unwrap();
        let stress = solved.state().stress.iter().flatten().flatten();
        let most = stress.fold(0.0f64, |most, s| most.max(s.abs()));
        assert!(most < 1e-10 * E * angle, "{most:e}");
    }
}

#[test]
fn a_tube_of_two_shells_tends_to_lames_with_the_second_order() {
    let error = |n| {
        let scene = shells(n)
            .mirror(Axis::X)
            .mirror(Axis::Y)
            .plane_strain(Axis::Z)
            .load(Load::pressure("inner_x_min", 100.0));
        let solved = Solved::of(scene.build().unwrap()).unwrap();
        off_lame(&solved, "inner_x_min")
    };
    let [coarse, fine] = [12, 24].map(error);
    let order = (coarse / fine).log2();
    assert!(
        order > 1.8 && fine < 2e-3,
        "{coarse:e} {fine:e}: order {order}"
    );
}

/// A beam along x, 4 long, bent by a force at its end; in one part, or in two that meet at 1.7.
fn beam(parts: usize, change: impl FnOnce(SceneBuilder) -> SceneBuilder) -> Solved {
    let section = |n| uniform(-0.25, 0.25, n);
    let scene = SceneBuilder::new("beam").controls(|c| {
        c.element = ElementKind::Enhanced;
        c.residual = 1e-10;
    });
    let scene = match parts {
        1 => {
            let one = Block::new("end", uniform(0.0, 4.0, 32), section(4), section(4));
            scene.body(one, steel()).fix("end_x_min")
        }
        _ => {
            let root = Block::new("root", uniform(0.0, 1.7, 14), section(4), section(4));
            let end = Block::new("end", uniform(1.7, 4.0, 15), section(3), section(3));
            scene
                .body(root, steel())
                .body(end, steel())
                .tie(Tie::between("root_x_max", "end_x_min"))
                .fix("root_x_min")
        }
    };
    let scene = scene.load(Load::force("end_x_max", [0.0, 0.0, -10.0]));
    Solved::of(change(scene).build().unwrap()).unwrap()
}

fn tip(solved: &Solved) -> f64 {
    solved.travel_of("end_x_max", solved.state())[2]
}

#[test]
fn a_beam_of_two_parts_bends_as_one() {
    let (one, two) = (beam(1, |s| s), beam(2, |s| s));
    let ratio = tip(&two) / tip(&one);
    // What the coarser half bends more by.
    assert!((ratio - 1.0).abs() < 2e-3, "{ratio}");
    let force = two.answer.ties.0[0].1.force;
    assert!(
        force[0].abs() < 1e-6 && (force[2] - 10.0).abs() < 1e-6,
        "{force:?}"
    );
}

#[test]
fn the_answer_depends_neither_on_threads_nor_on_the_linear_solver() {
    let whole = beam(2, |s| s);
    let pool = |n| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(n)
            .build()
            .unwrap()
    };
    let same = |other: &Solved, within: f64| {
        let ratio = tip(other) / tip(&whole);
        assert!((ratio - 1.0).abs() < within, "{ratio}");
    };
    same(&pool(1).install(|| beam(2, |s| s)), 1e-9);
    same(&pool(3).install(|| beam(2, |s| s)), 1e-9);
    let divided = |s: SceneBuilder| s.controls(|c| c.solver = SolverKind::Divided);
    same(&beam(2, divided), 1e-6);
}

#[test]
fn a_scene_in_another_position_has_the_same_answer() {
    let sides = |n| uniform(0.0, 1.0, n);
    let turned = |p: [f64; 3]| [p[2], p[0], p[1]];
    let of = |map: fn([f64; 3]) -> [f64; 3], swap: bool, force: [f64; 3]| {
        let mut bodies = vec![
            Block::new("a", sides(3), sides(3), sides(3)),
            Block::new("b", sides(4), sides(4), uniform(1.0, 2.0, 3)),
        ];
        if swap {
            bodies.reverse();
        }
        let mut scene = SceneBuilder::new("cubes");
        for body in bodies {
            scene = scene.body(body.mapped(map), steel());
        }
        let scene = scene
            .tie(Tie::between("a_z_max", "b_z_min"))
            .fix("a_z_min")
            .load(Load::force("b_z_max", force));
        let solved = Solved::of(scene.build().unwrap()).unwrap();
        solved.travel_of("b_z_max", solved.state())
    };
    let first = of(|p| p, false, [1.0, 2.0, 3.0]);
    let second = of(turned, true, turned([1.0, 2.0, 3.0]));
    for (a, b) in turned(first).into_iter().zip(second) {
        assert!((a / b - 1.0).abs() < 1e-9, "{first:?} {second:?}");
    }
}

#[test]
fn a_distance_that_is_bridged_lets_bodies_turn_as_one() {
    let side = |n| uniform(0.0, 1.0, n);
    let angle = 1e-3;
    let scene = SceneBuilder::new("bridged")
        .body(Block::new("a", side(3), side(3), side(2)), steel())
        .body(
            Block::new("b", side(4), side(4), uniform(1.2, 2.0, 2)),
            steel(),
        )
        .tie(Tie::between("a_z_max", "b_z_min").within(0.25))
        .support(Support {
            gradient: [[0.0, 0.0, angle], [0.0; 3], [-angle, 0.0, 0.0]],
            ..linear("a_z_min")
        });
    let solved = Solved::of(scene.build().unwrap()).unwrap();
    let stress = solved.state().stress.iter().flatten().flatten();
    let most = stress.fold(0.0f64, |most, s| most.max(s.abs()));
    assert!(most < 1e-10 * E * angle, "{most:e}");
    assert!((solved.state().ties[0].distance - 0.2).abs() < 1e-12);
}
