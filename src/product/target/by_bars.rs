//! A bearing that is meshed by its lines of contact: each mesh is chosen by what the bars of the one before say.
//!
//! First its elastic twin is solved, loaded only: a tenth of the time of the case itself. Where steel flows, the twin is
//! what elastic figures are of; it goes on alone until they are as good as asked for. The case itself, with flow, its second
//! solution and unloading, is solved on the mesh that should meet the rest, and on a finer one where that was foreseen
//! too well.

use super::ending::{Ended, Known, TargetLimits, TargetVerdict, name, places, singular};
use super::goal::{Goal, Target};
use super::level::Level;
use super::plan;
use crate::analytic::hertz::widening_in_flow;
use crate::answer::certify::{Quantity, figure};
use crate::case::Case;
use crate::case::bearing::Scales;
use crate::product::converge::ConvergeError;
use crate::product::converge::cost::Meter;
use crate::product::job::{self, JobError, Options, Outcome, Twin};
use crate::solver::solve::Observer;
use std::time::Instant;

/// See [`super::refine`].
pub(super) fn refine(
    case: &Case,
    (target, limits): (&Target, &TargetLimits),
    options: &Options,
    observer: &mut dyn Observer,
    (known, told): (&mut Known, &mut dyn FnMut(&Level)),
) -> Ended {
    let mut way = Way {
        target,
        limits,
        options,
        observer,
        told,
        levels: &mut known.levels,
        last: &mut known.last,
    };
    let twin = twin(case).filter(|_| target.goal != Goal::PlasticStrain);
    let Some(twin) = twin else {
        return way.own(case.clone(), None, false);
    };
    let (twin, case) = match way.elastic(twin, case.clone())? {
        ElasticEnd::Solved(twin, case) => (twin, case),
        ElasticEnd::Interrupted(outcome) => {
            return Ok((TargetVerdict::Interrupted, *outcome));
        }
    };
    way.own(*case, twin.as_ref(), true)
}

/// What came of the elastic solutions.
enum ElasticEnd {
    /// The last one, where steel flows, and the case on the mesh that it asks for.
    Solved(Option<Twin>, Box<Case>),
    Interrupted(Box<Outcome>),
}

/// On the way to a target.
struct Way<'a> {
    target: &'a Target,
    limits: &'a TargetLimits,
    options: &'a Options,
    observer: &'a mut dyn Observer,
    told: &'a mut dyn FnMut(&Level),
    levels: &'a mut Vec<Level>,
    /// See [`Known`].
    last: &'a mut Option<Outcome>,
}

impl Way<'_> {
    /// The elastic twin, until what is elastic is as good as asked for.
    fn elastic(&mut self, mut twin: Case, mut case: Case) -> Result<ElasticEnd, ConvergeError> {
        let mut known: Option<Twin> = None;
        loop {
            let first = self.levels.is_empty();
            let meter = Meter::start();
            let number = self.levels.len();
            let (_, own) = places(self.options, number);
            let own = Options {
                report: false,
                ..own
            };
            let outcome = match self.solve(&twin, &own, None, !first) {
                // What is elastic stays as the mesh before has it.
                Err(error) if known.is_some() && error.is_of_mesh() => {
                    self.observer
                        .message(&format!("no finer elastic solution: {error}"));
                    return Ok(ElasticEnd::Solved(known, Box::new(case)));
                }
                solved => solved?,
            };
            if outcome.interrupted {
                return Ok(ElasticEnd::Interrupted(Box::new(outcome)));
            }
            let mut level = self.level(&outcome, &meter);
            level.twin = true;
            let flows = flows(&case, &outcome);
            if first {
                if let Some(strips) = found(&own)? {
                    twin.set_strips(strips);
                    case.set_strips(strips);
                }
                let counts = |goal: Goal| !flows || !goal.is_elastic();
                let foreseen = foreseen(&level, flows);
                let scales = plan::next(&foreseen, None, self.target, counts);
                widen(&mut case, &outcome);
                case.refine_mesh(&self.affordable(&case, &scales, level.unknowns))?;
            }
            let scales = plan::next(&level, self.levels.last(), self.target, Goal::is_elastic);
            let next = self.affordable(&twin, &scales, level.unknowns);
            self.tell(level);
            // One more level is of the case itself.
            let last = self.levels.len() + 1 >= self.limits.levels;
            known = flows.then(|| Twin::of(&outcome, name(number)));
            if !flows || last || next == Scales::default() {
                return Ok(ElasticEnd::Solved(known, Box::new(case)));
            }
            twin.refine_mesh(&next)?;
        }
    }

    /// The case itself, until all is as good as asked for.
    fn own(mut self, mut case: Case, twin: Option<&Twin>, mut is_sized: bool) -> Ended {
        loop {
            let meter = Meter::start();
            let (_, own) = places(self.options, self.levels.len());
            let outcome = self.solve(&case, &own, twin, is_sized)?;
            if outcome.interrupted {
                return Ok((TargetVerdict::Interrupted, outcome));
            }
            if !is_sized && let Some(strips) = found(&own)? {
                case.set_strips(strips);
            }
            is_sized = true;
            let mut level = self.level(&outcome, &meter);
            let before = self.levels.iter().rfind(|level| level.twin);
            if let Some(before) = before.filter(|_| twin.is_some()) {
                level.take_elastic(before);
            }
            let counts = |goal: Goal| twin.is_none() || !goal.is_elastic();
            let before = self.levels.last().filter(|before| !before.twin);
            let scales = plan::next(&level, before, self.target, counts);
            let (met, nothing) = (level.meets(self.target), level.figures.is_empty());
            let unknowns = level.unknowns;
            self.tell(level);
            let count = self.levels.len();
            let why = if met {
                return Ok((TargetVerdict::Met, outcome));
            } else if nothing {
                self.target.goal.has_no_claim()
            } else if let Some(why) = singular(self.levels) {
                why
            } else if scales == Scales::default() {
                "the elastic solution misses it on the finest mesh within the limits".to_owned()
            } else if count >= self.limits.levels {
                format!("not met by the finest of {count} meshes")
            } else if let expected = expected(&case, &scales, unknowns)
                && expected > self.limits.unknowns
            {
                format!(
                    "not met by the finest of {count} meshes; the next one would have about {expected:.0} unknowns"
                )
            } else {
                *self.last = Some(outcome);
                case.refine_mesh(&scales)?;
                continue;
            };
            return Ok((TargetVerdict::NotMet(why), outcome));
        }
    }

    /// Solves a case; on its own mesh where that `is_sized`, else on one that may be made anew for the lines as found.
    fn solve(
        &mut self,
        case: &Case,
        own: &Options,
        twin: Option<&Twin>,
        is_sized: bool,
    ) -> Result<Outcome, ConvergeError> {
        let start = Instant::now();
        if !is_sized {
            return Ok(job::run_beside(case, own, twin, self.observer)?);
        }
        if let Some(out) = &own.out {
            std::fs::create_dir_all(out).map_err(|error| JobError::folder(out, error))?;
        }
        let mut say = |line: &str| self.observer.message(line);
        let mesh = job::find_mesh(case, own.out.as_deref(), &mut say)?;
        let beside = (start, twin);
        Ok(job::run_on_beside(case, mesh, own, beside, self.observer)?)
    }

    fn level(&self, outcome: &Outcome, meter: &Meter) -> Level {
        let asked = (self.target, true);
        let number = self.levels.len();
        Level::new(
            number,
            asked,
            &outcome.summary,
            self.levels.last(),
            meter.stop(),
        )
    }

    fn tell(&mut self, level: Level) {
        (self.told)(&level);
        self.levels.push(level);
    }

    /// The scales, or as much of them as the limit on unknowns leaves and a mesh can have.
    fn affordable(&self, case: &Case, scales: &Scales, unknowns: usize) -> Scales {
        const SHARES: [f64; 4] = [1.0, 0.75, 0.5, 0.25];
        let parts = SHARES.map(|share| scales.part(share));
        let fits = |part: &Scales| {
            expected(case, part, unknowns) <= self.limits.unknowns
                && case.clone().refine_mesh(part).is_ok()
        };
        parts.into_iter().find(fits).unwrap_or_default()
    }
}

