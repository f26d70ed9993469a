//! Newton iterations of one increment.
//!
//! Each iteration solves for the displacements with the active set and the friction bounds fixed;
//! then the multipliers take the contact pressures (augmented Lagrange), and set and bounds are
//! decided anew: a primal-dual active-set method on a positive definite system. The increment ends
//! when forces balance, contact conditions hold *and* nothing changes any more, whatever the
//! penalty.

use super::anchor::ProximalSprings;
use super::bounds::Bounds;
use super::counters::Counters;
use super::evaluate::{Evaluation, Trial};
use super::history::History;
use super::line_search::search_line;
use super::linear_solver::{Correction, LinearSolver, flowing_points};
use super::model::Model;
use super::observer::{Iteration, Observer};
use super::start::extent;
use super::timers::Phase;
use crate::solver::contact::law::{MOST_RAISED, Node, Status};
use crate::solver::fem::dofs::FIXED;
use crate::solver::linear::cholesky::FactorError;
use crate::solver::linear::krylov::{dot, norm};
use crate::solver::solve::params::{
    CAUTIOUS_SHEAR_RESIDUAL, CONVERGING_ITERATIONS_FACTOR, FREE_SWITCHES,
    FREE_SWITCHING_ITERATIONS, HOPELESS_RESIDUAL, ITERATIONS_BEFORE_CAUTION, LIMIT_FLOW_SHARE,
    LINGERING_VIOLATION, LOST_DECREASE, LOST_RESIDUAL, PROXIMAL_ITERATIONS, PROXIMAL_RESIDUAL,
    STEADY_DECREASE, UNCHANGED_FORCE, WAVE_ITERATIONS,
};
use serde::{Deserialize, Serialize};

/// Where the load history stands and what the unknowns are there.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Point {
    pub step: usize,
    pub time: f64,
    pub x: Vec<f64>,
    /// Contact nodes, row by row.
    pub nodes: Vec<Node>,
    /// Is friction solved with caution, see [`crate::solver::contact::law`]?
    pub cautious: bool,
}

/// Why an increment was given up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Failure {
    /// The iteration limit was reached at this residual and penetration.
    Slow {
        residual: f64,
        penetration: f64,
        /// Contact nodes that changed in the last iteration.
        changed: usize,
        /// Where the residual and the violation of contact are largest.
        equation: usize,
        row: Option<usize>,
    },
    /// Displacements grew beyond the model, or stopped being numbers.
    Runaway {
        node: u32,
        axis: usize,
    },
    Factor(FactorError),
    Cancelled,
}

/// An increment that was given up.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopped {
    pub why: Failure,
    /// Elements that flowed as long as displacements were sound.
    pub flowing: Vec<u32>,
}

/// How the iterations of an increment have come on.
#[derive(Default)]
struct Progress {
    /// Residual after λ of cautious nodes was taken.
    begun: Option<f64>,
    /// Residual after each correction.
    residuals: Vec<f64>,
    /// Energy of each correction.
    energies: Vec<f64>,
    bounds: Bounds,
    /// For how many iterations has no node changed between open, stick and slip?
    settled: usize,
}

impl Progress {
    /// Is there no balance in sight? Beyond the plastic limit iterations wander far from it; what will be in balance
    /// is near after a wave or two, and never as far as a third of the load for half of one.
    fn is_lost(&self) -> bool {
        const HALF: usize = WAVE_ITERATIONS / 2;
        let least = |residuals: &[f64]| residuals.iter().copied().fold(f64::INFINITY, f64::min);
        if (self.residuals.last_chunk::<HALF>()).is_some_and(|all| least(all) > HOPELESS_RESIDUAL) {
            return true;
        }
        let lately = self.residuals.last_chunk::<{ 2 * WAVE_ITERATIONS }>();
        lately.is_some_and(|both| {
            let [before, now] = [&both[..WAVE_ITERATIONS], &both[WAVE_ITERATIONS..]].map(least);
            now > LOST_RESIDUAL && now > LOST_DECREASE * before
        })
    }

