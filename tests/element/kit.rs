//! What the tests share: a scene without contact, its supports and loads.

use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::scene::{Controls, ElementKind, Scene, Step, Support};
use brinell::model::state::State;
use brinell::solver::solve::{Silent, solve};

pub const KINDS: [ElementKind; 3] = [ElementKind::Bbar, ElementKind::Full, ElementKind::Enhanced];

/// A scene of one steel with one step to the full load and tight tolerances.
pub fn scene(mesh: Mesh, steel: Steel, element: ElementKind) -> Scene {
    Scene {
        controls: Controls {
            residual: 1e-12,
            element,
            ..Controls::default()
        },
        steps: vec![step(1.0)],
        ..Scene::bare("element test", mesh, steel)
    }
}

/// A step that takes every load and support to `factor`.
pub fn step(factor: f64) -> Step {
    Step::to(format!("to {factor}"), factor)
}

/// Holds one component of a surface.
///
/// Named after both: a scene may hold several components of one surface.
pub fn held(surface: &str, axis: usize) -> Support {
    let mut components = [None; 3];
    components[axis] = Some(0.0);
    Support {
        name: format!("{surface} {axis}"),
        surface: surface.into(),
        components,
        ..Support::default()
    }
}

/// The states at the ends of the steps.
pub fn states(scene: &mut Scene) -> Vec<State> {
    solve(scene, &mut Silent)
        .unwrap_or_else(|error| panic!("{error}"))
        .states
}

/// The state at the end of the last step.
pub fn last(scene: &mut Scene) -> State {
    states(scene).pop().expect("a state")
}

/// The steel of the reference study, ksi: E = 29500, ν = 0.3, yield at 100, and 138 at a total
/// strain of 0.157 (H = 249.471).
pub fn report_steel() -> Steel {
    let tangent = (138.0 - 100.0) / (0.157 - 100.0 / 29500.0);
    Steel {
        youngs_modulus: 29500.0,
        poissons_ratio: 0.3,
        yield_stress: 100.0,
        hardening_modulus: 29500.0 * tangent / (29500.0 - tangent),
    }
}

/// Fails unless `value` is within the relative `tolerance` of `expected`.
#[track_caller]
pub fn close(what: &str, value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs() / expected.abs();
    assert!(
        error <= tolerance,
        "{what}: {value}, expected {expected}, off by {error:.2e}"
    );
}
