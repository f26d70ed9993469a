//! What stays in the bodies after unloading. Dents of known depth are in the ladder (`dents`).

use brinell::answer::results::dent::dent;
use brinell::model::material::Steel;
use brinell::model::scene::{Scene, Step};
use brinell::proof::verify::problem_h::{self, Sizes};
use brinell::solver::solve::{Silent, Solution, solve, spring_back};

/// Problem H, the block yielding at this share of Hertz's pressure, the cylinder not at all, at the ends of steps to
/// these factors of the load.
fn line_contact(share: f64, factors: &[f64]) -> (Scene, Solution) {
    let mut scene = problem_h::scene(&Sizes::nested(1)).unwrap();
    let block = scene.mesh.body("block").unwrap();
    scene.materials[block] = Steel {
        yield_stress: share * problem_h::PRESSURE,
        hardening_modulus: 249.471,
        ..scene.materials[block]
    };
    let step = |factor: &f64| Step::to(factor.to_string(), *factor);
    scene.steps = factors.iter().map(step).collect();
    let solution = solve(&mut scene, &mut Silent).unwrap();
    (scene, solution)
}

fn depth(scene: &Scene, displacement: &[[f64; 3]], body: &str) -> f64 {
    let surface = scene.mesh.surface(&format!("{body}_contact")).unwrap();
    let body = scene.mesh.body(body).unwrap();
    dent(scene, displacement, body, surface).unwrap().depth
}

#[test]
fn a_body_that_did_not_yield_keeps_nothing() {
    let (scene, solution) = line_contact(0.4, &[1.0, 1e-3]);
    let state = &solution.last;
    let stays = spring_back(&scene, state).unwrap();
    let kept = depth(&scene, &stays, "block");
    assert!(kept > 1e-5, "{kept}");
    assert!(depth(&scene, &stays, "cylinder").abs() < 1e-12 * kept);
    // With what is left of the load on, it shows some.
    let pressed = depth(&scene, &state.displacement, "cylinder");
    assert!(pressed > 1e-2 * kept, "{pressed}");
}

#[test]
fn what_stays_is_known_before_unloading() {
    let (scene, solution) = line_contact(0.4, &[1.0, 1e-3]);
    let [loaded, unloaded] = [0, 1].map(|i| {
        let stays = spring_back(&scene, &solution.states[i]).unwrap();
        depth(&scene, &stays, "block")
    });
    assert!(
        (loaded / unloaded - 1.0).abs() < 1e-6,
        "{loaded}, {unloaded}"
    );
}

#[test]
fn nothing_yielded_nothing_stays() {
    let mut scene = problem_h::scene(&Sizes::nested(0)).unwrap();
    let solution = solve(&mut scene, &mut Silent).unwrap();
    let stays = spring_back(&scene, &solution.last).unwrap();
    assert_eq!(stays, vec![[0.0; 3]; scene.mesh.points.len()]);
}

/// While a load is taken off, steel that has flowed is condensed with its plastic strain. A load that is not taken off
/// to a twentieth is not taken off, so that nothing is condensed then: the same load, the same answer. Steel flows
/// back beside the strip.
#[test]
fn steel_that_settles_says_what_steel_that_is_watched_says() {
    let watched = line_contact(0.2, &[1.0, 0.06]).1;
    let settled = line_contact(0.2, &[1.0, 0.06, 0.04]).1;
    let [loaded, watched, settled] = [&watched.states[0], &watched.states[1], &settled.states[1]];
    let most = |a: &[[f64; 8]], b: &[[f64; 8]]| {
        let pairs = a.as_flattened().iter().zip(b.as_flattened());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let (all, back) = (
        most(&loaded.peeq, &vec![[0.0; 8]; loaded.peeq.len()]),
        most(&watched.peeq, &loaded.peeq),
    );
    assert!(back > 1e-3 * all, "{back} of {all} flows back");
    let apart = most(&watched.peeq, &settled.peeq);
    assert!(apart < 1e-5 * back, "{apart} of {back}");
    let pairs = watched.displacement.iter().zip(&settled.displacement);
    let moved = pairs.flat_map(|(a, b)| [0, 1, 2].map(|i| (a[i] - b[i]).abs()));
    let size = watched.displacement.as_flattened().iter().map(|u| u.abs());
    let (moved, size) = (moved.fold(0.0, f64::max), size.fold(0.0, f64::max));
    assert!(moved < 1e-8 * size, "{moved} of {size}");
}
