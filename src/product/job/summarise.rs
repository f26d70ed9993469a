//! The summary of a run: its answer, and what stands beside it.

use super::error::JobError;
use super::options::Options;
use super::outcome::{reported, unloaded};
use super::second::{ElasticPeaks, Twin};
use super::{compare, hand_checks, left_out, rules, sizing, strips, welds};
use crate::answer::results::bore::Bore;
use crate::answer::results::load;
use crate::answer::results::recovery::Recovered;
use crate::answer::{Answer, AnswerInputs, Named};
use crate::case::bearing::RollerPlace;
use crate::case::{Case, Kind};
use crate::ground::geometry::{dot, norm};
use crate::ground::memory;
use crate::ground::units::UnitLabels;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::model::state::turn::{FAR, largest_turn};
use crate::render::summary::{Counters, Timing};
use crate::render::text::significant;
use crate::render::warnings::{Warning, warnings};
use crate::render::{OutputError, Summary};
use crate::solver::solve::{self, Closing, Phase, Solution, Timers};

/// What was solved beside the case itself: peaks without plasticity, and what stays without load.
#[derive(Debug, Clone, Copy)]
pub struct Second<'a> {
    pub elastic: Option<&'a ElasticPeaks>,
    /// Where those peaks are of another mesh.
    pub twin: Option<&'a Twin>,
    pub stays: Option<&'a [[f64; 3]]>,
}

/// The summary of a solution; `recovered` are the fields of the state that is reported.
///
/// # Errors
/// [`JobError`] where a closed form beside the answer has no value.
pub fn summarise(
    case: &Case,
    scene: &Scene,
    (solution, recovered): (&Solution, &Recovered),
    second: Second,
    timing: Timing,
    options: &Options,
) -> Result<Summary, JobError> {
    let state = reported(scene, solution);
    let answer = Answer::of(&AnswerInputs {
        unloaded: unloaded(scene, solution),
        stays: second.stays,
        steps: &solution.states,
        elastic: second.elastic.map(|peaks| peaks.own.as_slice()),
        elastic_doubled: second.elastic.and_then(|peaks| peaks.doubled.as_deref()),
        elastic_claims: second.twin.map_or(&[], |twin| &twin.claims),
        doubled: &solution.doubled,
        converged: solution.complete,
        interrupted: solution.interrupted,
        bores: &bores(case),
        // Nothing but bodies and contact carries force: the tangent alone is shifted.
        stabilisation_share: Some(0.0),
        ..AnswerInputs::new(scene, state, recovered)
    })
    .map_err(OutputError::from)?;
    let mut warnings = warnings(&answer);
    let told = [&solution.stuck, &solution.laborious];
    let told = told.into_iter().flatten().cloned();
    let found = [
        turned(scene, state),
        strips::shortcoming(case, scene, state),
    ];
    let found = found.into_iter().flatten();
    let welds = welds::in_contact(scene);
    let overlaps = solution.overlapping.iter().map(|(name, overlap)| {
        let (overlap, unit) = (significant(*overlap, 3), case.units.length());
        format!(
            "{name}: the surfaces overlap by {overlap} {unit} before the load, and press as an interference fit does"
        )
    });
    let all = told.chain(found).chain(welds).chain(overlaps);
    let all = all.chain(moved_out(case, scene, &solution.closings));
    warnings.extend(all.map(Warning));
    let sizing = sizing::sizing(case, scene, &answer)?;
    Ok(Summary {
        case: case.title.clone(),
        title_block: title_block(case),
        units: UnitLabels::of(case.units),
        brinell_version: env!("CARGO_PKG_VERSION").to_owned(),
        comparison: compare::rows(case, scene, &answer)?,
        hand_checks: hand_checks::hand_checks(case, scene, (&answer, sizing.as_ref()))?,
        sizing,
        rules: rules::rules(case, scene, &answer)?,
        answer,
        counters: counters(&solution.counters),
        timing,
        peak_memory_bytes: memory::peak(),
        elastic_twin: second.twin.map(|twin| twin.told.clone()),
        assumptions: assumptions(case),
        left_out: left_out::list(case, scene, solution, options),
        warnings,
    })
}