/// The level with the bars that the case itself should have: where steel flows the largest pressure is known as well as the
/// load per length below it, but for what nodes and increments miss: 0.5 to 1.5 % of it at fifteen strips of five bearings
/// whose fine elements reach as far as the strip. A mesh more costs more than one a little too fine, so nearly the most is
/// foreseen.
fn foreseen(level: &Level, flows: bool) -> Level {
    const MISSED: f64 = 0.013;
    let mut foreseen = level.clone();
    let certificate = &level.summary.answer.certificate;
    let pressures = foreseen.figures.iter_mut();
    for pressure in pressures.filter(|figure| flows && figure.goal == Goal::Pressure) {
        let bar = |what| figure(certificate, what, &pressure.place)?.relative_bar();
        if let Some(bar) = bar(Quantity::LineLoad).or_else(|| bar(Quantity::LineLoadAway)) {
            pressure.estimate = Some((bar + MISSED) * pressure.value);
        }
    }
    foreseen
}

/// What the mesh of a run was made for, where its solution found that.
fn found(own: &Options) -> Result<Option<crate::case::bearing::Strips>, ConvergeError> {
    let out = own.out.as_deref();
    Ok(out.map(job::found_strips).transpose()?.flatten())
}

/// The case without what does not say how good its mesh is; `None` where that is all of it.
fn twin(case: &Case) -> Option<Case> {
    let more = case.controls.plasticity || case.bearing()?.unload_to.is_some();
    more.then(|| {
        let mut twin = case.clone();
        twin.set_elastic_and_loaded();
        twin
    })
}

/// Does steel flow in the case of which `outcome` is the elastic twin?
fn flows(case: &Case, outcome: &Outcome) -> bool {
    let bodies = outcome.summary.answer.bodies.0.iter();
    let beyond =
        |peak: Option<f64>, limit: Option<f64>| peak.zip(limit).is_some_and(|(p, l)| p > l);
    case.controls.plasticity
        && (bodies.clone())
            .any(|(_, body)| beyond(body.mises_max.integration_point, body.yield_stress))
}

/// Unknowns of the mesh with these scales, where that without them has so many.
fn expected(case: &Case, scales: &Scales, unknowns: usize) -> f64 {
    let Some(bearing) = case.bearing() else {
        return unknowns as f64;
    };
    let mut refined = bearing.clone();
    refined.mesh = refined.mesh.refined(scales);
    unknowns as f64 * refined.elements() / bearing.elements()
}

/// Where steel flows strips become wider than those of the elastic twin.
fn widen(case: &mut Case, outcome: &Outcome) {
    let yields = (outcome.scene.materials.iter()).map(|steel| steel.yield_stress);
    let claims = outcome.summary.answer.certificate.iter();
    let pressures = claims.filter(|c| c.what == Quantity::HertzPressure);
    let largest = pressures.map(|c| c.value).fold(0.0, f64::max);
    let wider = widening_in_flow(largest, yields.fold(f64::INFINITY, f64::min));
    if case.controls.plasticity
        && wider > 1.0
        && let Some(bearing) = case.bearing()
        && let Some(strips) = bearing.mesh.strips
    {
        let strips = strips.widened(bearing.geometry.diameter(), wider);
        case.set_strips(strips);
    }
}
