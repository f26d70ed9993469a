//! The centre bearing of the study, pressed until it yields, and its figures.

use brinell::answer::results::edges::SingularEdges;
use brinell::answer::results::load::descent;
use brinell::answer::results::peaks::peaks;
use brinell::answer::results::recovery::recover;
use brinell::case::{self, Case};
use brinell::model::mesh::Mesh;
use brinell::model::scene::{PlaneMotion, Scene};
use brinell::model::state::State;
use brinell::solver::solve::{Silent, solve};
use std::path::Path;

pub fn case() -> Case {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-centre.toml");
    let mut case = case::read(&path).expect("the shipped case reads");
    case.set_preset("report-like").expect("a preset");
    case
}

/// At three times its load, so that bodies yield and nodes stick and slip; in increments that do
/// not depend on how the iterations go.
pub fn state(case: &Case, mesh: Mesh) -> (Scene, State) {
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
pub fn figures((scene, state): &(Scene, State)) -> Vec<(String, f64)> {
    let mut all = Vec::new();
    let mut add = |name: String, value: Option<f64>| {
        all.push((name, value.expect("a figure")));
    };
    let edges = SingularEdges::find(scene, state);
    for body in peaks((scene, state), &recover(scene, state), &edges, &[]) {
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
