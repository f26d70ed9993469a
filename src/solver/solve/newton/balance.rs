//! Newton iterations of one increment.
//!
//! Each iteration takes four steps:
//! 1. Solve the tangent system for a correction of the displacements. Multipliers, active set and friction bounds are
//!    fixed meanwhile, so that the tangent is symmetric and positive definite.
//! 2. Follow the correction as far as the line search lets it.
//! 3. Take the contact tractions as multipliers, and decide active set and friction bounds anew ([`super::active_set`]).
//! 4. Stop when forces balance, contact conditions hold *and* nothing changes any more: then the answer does not depend on
//!    the penalty.

use crate::solver::linear::krylov::{dot, norm};
use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::timers::Phase;
use crate::solver::solve::equilibrium::evaluation::{
    Evaluation, Trial, flowing_elements, much_flows,
};
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::linear_system::correction::Correction;
use crate::solver::solve::linear_system::linear_solver::LinearSolver;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::newton::active_set::{take_shears, update_active_set};
use crate::solver::solve::newton::failure::{Failure, Stopped};
use crate::solver::solve::newton::goal::Goal;
use crate::solver::solve::newton::line_search::search_line;
use crate::solver::solve::newton::progress::Progress;
use crate::solver::solve::newton::rounding::{has_stalled, rounding_forces};
use crate::solver::solve::newton::violation::{count_statuses, violation, violations};
use crate::solver::solve::observer::{Iteration, Observer};
use crate::solver::solve::params::{
    CAUTIOUS_SHEAR_RESIDUAL, CONTACT_HAS_GROWN, CONTACT_HAS_OPENED, CONTACT_OUTGROWN,
    CONVERGING_ITERATIONS_FACTOR, CORRECTION_TOLERANCE, EARLY_LOOK_RESIDUAL, FLOWING_CORRECTION,
    ITERATIONS_BEFORE_CAUTION, LINGERING_VIOLATION, LOOSEST_CORRECTION, LOOSEST_DIVIDED_CORRECTION,
    PRESSED_DIGITS, PROXIMAL_ITERATIONS, PROXIMAL_RESIDUAL, ROUGH_BALANCE, RUNAWAY_EXTENTS,
    TIGHTEST_CORRECTION,
};
use crate::solver::solve::start::extent::extent;
use crate::solver::solve::working_set::flow::{Ahead, unexpected_flow};

