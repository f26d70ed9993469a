//! A quarter of a centred bearing says the same as the whole.

use brinell::case::{self, Case, Kind};
use brinell::job;
use brinell::mesh::Mesh;
use brinell::results::State;
use brinell::results::load::descent;
use brinell::results::peaks::peaks;
use brinell::results::recovery::recover;
use brinell::scene::{PlaneMotion, Scene};
use brinell::solve::{Silent, solve};
use std::path::Path;

fn case() -> Case {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-centre.toml");
    let mut case = case::read(&path).expect("the shipped case reads");
    case.set_preset("report-like").expect("a preset");
    case
}

/// At three times its load, so that bodies yield and nodes stick and slip; in increments that do
/// not depend on how the iterations go.
fn state(case: &Case, mesh: Mesh) -> (Scene, State) {
    let mut scene = case.scene(mesh).expect("a scene");
    scene.controls.residual = 1e-11;
    scene.controls.penetration = 1e-9;
    scene.controls.first_increment = 0.5;
    for motion in scene.rigid_planes.iter_mut().flat_map(|p| &mut p.motion) {
        if let PlaneMotion::Driven(load) = motion {
            *load *= 3.0;
        }
    }
    let solution = solve(&mut scene, &mut Silent).expect("converges");
    (scene, solution.last)
}

/// What must agree, with its name.
fn figures((scene, state): &(Scene, State)) -> Vec<(String, f64)> {
    let mut all = Vec::new();
    let mut add = |name: String, value: Option<f64>| {
        all.push((name, value.expect("a figure")));
    };
    for body in peaks(scene, state, &recover(scene, state)) {
        let peaks = [
            ("centroid", body.centroid),
            ("integration point", body.integration_point),
            ("nodal", body.nodal),
        ];
        for (what, peak) in peaks {
            add(format!("{what} of {}", body.name), peak.map(|p| p.value));
        }
        add(format!("volume of {}", body.name), Some(body.volume));
        add(
            format!("plastic strain of {}", body.name),
            Some(body.peeq_max),
        );
    }
    for (pair, field) in scene.contacts.iter().zip(&state.contacts) {
        let largest = field.pressure.iter().copied().reduce(f64::max);
        add(format!("pressure of {}", pair.name), largest);
        let slip = field.slip.iter().copied().reduce(f64::max);
        add(format!("slip of {}", pair.name), slip);
    }
    add("descent".into(), descent(scene, state));
    all
}

/// A centred bearing is solved as a quarter without being asked; the full model on the mirror
/// images of that mesh has the same peaks to 1e-6.
#[test]
fn a_quarter_says_what_the_whole_says() {
    let mut case = case();
    let mesh = job::find_mesh(&case, None, &mut |_| ()).expect("the shipped mesh");
    let mut whole = mesh.unfolded(0, 1e-9).unfolded(1, 1e-9);
    assert_eq!(whole.hexes.len(), 4 * mesh.hexes.len());
    let quarter = state(&case, mesh);
    assert_eq!(quarter.0.mirrors, [0, 1]);
    case.set_full().expect("a bearing");
    if let Kind::Bearing(bearing) = &case.kind {
        whole.fingerprint = Some(bearing.fingerprint());
    }
    let whole = state(&case, whole);
    assert!(whole.0.mirrors.is_empty());
    let mut worst = Vec::new();
    for ((name, a), (_, b)) in figures(&quarter).iter().zip(figures(&whole)) {
        let off = if *a == b { 0.0 } else { (b / a - 1.0).abs() };
        println!("{name}: {a} {b} {off:.1e}");
        if off > 1e-6 {
            worst.push(format!("{name}: {a} in the quarter, {b} in the whole"));
        }
    }
    assert!(worst.is_empty(), "{}", worst.join("\n"));
    let yielded = whole.1.peeq.iter().flatten().any(|p| *p > 0.0);
    let sticks = whole.1.contacts.iter().any(|c| c.status.contains(&1));
    let slips = whole.1.contacts.iter().any(|c| c.status.contains(&2));
    assert!(yielded && sticks && slips, "{yielded} {sticks} {slips}");
}
