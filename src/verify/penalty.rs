//! The answer does not depend on the penalty of the contact.
//!
//! The penalty is the slope of an augmented Lagrangian, so a hundred times more or less of it must
//! leave every figure where it is. What may move is bounded by the tolerances of the increment.

use super::kit::{self, Run};
use super::problem_h::{self, Sizes};
use super::{Claim, Extent, VerifyError};
use crate::case;
use crate::job::{self, JobError};
use crate::results::edges::carrier;
use crate::results::interface::interfaces;
use crate::results::line_load::{Slices, line_load};
use crate::results::load::descent;
use crate::results::peaks::peaks;
use crate::results::recovery::recover;
use crate::results::strip::{Strip, half_width};
use crate::scene::Scene;

const FACTORS: [f64; 2] = [0.01, 100.0];
const TOLERANCE: f64 = 2e-3;

/// Figures of a run by name.
type Figures = Vec<(&'static str, f64)>;

pub fn claims(extent: Extent) -> Result<Vec<Claim>, VerifyError> {
    let problem = || problem_h::scene(&Sizes::with(8));
    let mut claims = compare("problem H", problem, of_problem_h)?;
    if extent == Extent::All {
        claims.extend(compare("centre case, h025", bearing, of_bearing)?);
    }
    Ok(claims)
}

/// Figures of `scene` with other penalties against those with its own.
fn compare(
    name: &str,
    scene: impl Fn() -> Result<Scene, VerifyError>,
    figures: fn(&Run) -> Result<Figures, VerifyError>,
) -> Result<Vec<Claim>, VerifyError> {
    let with = |factor: f64| {
        let mut scene = scene()?;
        for pair in &mut scene.contacts {
            pair.penalty_factor *= factor;
        }
        let run = kit::run(scene)?;
        figures(&run).map(|figures| (run, figures))
    };
    let (_, own) = with(1.0)?;
    let mut claims = Vec::new();
    for factor in FACTORS {
        let (run, moved) = with(factor)?;
        for ((what, value), (_, reference)) in moved.into_iter().zip(&own) {
            let claim = format!("{name}, penalty x {factor}: {what}");
            let claim = Claim::relative(claim, value, *reference, TOLERANCE);
            claims.push(
                run.claim(
                    claim
                        .from("the same with penalty x 1")
                        .because("augmented to a penetration of 1e-5 of the approach"),
                ),
            );
        }
    }
    Ok(claims)
}

fn of_problem_h(run: &Run) -> Result<Figures, VerifyError> {
    let read = problem_h::read(&run.scene, run.state())?;
    Ok(vec![
        ("p0, ksi", read.pressure),
        ("half-width, in", read.half_width),
        ("peak Mises in the block, ksi", read.block.integration_point),
        (
            "peak Mises in the cylinder, ksi",
            read.cylinder.integration_point,
        ),
    ])
}

/// The initial design of section 2.6.2, rollers at the centre, on its default mesh, where it
/// yields.
fn bearing() -> Result<Scene, VerifyError> {
    Ok(centre_case()?)
}

fn centre_case() -> Result<Scene, JobError> {
    let mut case = case::parse(
        "cases/section-2.6.2/initial-centre.toml",
        include_str!("../../cases/section-2.6.2/initial-centre.toml"),
    )?;
    case.set_preset("h025")?;
    let mesh = job::find_mesh(&case, None, &mut |_| {})?;
    Ok(case.scene(mesh)?)
}

/// The largest over bodies or interfaces, and the line load in its slices.
fn of_bearing(run: &Run) -> Result<Figures, VerifyError> {
    let (scene, state) = (&run.scene, run.state());
    let bodies = peaks(scene, state, &recover(&scene.mesh, state));
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
    let strip = Strip {
        middle: Some(0.0),
        ..Strip::across(1 - slices.axis)
    };
    let surface = carrier(scene, 0).ok_or(VerifyError::Missing("carrier surface"))?;
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
