//! Newton iterations of one increment.
//!
//! Each iteration solves for the displacements with the contact statuses fixed; then the
//! multipliers take the contact tractions (augmented Lagrange) and the statuses are decided anew.
//! Both together are a primal-dual active-set method on a positive definite system: it ends when
//! forces balance, contact conditions hold *and* statuses rest, whatever the penalty.

use super::evaluate::{Evaluation, History, Trial};
use super::line_search;
use super::model::{Counters, Model};
use super::observer::{Iteration, Observer};
use crate::contact::law::Status;
use crate::linear::cholesky::{Factor, FactorError};
use crate::linear::krylov::{self, dot, norm};

/// Where the load history stands and what the unknowns are there.
#[derive(Clone)]
pub struct Point {
    pub step: usize,
    pub time: f64,
    pub x: Vec<f64>,
    /// Contact tractions and statuses, row by row.
    pub multipliers: Vec<[f64; 3]>,
    pub statuses: Vec<Status>,
}

/// Why an increment was given up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Failure {
    /// The iteration limit was reached at this residual and penetration.
    Slow { residual: f64, penetration: f64 },
    /// Displacements grew beyond the model, or stopped being numbers.
    Runaway { node: u32, axis: usize },
    Factor(FactorError),
    Cancelled,
}

/// The linear solver with the factor that it carries from iteration to iteration.
#[derive(Default)]
pub struct LinearSolver {
    factor: Option<Factor>,
    /// Statuses and number of flowing points that the factor was made for.
    made_for: (Vec<Status>, usize),
}

/// Share of the diagonal that is added to the matrix *before it is factored*: it keeps the factor
/// of a body that is free for a moment positive definite. The system that is solved does not
/// contain it, so that no force ever passes through it.
const SHIFT: f64 = 1e-10;

impl LinearSolver {
    /// Solves the tangent at `evaluation` for its residual.
    fn solve(
        &mut self,
        model: &Model,
        evaluation: &Evaluation,
        statuses: &[Status],
        tolerance: f64,
        counters: &mut Counters,
    ) -> Result<(Vec<f64>, usize, bool), FactorError> {
        let matrix = model.tangent(evaluation, statuses);
        let flowing = flowing(evaluation);
        let stale = self.made_for.0 != statuses || self.made_for.1 != flowing || self.factor.is_none();
        if stale {
            let mut shifted = matrix.clone();
            for start in &model.pattern.columns[..model.pattern.len()] {
                shifted.values[*start as usize] *= 1.0 + SHIFT;
            }
            let old = self.factor.take();
            self.factor = Some(model.symbolic.factorise(&model.pattern, &shifted, old)?);
            self.made_for = (statuses.to_vec(), flowing);
            counters.factorisations += 1;
        }
        let Some(factor) = &self.factor else { return Err(FactorError::Memory) };
        let unsymmetric = model.is_unsymmetric(evaluation);
        let (dx, outcome) = krylov::solve(
            |x, y| {
                model.pattern.multiply(&matrix, x, y);
                if unsymmetric {
                    model.add_coupling(evaluation, x, y);
                }
            },
            |x| model.symbolic.solve(factor, x),
            &evaluation.residual,
            tolerance,
            60,
        );
        counters.linear_solves += 1;
        counters.krylov_directions += outcome.iterations;
        Ok((dx, outcome.iterations, stale))
    }
}

fn flowing(evaluation: &Evaluation) -> usize {
    evaluation.plastic.iter().flat_map(|a| &a.flows).filter(|f| f.is_some()).count()
}

