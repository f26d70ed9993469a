//! Problem H at eight elements across the half-width, the cylinder carrying the pressure.

use brinell::scene::Scene;
use brinell::solve::{Silent, solve};
use brinell::verify::problem_h::*;

fn solved(mut scene: Scene) -> Reading {
    let solution = solve(&mut scene, &mut Silent).expect("converges");
    read(&scene, &solution.last).expect("has contact")
}

fn within(what: &str, value: f64, limit: f64, tolerance: f64) {
    let error = value / limit - 1.0;
    println!(
        "{what}: {value:.5} against {limit:.5}, {:+.3} %",
        100.0 * error
    );
    assert!(error.abs() <= tolerance, "{what}: {:+.3} %", 100.0 * error);
}

#[test]
fn pressure_half_width_and_mises_meet_their_limits() {
    let r = solved(scene(&Sizes::with(8)).expect("meshes"));
    println!("{r:?}");
    within("p0", r.pressure, PRESSURE, 0.003);
    within("half-width", r.half_width, HALF_WIDTH, 0.01);
    for (name, mises, limit) in [
        ("block", r.block, MISES_BLOCK),
        ("cylinder", r.cylinder, MISES_CYLINDER),
    ] {
        within(&format!("{name} centroid"), mises.centroid, limit, 0.006);
        within(&format!("{name} nodal"), mises.nodal, limit, 0.013);
        within(
            &format!("{name} integration point"),
            mises.integration_point,
            limit,
            0.017,
        );
    }
    assert!(r.balance.abs() < 1e-6, "{}", r.balance);
    assert_eq!(r.pressure_at, 0.0);
}

#[test]
fn the_penalty_factor_moves_nothing() {
    let with = |factor: f64| {
        let mut scene = scene(&Sizes::with(8)).expect("meshes");
        scene.contacts[0].penalty_factor = factor;
        solved(scene)
    };
    let base = with(1.0);
    for factor in [0.01, 100.0] {
        let r = with(factor);
        within("p0", r.pressure, base.pressure, 0.002);
        within("half-width", r.half_width, base.half_width, 0.002);
        within(
            "block",
            r.block.integration_point,
            base.block.integration_point,
            0.002,
        );
        within(
            "cylinder",
            r.cylinder.integration_point,
            base.cylinder.integration_point,
            0.002,
        );
    }
}

/// Equal bodies under normal load have no reason to slip; what shear is left is that of the
/// residual.
#[test]
fn identical_half_cylinders_feel_no_shear() {
    let mut scene = twin_scene(&Sizes::with(8), 1e-3, 0.15).expect("meshes");
    scene.controls.residual = 1e-10;
    let r = solved(scene);
    println!("p0 {} shear/p0 {:.2e}", r.pressure, r.shear);
    assert!(r.pressure > 100.0);
    assert!(r.shear < 1e-8, "{:e}", r.shear);
}
