//! The answer depends neither on the units nor on the number of threads.

use brinell::case;
use brinell::model::scene::{PlaneMotion, Scene};
use brinell::product::job;
use brinell::solver::solve::{Silent, Solution, solve};
use std::path::Path;

/// The report-like centre case at three times its load, so that it yields, slips and sticks.
fn scene() -> Scene {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-centre.toml");
    let mut case = case::read(&path).expect("the shipped case reads");
    case.set_preset("report-like").expect("a preset");
    let mesh = job::find_mesh(&case, None, &mut |_| ()).expect("the shipped mesh");
    let mut scene = case.scene(mesh).expect("a scene");
    scene.controls.residual = 1e-10;
    for motion in scene.rigid_planes.iter_mut().flat_map(|p| &mut p.motion) {
        if let PlaneMotion::Driven(load) = motion {
            *load *= 3.0;
        }
    }
    scene
}

/// The same scene in other units: one mesh, scaled.
fn scaled(mut scene: Scene, length: f64, force: f64) -> Scene {
    let stress = force / (length * length);
    scene
        .mesh
        .points
        .iter_mut()
        .flatten()
        .for_each(|x| *x *= length);
    for steel in &mut scene.materials {
        steel.youngs_modulus *= stress;
        steel.yield_stress *= stress;
        steel.hardening_modulus *= stress;
    }
    for motion in scene.rigid_planes.iter_mut().flat_map(|p| &mut p.motion) {
        match motion {
            PlaneMotion::Driven(load) => *load *= force,
            PlaneMotion::Held(travel) => *travel *= length,
            PlaneMotion::Free => {}
        }
    }
    scene
}

fn run(mut scene: Scene) -> Solution {
    solve(&mut scene, &mut Silent).expect("converges")
}

/// Displacements, forces and stresses equal within 1e-9 of their largest value.
fn same(a: &Solution, b: &Solution, length: f64, force: f64) {
    let stress = force / (length * length);
    let close = |what: &str, a: Vec<f64>, b: Vec<f64>, unit: f64| {
        let largest = a.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        for (a, b) in a.iter().zip(&b) {
            let off = (b / unit - a).abs() / largest;
            assert!(off < 1e-9, "{what}: {a} and {b}, {off:.1e}");
        }
    };
    let (x, y) = (&a.last, &b.last);
    let flat = |v: &[[f64; 3]]| v.iter().flatten().copied().collect::<Vec<f64>>();
    close(
        "displacement",
        flat(&x.displacement),
        flat(&y.displacement),
        length,
    );
    let ip = |s: &[[[f64; 6]; 8]]| s.iter().flatten().flatten().copied().collect::<Vec<f64>>();
    close("stress", ip(&x.stress), ip(&y.stress), stress);
    for (p, q) in x.contacts.iter().zip(&y.contacts) {
        close("contact force", flat(&p.force), flat(&q.force), force);
    }
    assert_eq!(a.counters.iterations, b.counters.iterations);
}

#[test]
fn inches_and_kips_or_millimetres_and_newtons_or_metres() {
    let base = run(scene());
    assert!(
        base.last.peeq.iter().flatten().any(|p| *p > 0.0),
        "the scene must yield"
    );
    for (length, force) in [(25.4, 4448.2216152605), (0.0254, 4448.2216152605)] {
        same(&base, &run(scaled(scene(), length, force)), length, force);
    }
}

#[test]
fn one_thread_or_two() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool");
        pool.install(|| run(scene()))
    };
    same(&with(1), &with(2), 1.0, 1.0);
}