/// Brings `point` into balance at its time, starting from its unknowns and its active set; returns what is known there.
///
/// `goal` says what for.
///
/// # Errors
/// [`Stopped`] where no balance was found, the tangent could not be factored or the observer cancelled.
pub fn balance_increment(
    model: &Model,
    history: &History,
    (point, goal): (&mut Point, Goal),
    solver: &mut LinearSolver,
    observer: &mut dyn Observer,
    counters: &mut Counters,
) -> Result<Evaluation, Stopped> {
    let controls = &model.scene.controls;
    let springs = goal.springs();
    let roughness = if matches!(goal, Goal::Estimate) {
        ROUGH_BALANCE
    } else {
        1.0
    };
    let enough = roughness * controls.residual;
    let mut looked = false;
    let external = model.external(point, &history.settled);
    let reference = |evaluation: &Evaluation| reference(model, evaluation);
    let rounding = |point: &Point, evaluation: &Evaluation| {
        rounding_forces(model, point, &external, evaluation) / reference(evaluation)
    };
    let limit = RUNAWAY_EXTENTS * extent(model.scene);
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
    // Without caution stick and slip either settle soon or never.
    let patience = if cautious || model.rows.iter().all(|r| r.law.friction == 0.0) {
        controls.iterations
    } else {
        controls.iterations.min(ITERATIONS_BEFORE_CAUTION)
    };
    let unloads = model.scene.unloads(point.step) && !cautious;
    let loosest = if model.is_divided() && !model.is_soft() {
        LOOSEST_DIVIDED_CORRECTION
    } else {
        LOOSEST_CORRECTION
    };
    // While a load is taken off contact opens first, then what is left to flow does. Where contact grows much it is found
    // first, too.
    let mut flows = !unloads || model.yielding.is_empty();
    let contact_found = if unloads {
        CONTACT_HAS_OPENED
    } else {
        CONTACT_HAS_GROWN
    };
    let closed = closed_nodes(point);
    let evaluate = |point: &Point, (x, flows): (&[f64], bool), counters: &mut Counters| {
        let mut evaluation = evaluate_at(model, history, point, (x, flows, &external), counters);
        springs.inspect(|springs| springs.pull(&mut evaluation.residual, x));
        evaluation
    };
    let mut evaluation = evaluate(point, (&point.x, flows), counters);
    let mut progress = Progress::default();
    loop {
        let flowing = flowing_elements(model, &evaluation);
        let stop = |why: Failure| Stopped {
            why,
            flowing: flowing.clone(),
        };
        // 1. The correction, as exact as the residual will need it.
        let residual = norm(&evaluation.residual) / reference(&evaluation);
        let begun = *progress.begun.get_or_insert(residual);
        let mut tolerance =
            (CORRECTION_TOLERANCE * enough / residual).clamp(TIGHTEST_CORRECTION, loosest);
        if !flowing.is_empty() && !model.is_divided() {
            tolerance = tolerance.max(FLOWING_CORRECTION);
        }
        let goes_on = springs.is_none() && !unloads;
        let predict = || solver.predict(model, (&*point, &evaluation), counters);
        let predicted = goes_on.then(predict).flatten();
        let Correction {
            dx,
            directions,
            refactored,
        } = match predicted {
            Some(correction) => correction,
            None => solver
                .solve(model, &evaluation, (tolerance, springs), counters)
                .map_err(|error| stop(Failure::Factor(error)))?,
        };
        // 2. How far to follow it.
        let step =
            |s: f64| -> Vec<f64> { point.x.iter().zip(&dx).map(|(x, d)| x + s * d).collect() };
        let start = dot(&evaluation.residual, &dx);
        evaluation = evaluate(point, (&step(1.0), flows), counters);
        let full = dot(&evaluation.residual, &dx);
        last.line_search = search_line(start, full, |s| {
            evaluation = evaluate(point, (&step(s), flows), counters);
            dot(&evaluation.residual, &dx)
        });
        point.x = step(last.line_search);
        counters.iterations += 1;
        last.iteration += 1;
        let reference = reference(&evaluation);
        last.energy = start.abs() / (reference * norm(&point.x)).max(f64::MIN_POSITIVE);
        (last.directions, last.refactored) = (directions, refactored);
        if let Some((node, axis)) = runaway(model, &point.x, limit) {
            return Err(stop(Failure::Runaway { node, axis }));
        }
        last.residual = norm(&evaluation.residual) / reference;
        // Corrections of it would be no numbers either, and not for want of precision.
        if !last.residual.is_finite() {
            return Err(stop(gave_up(model, point, &evaluation, (&last, None))));
        }
        // 3. Multipliers, active set and friction bounds.
        let before = std::mem::replace(&mut last.penetration, violation(model, point, &evaluation));
        let lingers = last.penetration > LINGERING_VIOLATION * before;
        // What rounding leaves, where the residual is no more than that.
        let rounded = has_stalled(last.residual, &progress)
            .then(|| rounding(point, &evaluation))
            .filter(|most| last.residual <= *most);
        let known = rounded.map_or(0.0, |share| share * reference);
        last.changed = update_active_set(
            model,
            point,
            (&evaluation, known),
            (last.iteration, roughness, &mut progress),
        );
        count_statuses(&mut last, &evaluation);
        observer.iteration(&last);
        // 4. Is that enough?
        let settled = last.residual <= PROXIMAL_RESIDUAL && last.changed == 0;
        if springs.is_some() && (settled || last.iteration >= PROXIMAL_ITERATIONS) {
            return Ok(evaluation);
        }
        let balanced = last.changed == 0 && (last.residual <= enough || rounded.is_some());
        if balanced && flows && last.penetration <= roughness * controls.penetration {
            solver.balanced(point);
            return Ok(evaluation);
        }
        if let Goal::Foreseen(ahead) = goal
            && last.flowing > 0
            && !history.is_virgin()
            && last.residual <= EARLY_LOOK_RESIDUAL
            && !std::mem::replace(&mut looked, true)
            && let Some(flowing) = missed_flow(model, history, point, ahead)
        {
            let why = Failure::UnforeseenFlow;
            return Err(Stopped { why, flowing });
        }
        // A soft penalty is raised where multipliers come on slowly.
        if lingers {
            let nodes = point.nodes.iter_mut();
            nodes.for_each(|node| node.firmer = node.firmer.saturating_add(1));
        }
        // Shears of cautious nodes become multipliers only when forces all but balance: an outer loop of augmented Lagrange.
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
        let lost = (unloads || much_flows(model, &flowing)) && progress.is_lost();
        if lost || !patient || last.iteration >= CONVERGING_ITERATIONS_FACTOR * controls.iterations
        {
            let rounded = Some(rounding(point, &evaluation))
                .filter(|most| (enough..=*most).contains(&last.residual));
            return Err(stop(gave_up(model, point, &evaluation, (&last, rounded))));
        }
        let grows = || closed_nodes(point) as f64 > CONTACT_OUTGROWN * closed as f64;
        if last.iteration == 1 && last.flowing > 0 && goes_on && grows() {
            flows = false;
        } else {
            flows |= balanced || last.energy <= contact_found;
        }
        evaluation = evaluate(point, (&point.x, flows), counters);
    }
}

