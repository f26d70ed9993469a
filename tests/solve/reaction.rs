//! The force of a plane whose motion is prescribed.

use super::kit::{held, scene};
use brinell::answer::results::load::applied;
use brinell::model::builder::{Load, SceneBuilder};
use brinell::model::material::Steel;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::{
    Controls, ElementKind, PlaneMotion, RigidPlane, Scene, Tie, Traction, TractionValue,
};
use brinell::solver::solve::{Silent, solve};

/// A bar of 2 × 3 × 1 pressed along z by `squeeze`, free to widen.
fn pressed(element: ElementKind, squeeze: f64, hardening: f64) -> (Scene, [f64; 3], f64) {
    let mesh = Block::new(
        "bar",
        uniform(0.0, 2.0, 2),
        uniform(0.0, 3.0, 3),
        uniform(0.0, 1.0, 2),
    )
    .build()
    .unwrap();
    let steel = Steel {
        youngs_modulus: 1000.0,
        poissons_ratio: 0.3,
        yield_stress: 1.0,
        hardening_modulus: hardening,
    };
    let mut scene = Scene {
        supports: vec![held("x_min", 0), held("y_min", 1), held("z_min", 2)],
        rigid_planes: vec![RigidPlane {
            name: "press".into(),
            surface: "z_max".into(),
            motion: [
                PlaneMotion::Free,
                PlaneMotion::Free,
                PlaneMotion::Held(-squeeze),
            ],
            ..RigidPlane::default()
        }],
        controls: Controls {
            element,
            ..Controls::default()
        },
        ..scene(mesh, steel)
    };
    let solution = solve(&mut scene, &mut Silent).unwrap();
    let load = applied(&scene, &solution.last);
    (scene, solution.last.planes[0].force, load)
}

#[test]
fn a_moved_plane_carries_its_reaction() {
    let hardening = 10.0;
    let tangent = 1000.0 * hardening / (1000.0 + hardening);
    // Elastic, and ten times beyond yield.
    for (squeeze, stress) in [(5e-4, 0.5), (1e-2, 1.0 + tangent * (1e-2 - 1e-3))] {
        for element in [ElementKind::Bbar, ElementKind::Enhanced] {
            let (_, force, load) = pressed(element, squeeze, hardening);
            // Forces balance to 1e-8 of those of an elastic bar, ten times as large.
            assert!((force[2] / (-6.0 * stress) - 1.0).abs() < 1e-7, "{force:?}");
            assert_eq!(force[..2], [0.0, 0.0]);
            assert_eq!(load, -force[2]);
        }
    }
}

/// Beside a pressure on its own surface it bears what is left of the stress of the bar.
#[test]
fn a_pressure_on_a_plane_goes_not_through_it() {
    let (mut scene, alone, _) = pressed(ElementKind::Bbar, 5e-4, 10.0);
    scene.tractions = vec![Traction {
        name: "pressure".into(),
        surface: "z_max".into(),
        value: TractionValue::Pressure(0.2),
    }];
    let state = solve(&mut scene, &mut Silent).unwrap().last;
    let force = state.planes[0].force[2];
    assert!((force - alone[2] - 0.2 * 6.0).abs() < 1e-6, "{force}");
}

/// The upper block hangs on the nodes of the plane by a tie.
#[test]
fn a_plane_bears_what_ties_hand_on_to_its_nodes() {
    let side = |n| uniform(0.0, 1.0, n);
    let block = |name, n, from| Block::new(name, side(n), side(n), uniform(from, from + 1.0, 2));
    let steel = Steel::elastic(1000.0, 0.0);
    let held = PlaneMotion::Held(0.0);
    let mut scene = SceneBuilder::new("tied")
        .body(block("lower", 2, 0.0), steel)
        .body(block("upper", 3, 1.0), steel)
        .tie(Tie::between("lower_z_max", "upper_z_min"))
        .fix("lower_z_min")
        .load(Load::plane(
            "lower_z_max",
            [PlaneMotion::Free, PlaneMotion::Free, held],
        ))
        .load(Load::pressure("upper_z_max", 0.5))
        .build()
        .unwrap();
    let state = solve(&mut scene, &mut Silent).unwrap().last;
    let force = state.planes[0].force;
    assert!((force[2] - 0.5).abs() < 1e-7, "{force:?}");
}