    /// Do corrections become smaller so steadily that it would be a waste to stop?
    fn goes_on(&self) -> bool {
        let most = |energies: &[f64]| energies.iter().copied().fold(0.0, f64::max);
        let lately = self.energies.last_chunk::<{ 2 * WAVE_ITERATIONS }>();
        lately.is_some_and(|both| {
            most(&both[WAVE_ITERATIONS..]) < STEADY_DECREASE * most(&both[..WAVE_ITERATIONS])
        })
    }
}

/// Brings `point` into balance at its time, starting from its active set; with an `springs`, into balance
/// with that, and roughly.
pub fn balance_increment(
    model: &Model,
    history: &History,
    (point, springs): (&mut Point, Option<&ProximalSprings>),
    solver: &mut LinearSolver,
    observer: &mut dyn Observer,
    counters: &mut Counters,
) -> Result<Evaluation, Stopped> {
    let controls = &model.scene.controls;
    let external = model.external(point, &history.settled);
    let reference = model.reference.max(f64::MIN_POSITIVE);
    let limit = 10.0 * extent(model.scene);
    let mut last = Iteration {
        step: point.step,
        time: point.time,
        ..Iteration::default()
    };
    let cautious = point.cautious;
    for node in &mut point.nodes {
        (node.cautious, node.switches) = (cautious, 0);
        (node.raised, node.firmer, node.missed) = (0, 0, 0.0);
    }
    let patience = match cautious || model.rows.iter().all(|r| r.law.friction == 0.0) {
        true => controls.iterations,
        false => controls.iterations.min(ITERATIONS_BEFORE_CAUTION),
    };
    // What a factor solves to is exact but for its age; parts that are put together leave what hardly resists.
    let loosest = match model.is_divided() && !model.is_soft() {
        true => 1e-6,
        false => 1e-4,
    };
    let evaluate = |point: &Point, x: &[f64], counters: &mut Counters| {
        let mut evaluation = evaluate_at(model, history, point, x, &external, counters);
        springs.inspect(|springs| springs.pull(&mut evaluation.residual, x));
        evaluation
    };
    let mut evaluation = evaluate(point, &point.x, counters);
    let mut progress = Progress::default();
    loop {
        let flowing = flowing_elements(model, &evaluation);
        let stop = |why: Failure| Stopped {
            why,
            flowing: flowing.clone(),
        };
        let residual = norm(&evaluation.residual) / reference;
        let begun = *progress.begun.get_or_insert(residual);
        let tolerance = (0.05 * controls.residual / residual).clamp(1e-12, loosest);
        let Correction {
            dx,
            directions,
            refactored,
        } = solver
            .solve(model, &evaluation, (tolerance, springs), counters)
            .map_err(|error| stop(Failure::Factor(error)))?;
        let step =
            |s: f64| -> Vec<f64> { point.x.iter().zip(&dx).map(|(x, d)| x + s * d).collect() };
        let start = dot(&evaluation.residual, &dx);
        evaluation = evaluate(point, &step(1.0), counters);
        let full = dot(&evaluation.residual, &dx);
        last.line_search = search_line(start, full, |s| {
            evaluation = evaluate(point, &step(s), counters);
            dot(&evaluation.residual, &dx)
        });
        point.x = step(last.line_search);
        counters.iterations += 1;
        last.iteration += 1;
        last.energy = start.abs() / (reference * norm(&point.x)).max(f64::MIN_POSITIVE);
        (last.directions, last.refactored) = (directions, refactored);
        if let Some((node, axis)) = runaway(model, &point.x, limit) {
            return Err(stop(Failure::Runaway { node, axis }));
        }
        last.residual = norm(&evaluation.residual) / reference;
        let before = std::mem::replace(&mut last.penetration, violation(model, point, &evaluation));
        let lingers = last.penetration > LINGERING_VIOLATION * before;
        last.changed =
            update_active_set(model, point, &evaluation, (last.iteration, &mut progress));
        count_statuses(&mut last, &evaluation);
        observer.iteration(&last);
        let settled = last.residual <= PROXIMAL_RESIDUAL && last.changed == 0;
        if springs.is_some() && (settled || last.iteration >= PROXIMAL_ITERATIONS) {
            return Ok(evaluation);
        }
        let balanced = last.changed == 0 && last.residual <= controls.residual;
        if balanced && last.penetration <= controls.penetration {
            return Ok(evaluation);
        }
        if lingers {
            let nodes = point.nodes.iter_mut();
            nodes.for_each(|node| node.firmer = node.firmer.saturating_add(1));
        }
        if balanced || last.residual <= CAUTIOUS_SHEAR_RESIDUAL * begun {
            take_shears(model, point, &evaluation);
            progress.begun = None;
        }
        progress.energies.push(last.energy);
        progress.residuals.push(last.residual);
        if observer.cancelled() {
            return Err(stop(Failure::Cancelled));
        }
        let patient = last.iteration < patience || progress.goes_on();
        let lost = much_flows(model, &flowing) && progress.is_lost();
        if lost || !patient || last.iteration >= CONVERGING_ITERATIONS_FACTOR * controls.iterations
        {
            return Err(stop(gave_up(model, point, &evaluation, &last)));
        }
        evaluation = evaluate(point, &point.x, counters);
    }
}