/// What a residual is measured by: the forces of the loads. An interference fit presses whatever the load is: next to none is in
/// balance to the digits of what presses.
fn reference(model: &Model, evaluation: &Evaluation) -> f64 {
    let pressing = PRESSED_DIGITS * pressing(model, evaluation);
    model.reference.max(pressing).max(f64::MIN_POSITIVE)
}

/// Norm of the forces with which contact presses.
fn pressing(model: &Model, evaluation: &Evaluation) -> f64 {
    let rows = model.rows.iter().zip(&evaluation.contact);
    let forces = rows.map(|(row, answer)| row.row.area * answer.traction[0]);
    norm(&forces.collect::<Vec<f64>>())
}

fn closed_nodes(point: &Point) -> usize {
    point.nodes.iter().filter(|node| node.closed).count()
}

/// What to tell of an increment that has taken as many iterations as it may: the largest residual and the worst contact
/// row.
fn gave_up(
    model: &Model,
    point: &Point,
    evaluation: &Evaluation,
    (last, rounding): (&Iteration, Option<f64>),
) -> Failure {
    let largest = |values: &mut dyn Iterator<Item = f64>| {
        let most = values.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        most.map(|(index, _)| index)
    };
    Failure::Slow {
        residual: last.residual,
        penetration: last.penetration,
        rounding,
        changed: last.changed,
        equation: largest(&mut evaluation.residual.iter().map(|r| r.abs())).unwrap_or(0),
        row: largest(&mut violations(model, point, evaluation)),
    }
}

/// Elements to watch from now on, where one of them flows at `point` and no node of theirs was condensed.
fn missed_flow(model: &Model, history: &History, point: &Point, ahead: Ahead) -> Option<Vec<u32>> {
    let u = model.displacement(point, &history.settled);
    let (flow, missed) = unexpected_flow(model, &history.settled, (point, &u), ahead);
    (missed && model.keeps(&flow)).then_some(flow)
}

/// Evaluates the model at the unknowns `x`, where steel `flows` or may not, and counts what that takes.
fn evaluate_at(
    model: &Model,
    history: &History,
    point: &Point,
    (x, flows, external): (&[f64], bool, &[f64]),
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
        flows,
    };
    counters
        .timers
        .time(Phase::Evaluate, || model.evaluate(history, &trial))
}

/// Node and axis of a displacement that has left the model, or is no number, if any.
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
