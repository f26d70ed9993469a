//! The displaced bearing: what contact does to bodies that nothing else holds.

use brinell::answer::results::balance::{balances, centre_of_force};
use brinell::answer::results::contact_lines::contact_lines;
use brinell::answer::results::line_frame::LineFrame;
use brinell::answer::results::load::applied;
use brinell::case;
use brinell::solver::solve::{Silent, solve};
use std::path::Path;

const DIAMETER: f64 = 3.0;
const LENGTH: f64 = 8.0;

#[test]
fn a_displaced_bearing_is_in_balance() {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-offset-2.5.toml");
    let mut case = case::read(&path).expect("the shipped case reads");
    case.set_preset("report-like").expect("a preset");
    let mesh =
        brinell::product::job::find_mesh(&case, None, &mut |_| {}).expect("the shipped mesh");
    let mut scene = case.scene(mesh).expect("a scene");
    scene.steps.truncate(1);
    let state = solve(&mut scene, &mut Silent).expect("converges").last;
    let load = applied(&scene, &state);

    // The residual is 1e-8 of the load; the limits are those of a certificate.
    let found = balances(&scene, &state);
    let bodies: Vec<&str> = found.iter().map(|b| b.body.as_str()).collect();
    assert_eq!(
        bodies,
        ["upper_roller", "lower_roller", "intermediate_plate"]
    );
    for balance in &found {
        let largest = |v: [f64; 3]| v.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        assert!(largest(balance.force) < 1e-4 * load, "{balance:?}");
        assert!(
            largest(balance.moment) < 1e-4 * load * DIAMETER,
            "{balance:?}"
        );
    }

    // The load goes straight down through the rollers, but for the lean of the slopes (4 deg, at
    // most R sin 4 deg = 0.105 in).
    for pair in 0..scene.contacts.len() {
        let [x, y, _] = centre_of_force(&scene, &state, pair).expect("it presses");
        assert!(
            (x - 2.5).abs() < 0.105 && (y - 2.5).abs() < 0.105,
            "{x} {y}"
        );
    }

    // Each roller presses on one line and has lifted off towards the middle.
    for pair in 0..scene.contacts.len() {
        let axis = if pair < 2 { 1 } else { 0 };
        let [line] = contact_lines(
            &scene,
            &state,
            pair,
            &LineFrame::of_axis(&scene, axis).unwrap(),
        )
        .try_into()
        .expect("one line");
        assert_eq!(line.images, 1);
        assert!((line.length + line.lifted_off - LENGTH).abs() < 1e-9);
        assert!(line.lifted_off > 2.0 && line.length > 3.0, "{line:?}");
        // Pressures are normal to a surface that leans by 4 deg at most.
        let rows: Vec<f64> = line.at.windows(2).map(|w| w[1] - w[0]).collect();
        let stands_for = |i: usize| {
            let before = i.checked_sub(1).map_or(0.0, |b| rows[b]);
            0.5 * (before + rows.get(i).copied().unwrap_or(0.0))
        };
        let carried: f64 = (line.load.iter().enumerate())
            .map(|(i, q)| q * stands_for(i))
            .sum();
        assert!((carried / load - 1.0).abs() < 0.0025, "{carried}");
    }
}