/// Do so many elements flow that balance is lost to the plastic limit, if it is?
pub fn much_flows(model: &Model, flowing: &[u32]) -> bool {
    flowing.len() as f64 > LIMIT_FLOW_SHARE * model.scene.mesh.hexes.len() as f64
}

/// Elements that flow.
pub fn flowing_elements(model: &Model, evaluation: &Evaluation) -> Vec<u32> {
    let flowing = evaluation.plastic.iter().filter(|answer| answer.flows());
    (flowing.map(|answer| model.yielding[answer.index])).collect()
}

/// Not settled after as many iterations as there may be.
fn gave_up(model: &Model, point: &Point, evaluation: &Evaluation, last: &Iteration) -> Failure {
    let largest = |values: &mut dyn Iterator<Item = f64>| {
        let most = values.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        most.map(|(index, _)| index)
    };
    Failure::Slow {
        residual: last.residual,
        penetration: last.penetration,
        changed: last.changed,
        equation: largest(&mut evaluation.residual.iter().map(|r| r.abs())).unwrap_or(0),
        row: largest(&mut violations(model, point, evaluation)),
    }
}

/// Tractions become multipliers, sets and friction bounds are decided anew; returns how many nodes
/// changed.
///
/// Late in an increment, nodes that have changed between stick and slip a few times become cautious.
fn update_active_set(
    model: &Model,
    point: &mut Point,
    evaluation: &Evaluation,
    (iteration, progress): (usize, &mut Progress),
) -> usize {
    let forces =
        (model.rows.iter().zip(&evaluation.contact)).map(|(r, a)| r.row.area * a.traction[0]);
    let largest = forces.fold(0.0, f64::max);
    let rows = model.rows.iter().zip(&evaluation.contact);
    let wanted: Vec<f64> = rows.map(|(r, a)| r.law.bound(&a.traction)).collect();
    let bounds = (progress.bounds).next(&point.nodes, wanted, progress.settled > 0);
    let (mut changed, mut switched) = (0, 0);
    // The longer nothing switches the nearer the slopes of slipping nodes may come to Newton's.
    let calm = progress
        .settled
        .saturating_sub(1)
        .min(usize::from(MOST_RAISED)) as u8;
    for (index, (row, node)) in model.rows.iter().zip(&mut point.nodes).enumerate() {
        let law = &row.law;
        if !node.cautious {
            node.raised = calm;
        }
        let traction = &evaluation.contact[index].traction;
        let relative = &evaluation.relative[index];
        let next = law.decide(node, traction, relative, bounds[index]);
        let least = UNCHANGED_FORCE * largest / row.row.area;
        let same = law.friction * least;
        let turned =
            !node.cautious && (1..3).any(|i| (next.multiplier[i] - traction[i]).abs() > same);
        let moved = next.closed && (law.bound(traction) - node.bound).abs() > same;
        let switches = match (node.closed, next.closed) {
            (true, true) => {
                next.sticks != node.sticks
                    && law.beyond(traction, relative, bounds[index]).abs() > same
            }
            (false, false) => false,
            _ => law.presses(node, traction, relative).abs() > least,
        };
        switched += usize::from(switches);
        changed += usize::from(switches || moved || turned);
        *node = next;
        if !node.cautious && iteration > FREE_SWITCHING_ITERATIONS && node.switches > FREE_SWITCHES
        {
            (node.cautious, node.raised) = (true, 0);
        }
    }
    progress.settled = if switched == 0 {
        progress.settled + 1
    } else {
        0
    };
    changed
}

