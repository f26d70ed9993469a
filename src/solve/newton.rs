//! Newton iterations of one increment.
//!
//! Each iteration solves for the displacements at fixed contact multipliers and statuses; as soon
//! as the statuses rest, the multipliers take the contact tractions (augmented Lagrange). Both
//! together are a primal-dual active-set method on a positive definite system: it ends when
//! forces balance *and* contact conditions hold, whatever the penalty.

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
    pub multipliers: Vec<[f64; 3]>,
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
        tolerance: f64,
        counters: &mut Counters,
    ) -> Result<(Vec<f64>, usize, bool), FactorError> {
        let matrix = model.tangent(evaluation);
        let statuses: Vec<Status> = evaluation.contact.iter().map(|a| a.status).collect();
        let flowing = flowing(evaluation);
        let stale = self.made_for != (statuses.clone(), flowing) || self.factor.is_none();
        if stale {
            let mut shifted = matrix.clone();
            for start in &model.pattern.columns[..model.pattern.len()] {
                shifted.values[*start as usize] *= 1.0 + SHIFT;
            }
            let old = self.factor.take();
            self.factor = Some(model.symbolic.factorise(&model.pattern, &shifted, old)?);
            self.made_for = (statuses, flowing);
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

/// Brings `point` into balance at its time. `glued` marks the rows that the very first predictor
/// holds together (bodies float until they touch).
pub fn balance(
    model: &Model,
    history: &History,
    point: &mut Point,
    glued: &[bool],
    solver: &mut LinearSolver,
    observer: &mut dyn Observer,
    counters: &mut Counters,
) -> Result<Evaluation, Failure> {
    let controls = &model.scene.controls;
    let external = model.external(point.step, point.time);
    let reference = reference_force(model).max(f64::MIN_POSITIVE);
    let limit = 10.0 * size(model);
    let mut glued = glued;
    let mut statuses: Vec<Status> = Vec::new();
    let mut last = Iteration {
        step: point.step,
        time: point.time,
        iteration: 0,
        residual: 1.0,
        energy: 1.0,
        active: 0,
        sticking: 0,
        slipping: 0,
        penetration: 0.0,
        flowing: 0,
        directions: 0,
        refactored: false,
        line_search: 1.0,
    };
    let mut evaluation = evaluate(model, history, point, &point.x, glued, &external, counters);
    loop {
        let next: Vec<Status> = evaluation.contact.iter().map(|a| a.status).collect();
        let settled = next == statuses && glued.is_empty();
        statuses = next;
        last.residual = norm(&evaluation.residual) / reference;
        last.penetration = violation(model, point, &evaluation);
        if settled && last.penetration > controls.penetration {
            point.multipliers = evaluation.contact.iter().map(|a| a.traction).collect();
            evaluation = evaluate(model, history, point, &point.x, glued, &external, counters);
            last.residual = norm(&evaluation.residual) / reference;
        }
        count(&mut last, model, &evaluation);
        if last.iteration > 0 {
            observer.iteration(&last);
        }
        let done = last.residual <= controls.residual && last.penetration <= controls.penetration;
        if done && glued.is_empty() {
            return Ok(evaluation);
        }
        if observer.cancelled() {
            return Err(Failure::Cancelled);
        }
        if last.iteration >= controls.iterations {
            let Iteration { residual, penetration, .. } = last;
            return Err(Failure::Slow { residual, penetration });
        }
        let tolerance = (0.05 * controls.residual / last.residual).clamp(1e-12, 1e-4);
        let (dx, directions, refactored) = solver
            .solve(model, &evaluation, tolerance, counters)
            .map_err(Failure::Factor)?;
        let start = dot(&evaluation.residual, &dx);
        let step = |s: f64| -> Vec<f64> {
            point.x.iter().zip(&dx).map(|(x, d)| x + s * d).collect()
        };
        let was_glued = !glued.is_empty();
        glued = &[];
        evaluation = evaluate(model, history, point, &step(1.0), glued, &external, counters);
        last.line_search = 1.0;
        if !was_glued {
            let full = dot(&evaluation.residual, &dx);
            last.line_search = line_search::search(start, full, |s| {
                evaluation = evaluate(model, history, point, &step(s), glued, &external, counters);
                dot(&evaluation.residual, &dx)
            });
        }
        last.energy = start.abs() / (reference * norm(&point.x)).max(f64::MIN_POSITIVE);
        let x = step(last.line_search);
        point.x = x;
        last.iteration += 1;
        last.directions = directions;
        last.refactored = refactored;
        counters.iterations += 1;
        if let Some((node, axis)) = runaway(model, &point.x, limit) {
            return Err(Failure::Runaway { node, axis });
        }
    }
}

fn evaluate(
    model: &Model,
    history: &History,
    point: &Point,
    x: &[f64],
    glued: &[bool],
    external: &[f64],
    counters: &mut Counters,
) -> Evaluation {
    counters.plastic_updates += 8 * model.yielding.len();
    counters.friction_updates += model.rows.iter().filter(|r| r.friction > 0.0).count();
    let trial = Trial {
        x,
        multipliers: &point.multipliers,
        glued,
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
            d.sqrt() / row.penalty
        })
        .fold(0.0, f64::max);
    let travel = point.x.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    if worst == 0.0 { 0.0 } else { worst / travel.max(f64::MIN_POSITIVE) }
}

fn count(last: &mut Iteration, model: &Model, evaluation: &Evaluation) {
    let with = |status| evaluation.contact.iter().filter(|a| a.status == status).count();
    (last.sticking, last.slipping) = (with(Status::Stick), with(Status::Slip));
    last.active = model.rows.len() - with(Status::Open);
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
