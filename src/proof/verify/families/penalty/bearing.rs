//! The bearing of section 2.6.2: friction and plasticity.

use super::problem::{NamedFigures, Problem};
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::interface::interfaces;
use crate::answer::results::line_frame::axis_of;
use crate::answer::results::line_load::{Slices, line_load};
use crate::answer::results::load::descent;
use crate::answer::results::peaks::peaks;
use crate::answer::results::recovery::recover;
use crate::answer::results::strip::{Strip, half_width};
use crate::case;
use crate::model::scene::Scene;
use crate::product::job::{self, JobError};
use crate::proof::verify::kit::SolvedScene;
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// A bearing with friction that yields; nothing where only the fast part of the ladder is wanted.
pub fn claims(extent: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    const PROBLEM: Problem = Problem {
        name: "centre case, h025",
        scene,
        figures,
    };
    match extent {
        Extent::Fast => Ok(Vec::new()),
        Extent::All => PROBLEM.with_penalties(&[0.1, 10.0, 0.01, 100.0]),
    }
}

/// The initial design of section 2.6.2, rollers at the centre, on its default mesh, where it
/// yields.
fn scene() -> Result<Scene, VerifyError> {
    Ok(centre_case()?)
}

fn centre_case() -> Result<Scene, JobError> {
    let mut case = case::parse(
        "cases/section-2.6.2/initial-centre.toml",
        include_str!("../../../../../cases/section-2.6.2/initial-centre.toml"),
    )?;
    case.set_preset("h025")?;
    let mesh = job::find_mesh(&case, None, &mut |_| {})?;
    Ok(case.scene(mesh)?)
}

/// The largest over bodies or interfaces, and the line load in its slices.
fn figures(run: &SolvedScene) -> Result<NamedFigures, VerifyError> {
    let (scene, state) = (&run.scene, run.state());
    let edges = SingularEdges::find(scene, state);
    let bodies = peaks((scene, state), &recover(scene, state), &edges, &[]);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let mut pressures = interfaces(scene, state).into_iter().map(|i| i.max_pressure);
    let mut mises = bodies
        .iter()
        .flat_map(|b| b.integration_point.as_ref())
        .map(|p| p.value);
    let mut strains = bodies.iter().map(|b| b.peeq_max);
    let mut figures = vec![
        ("p0, ksi", largest(&mut pressures)),
        ("peak Mises, ksi", largest(&mut mises)),
        ("largest plastic strain", largest(&mut strains)),
        (
            "descent, in",
            descent(scene, state).ok_or(VerifyError::Missing("descent"))?,
        ),
    ];
    let slices = Slices::equal(scene, 0, 10).ok_or(VerifyError::Missing("line load"))?;
    let along = axis_of(&slices.along).ok_or(VerifyError::Missing("line load"))?;
    let strip = Strip {
        middle: Some(0.0),
        ..Strip::across(1 - along)
    };
    let surface = scene
        .carrier(0)
        .ok_or(VerifyError::Missing("carrier surface"))?;
    let width = half_width(&scene.mesh, surface, &state.contacts[0], &strip);
    figures.push((
        "half-width, in",
        width.ok_or(VerifyError::Missing("pressure"))?,
    ));
    let load = line_load(scene, state, 0, &slices).ok_or(VerifyError::Missing("line load"))?;
    let names = [
        "q at the crossing, kip/in",
        "q half way to the end, kip/in",
        "q at the end, kip/in",
    ];
    let last = load.q.len() - 1;
    figures.extend(
        names
            .into_iter()
            .zip([0, last / 2, last].map(|i| load.q[i])),
    );
    Ok(figures)
}
