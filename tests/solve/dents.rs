//! What stays in the bodies after unloading. Dents of known depth are in the ladder (`dents`).

use brinell::material::Steel;
use brinell::results::dent::dent;
use brinell::scene::{Scene, Step};
use brinell::solve::{Silent, Solution, solve, spring_back};
use brinell::verify::problem_h::{self, Sizes};

/// Problem H, the block yielding at 0.4 times Hertz's pressure, the cylinder not at all; loaded, and
/// unloaded to 0.1 %.
fn line_contact() -> (Scene, Solution) {
    let mut scene = problem_h::scene(&Sizes::nested(1)).unwrap();
    let block = scene.mesh.body("block").unwrap();
    scene.materials[block] = Steel {
        yield_stress: 0.4 * problem_h::PRESSURE,
        hardening_modulus: 249.471,
        ..scene.materials[block]
    };
    let step = |name: &str, factor| Step {
        name: name.into(),
        factor,
        factors: Vec::new(),
    };
    scene.steps = vec![step("load", 1.0), step("unload", 1e-3)];
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
    let (scene, solution) = line_contact();
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
    let (scene, solution) = line_contact();
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