/// Brings `point` into balance at its time, starting from its statuses.
pub fn balance(
    model: &Model,
    history: &History,
    point: &mut Point,
    solver: &mut LinearSolver,
    observer: &mut dyn Observer,
    counters: &mut Counters,
) -> Result<Evaluation, Failure> {
    let controls = &model.scene.controls;
    let external = model.external(point.step, point.time);
    let reference = reference_force(model).max(f64::MIN_POSITIVE);
    let limit = 10.0 * size(model);
    let mut last = Iteration { step: point.step, time: point.time, ..Iteration::default() };
    let mut evaluation = evaluate(model, history, point, &point.x, &external, counters);
    loop {
        let residual = norm(&evaluation.residual) / reference;
        let tolerance = (0.05 * controls.residual / residual).clamp(1e-12, 1e-4);
        let (dx, directions, refactored) = solver
            .solve(model, &evaluation, &point.statuses, tolerance, counters)
            .map_err(Failure::Factor)?;
        let step =
            |s: f64| -> Vec<f64> { point.x.iter().zip(&dx).map(|(x, d)| x + s * d).collect() };
        let start = dot(&evaluation.residual, &dx);
        evaluation = evaluate(model, history, point, &step(1.0), &external, counters);
        // With the statuses fixed only yielding is left for the line search to see.
        last.line_search = if evaluation.plastic.is_empty() {
            1.0
        } else {
            let full = dot(&evaluation.residual, &dx);
            line_search::search(start, full, |s| {
                evaluation = evaluate(model, history, point, &step(s), &external, counters);
                dot(&evaluation.residual, &dx)
            })
        };
        point.x = step(last.line_search);
        counters.iterations += 1;
        last.iteration += 1;
        last.energy = start.abs() / (reference * norm(&point.x)).max(f64::MIN_POSITIVE);
        (last.directions, last.refactored) = (directions, refactored);
        if let Some((node, axis)) = runaway(model, &point.x, limit) {
            return Err(Failure::Runaway { node, axis });
        }
        last.residual = norm(&evaluation.residual) / reference;
        last.penetration = violation(model, point, &evaluation);
        last.changed = update_contact(model, point, &evaluation);
        count(&mut last, model, point, &evaluation);
        observer.iteration(&last);
        let balanced = last.residual <= controls.residual;
        if balanced && last.changed == 0 && last.penetration <= controls.penetration {
            return Ok(evaluation);
        }
        if observer.cancelled() {
            return Err(Failure::Cancelled);
        }
        if last.iteration >= controls.iterations {
            let Iteration { residual, penetration, .. } = last;
            return Err(Failure::Slow { residual, penetration });
        }
        evaluation = evaluate(model, history, point, &point.x, &external, counters);
    }
}

/// Multipliers take the tractions, statuses are decided anew; returns how many changed.
fn update_contact(model: &Model, point: &mut Point, evaluation: &Evaluation) -> usize {
    let mut changed = 0;
    for (index, row) in model.rows.iter().enumerate() {
        let traction = evaluation.contact[index].traction;
        let status = row.law.decide(&traction, &evaluation.relative[index]);
        if status != point.statuses[index] {
            changed += 1;
        }
        point.statuses[index] = status;
        point.multipliers[index] = if status == Status::Open { [0.0; 3] } else { traction };
    }
    changed
}

fn evaluate(
    model: &Model,
    history: &History,
    point: &Point,
    x: &[f64],
    external: &[f64],
    counters: &mut Counters,
) -> Evaluation {
    counters.plastic_updates += 8 * model.yielding.len();
    counters.friction_updates += model.rows.iter().filter(|r| r.law.friction > 0.0).count();
    let trial = Trial {
        x,
        multipliers: &point.multipliers,
        statuses: &point.statuses,
        external,
        step: point.step,
        time: point.time,
    };
    model.evaluate(history, &trial)
}

/// Largest distance between a traction and its multiplier, as a length, over the largest
/// displacement: zero exactly where all contact conditions hold.
fn violation(model: &Model, point: &Point, evaluation: &Evaluation) -> f64 {
    let rows = model.rows.iter().zip(&evaluation.contact).zip(&point.multipliers);
    let worst = rows
        .map(|((row, answer), multiplier)| {
            let d: f64 = (0..3).map(|i| (answer.traction[i] - multiplier[i]).powi(2)).sum();
            d.sqrt() / row.law.penalty
        })
        .fold(0.0, f64::max);
    let travel = point.x.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    if worst == 0.0 { 0.0 } else { worst / travel.max(f64::MIN_POSITIVE) }
}

fn count(last: &mut Iteration, model: &Model, point: &Point, evaluation: &Evaluation) {
    let with = |code| point.statuses.iter().filter(|s| s.code() == code).count();
    (last.sticking, last.slipping) = (with(1), with(2));
    last.active = model.rows.len() - with(0);
    last.flowing = flowing(evaluation);
}

/// The largest force that the steps apply.
fn reference_force(model: &Model) -> f64 {
    (0..model.scene.steps.len()).map(|s| norm(&model.external(s, 1.0))).fold(0.0, f64::max)
}

/// Diagonal of the box around the model.
pub fn size(model: &Model) -> f64 {
    let points = &model.scene.mesh.points;
    let span = |axis: usize| {
        let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| {
            (l.min(p[axis]), h.max(p[axis]))
        });
        high - low
    };
    span(0).hypot(span(1)).hypot(span(2))
}

/// The component that left the model, if any.
fn runaway(model: &Model, x: &[f64], limit: f64) -> Option<(u32, usize)> {
    let equation = x.iter().position(|v| !(v.abs() <= limit))?;
    model.dofs.equations.iter().enumerate().find_map(|(node, axes)| {
        let axis = axes.iter().position(|e| *e as usize == equation)?;
        Some((node as u32, axis))
    })
}