/// Of the size of the scene, how far a body is moved out of another before that is worth a word: facets overlap a little.
const MOVED_OUT: f64 = 0.01;

/// Which floating bodies overlapped others and were moved against the load until they did no longer.
fn moved_out(case: &Case, scene: &Scene, closings: &[Closing]) -> Vec<String> {
    let along = load::direction(scene);
    let size = norm([0, 1, 2].map(|axis| scene.mesh.extent(axis)));
    let out = |closing: &Closing| -dot(closing.shift, along);
    let far = closings
        .iter()
        .filter(|closing| out(closing) > MOVED_OUT * size);
    far.map(|closing| {
        let (body, way) = (&closing.body, significant(out(closing), 3));
        let unit = case.units.length();
        format!(
            "{body}: it overlapped what carries it and was moved out by {way} {unit} before the load, as nothing else holds it; what shall press as an \
             interference fit has to be held"
        )
    })
    .collect()
}

fn title_block(case: &Case) -> Named<Option<String>> {
    let entries = case.title_block.iter();
    Named(
        entries
            .map(|(key, text)| ((*key).to_owned(), text.clone()))
            .collect(),
    )
}

fn counters(counters: &solve::Counters) -> Counters {
    Counters {
        dofs: counters.equations,
        iterations: counters.iterations,
        factorisations: counters.factorisations,
        krylov_directions: counters.krylov_directions,
        kept_dofs: counters.kept_equations,
        factor_entries: counters.factor_entries,
    }
}

/// A body that turns so far that contact is elsewhere than where it was sought, in words.
fn turned(scene: &Scene, state: &State) -> Option<String> {
    let (body, angle) = largest_turn(&scene.mesh, &state.displacement)?;
    (angle > FAR).then(|| {
        format!(
            "`{body}` turns by {angle:.3} rad: contact is sought where bodies stood before, and rotations are taken \
             as small"
        )
    })
}

/// Seconds by phase, under names without blanks.
pub fn phases(timers: &Timers) -> Named<f64> {
    let phase = |p: &Phase| (p.name().replace(' ', "_"), timers.seconds(*p));
    Named(Phase::ALL.iter().map(phase).collect())
}

/// Inner walls of hollow rollers.
fn bores(case: &Case) -> Vec<Bore> {
    match &case.kind {
        Kind::Bearing(bearing) if bearing.geometry.wall().is_some() => {
            let rollers = bearing.geometry.rollers(bearing.mesh.full).into_iter();
            let bore = |roller: RollerPlace| Bore {
                surface: format!("{}_bore", roller.body),
                axis: roller.axis,
                lean: roller.lean(),
                body: roller.body,
            };
            rollers.map(bore).collect()
        }
        _ => Vec::new(),
    }
}

/// What was assumed where the case says nothing, and what of it does not fit together, in words.
pub fn assumptions(case: &Case) -> Vec<String> {
    let taken = case.assumptions.iter().filter(|a| !a.given);
    let taken = taken.map(|a| format!("{} = {}: {}", a.key, a.value, a.why));
    let found = case
        .discrepancies
        .iter()
        .map(|d| format!("{}: {}", d.what, d.effect));
    taken.chain(found).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn what_the_case_gives_is_not_assumed() {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2");
        let case = crate::case::read(&cases.join("initial-centre.toml")).expect("it reads");
        let told = assumptions(&case);
        for taken in &case.assumptions {
            let begin = format!("{} = ", taken.key);
            let is_told = told.iter().any(|text| text.starts_with(&begin));
            assert_ne!(is_told, taken.given, "{begin}");
        }
        assert!(case.assumptions.iter().any(|taken| taken.given) && !told.is_empty());
    }
}
