//! The force of a plane whose motion is prescribed.

use super::kit::{held, scene};
use brinell::answer::results::load::{along, applied, descent};
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

/// Two planes that share an edge: what acts on its nodes counts once, so that their forces are those of the bar.
#[test]
fn planes_with_nodes_in_common_share_what_acts_there() {
    let grid = |length: f64| uniform(0.0, length, 2);
    let bar = Block::new("bar", grid(2.0), grid(3.0), grid(1.0));
    let mut mesh = bar.build().unwrap();
    mesh.mark_all("left", |p| p[2] == 1.0 && p[0] <= 1.0);
    mesh.mark_all("right", |p| p[2] == 1.0 && p[0] >= 1.0);
    let steel = Steel {
        youngs_modulus: 1000.0,
        poissons_ratio: 0.3,
        yield_stress: f64::INFINITY,
        hardening_modulus: 0.0,
    };
    let (free, held_by) = (PlaneMotion::Free, PlaneMotion::Held);
    let plane = |surface: &str, motion| RigidPlane {
        name: surface.into(),
        surface: surface.into(),
        motion,
        ..RigidPlane::default()
    };
    let mut scene = Scene {
        supports: vec![held("y_min", 1)],
        rigid_planes: vec![
            plane("left", [free, free, held_by(-1e-3)]),
            plane("right", [free, free, held_by(-1e-3)]),
            plane("z_min", [held_by(0.0), free, held_by(0.0)]),
            plane("x_min", [held_by(0.0), free, free]),
        ],
        ..scene(mesh, steel)
    };
    let solution = solve(&mut scene, &mut Silent).unwrap();
    let force = |plane: usize| solution.last.planes[plane].force;
    let load = force(0)[2] + force(1)[2];
    assert!((force(0)[2] / force(1)[2] - 1.0).abs() < 0.1);
    assert!((load / applied(&scene, &solution.last) + 1.0).abs() < 1e-8);
    assert!((force(2)[2] / load + 1.0).abs() < 1e-8);
    let across = force(2)[0] + force(3)[0];
    assert!(force(2)[0].abs() > 1e-3 * load.abs() && across.abs() < 1e-8 * load.abs());
}

/// Loads that oppose each other have no travel along what is left of them.
#[test]
fn opposing_loads_have_no_travel() {
    let bar = |above: f64, below: f64| {
        let bar = Block::new(
            "bar",
            uniform(0.0, 2.0, 2),
            uniform(0.0, 3.0, 2),
            uniform(0.0, 1.0, 2),
        );
        let pressure = |surface: &str, p: f64| Traction {
            name: surface.into(),
            surface: surface.into(),
            value: TractionValue::Pressure(p),
        };
        let steel = Steel {
            youngs_modulus: 1000.0,
            poissons_ratio: 0.3,
            yield_stress: f64::INFINITY,
            hardening_modulus: 0.0,
        };
        let mut scene = Scene {
            supports: vec![held("x_min", 0), held("y_min", 1)],
            tractions: vec![pressure("z_max", above), pressure("z_min", below)],
            ..scene(bar.build().unwrap(), steel)
        };
        if below == 0.0 {
            scene.supports.push(held("z_min", 2));
        } else {
            scene.supports.push(held("x_max", 2));
        }
        let solution = solve(&mut scene, &mut Silent).unwrap();
        let along = along(&scene, &solution.last);
        (descent(&scene, &solution.last), along)
    };
    let (travel, along) = bar(1.0, 0.0);
    assert!((travel.unwrap() - 1e-3).abs() < 1e-9);
    assert_eq!(along, [0.0, 0.0, -1.0]);
    assert_eq!(bar(1.0, 0.999), (None, [0.0, 0.0, -1.0]));
    assert_eq!(bar(1.0, 1.0), (None, [0.0, 0.0, -1.0]));
    assert!(bar(1.0, 0.5).0.is_some());
}