/// Shear tractions of cautious nodes become multipliers.
fn take_shears(model: &Model, point: &mut Point, evaluation: &Evaluation) {
    let rows = model.rows.iter().zip(&evaluation.contact);
    for (node, (row, answer)) in point.nodes.iter_mut().zip(rows) {
        if node.cautious && node.closed {
            row.law.take_shear(node, answer);
        }
    }
}

fn evaluate_at(
    model: &Model,
    history: &History,
    point: &Point,
    x: &[f64],
    external: &[f64],
    counters: &mut Counters,
) -> Evaluation {
    counters.evaluations += 1;
    counters.contact_updates += model.rows.len();
    counters.plastic_updates += 8 * model.yielding.len();
    counters.friction_updates += model.rows.iter().filter(|r| r.law.friction > 0.0).count();
    let trial = Trial {
        x,
        nodes: &point.nodes,
        external,
        step: point.step,
        time: point.time,
    };
    counters
        .timers
        .time(Phase::Evaluate, || model.evaluate(history, &trial))
}

/// Largest violation of a contact condition, as a length over the largest displacement: closure
/// of a closed node, slip of a sticking one.
fn violation(model: &Model, point: &Point, evaluation: &Evaluation) -> f64 {
    let worst = violations(model, point, evaluation).fold(0.0, f64::max);
    let moved = |axes: &[u32; 3]| {
        let free = axes.iter().filter(|e| **e != FIXED);
        free.map(|e| point.x[*e as usize].powi(2)).sum::<f64>()
    };
    let travel = (model.dofs.equations.iter().map(moved))
        .fold(0.0, f64::max)
        .sqrt();
    if worst == 0.0 {
        0.0
    } else {
        worst / travel.max(f64::MIN_POSITIVE)
    }
}

/// Violation of the conditions at each contact node, as a length.
fn violations<'e>(
    model: &'e Model,
    point: &'e Point,
    evaluation: &'e Evaluation,
) -> impl Iterator<Item = f64> + 'e {
    let rows = model.rows.iter().zip(&evaluation.contact).zip(&point.nodes);
    rows.map(|((row, answer), node)| row.law.violation(node, answer))
}

fn count_statuses(last: &mut Iteration, evaluation: &Evaluation) {
    let with = |status| {
        evaluation
            .contact
            .iter()
            .filter(|a| a.status == status)
            .count()
    };
    (last.sticking, last.slipping) = (with(Status::Stick), with(Status::Slip));
    last.active = last.sticking + last.slipping;
    last.flowing = flowing_points(evaluation);
}

/// The component that left the model, if any.
fn runaway(model: &Model, x: &[f64], limit: f64) -> Option<(u32, usize)> {
    let equation = x.iter().position(|v| !(v.abs() <= limit))?;
    model
        .dofs
        .equations
        .iter()
        .enumerate()
        .find_map(|(node, axes)| {
            let axis = axes.iter().position(|e| *e as usize == equation)?;
            Some((node as u32, axis))
        })
}
