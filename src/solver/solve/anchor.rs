//! Bodies that float, held back until contact holds them.
//!
//! A body that only contact holds can be anywhere while the wrong nodes are closed: it tips or slides out of
//! the model within an iteration. A weak spring from every unknown to where it stands keeps it near, as the
//! stabilisation of contact in other programs does. The springs are let go and made weaker in turns (the
//! proximal point method, Rockafellar 1976): each turn moves the bodies towards their balance, and what comes
//! out is a first guess. No spring acts in the balance that is then found from it.

use super::counters::Counters;
use super::history::History;
use super::linear_solver::LinearSolver;
use super::model::Model;
use super::newton::{Failure, Point, Stopped, balance_increment};
use super::observer::Observer;
use crate::solver::linear::sparse::SymmetricMatrix;
use crate::solver::solve::params::PROXIMAL_STIFFNESSES;

/// A spring from every unknown to where it stood.
pub struct ProximalSprings {
    stiffness: Vec<f64>,
    at: Vec<f64>,
}

impl ProximalSprings {
    /// Adds the forces of the springs to a residual at `x`.
    pub fn pull(&self, residual: &mut [f64], x: &[f64]) {
        let springs = self.stiffness.iter().zip(x).zip(&self.at);
        for (r, ((k, x), at)) in residual.iter_mut().zip(springs) {
            *r -= k * (x - at);
        }
    }

    /// Adds the springs to a tangent.
    pub fn stiffen(&self, model: &Model, matrix: &mut SymmetricMatrix) {
        for (start, k) in model.pattern.columns.iter().zip(&self.stiffness) {
            matrix.values[*start as usize] += k;
        }
    }
}

/// Moves `point` near its balance, with springs that become weaker. Only a cancelled solution is an error: what
/// else goes wrong leaves a poor guess.
pub fn approach_balance(
    model: &Model,
    history: &History,
    point: &mut Point,
    solver: &mut LinearSolver,
    observer: &mut dyn Observer,
    counters: &mut Counters,
) -> Result<(), Stopped> {
    let bodies = model.pattern.diagonal(&model.stiffness);
    for share in PROXIMAL_STIFFNESSES {
        let springs = ProximalSprings {
            stiffness: bodies.iter().map(|k| share * k).collect(),
            at: point.x.clone(),
        };
        let mut trial = point.clone();
        let held = (&mut trial, Some(&springs));
        match balance_increment(model, history, held, solver, observer, counters) {
            Ok(_) => *point = trial,
            Err(
                stopped @ Stopped {
                    why: Failure::Cancelled,
                    ..
                },
            ) => return Err(stopped),
            // Weaker springs would do worse.
            Err(_) => break,
        }
    }
    solver.forget();
    Ok(())
}
