//! A second solution in increments twice as large, from where something first yields.
//!
//! Plastic flow, and friction with it, are integrated along the path, and an increment is off by the
//! square of its size: all of them by a sum that halves when they do. So what the two solutions
//! differ by is what the increments of the first are worth. The companion has a history and an
//! active set of its own. It starts every increment from what the first solution found there, so
//! that a few iterations do.

use super::Run;
use crate::solver::solve::history::{History, Plastic};
use crate::solver::solve::model::Model;
use crate::solver::solve::newton::{Failure, Point, Stopped, balance_increment};
use crate::solver::solve::restart::Kept;
use crate::solver::solve::state::recovered_state;
use serde::{Deserialize, Serialize};
use std::mem::take;

/// Where the second solution stands.
#[derive(Clone)]
pub struct Companion {
    pub point: Point,
    pub history: History,
    /// Where the first one has been since.
    pub passed: Vec<Point>,
}

/// The same for a checkpoint.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct KeptCompanion {
    point: Point,
    plastic: Plastic,
    slip_origin: Vec<[f64; 2]>,
    slip: Vec<f64>,
    passed: Vec<Point>,
}

impl Companion {
    /// Where the first solution stands.
    pub fn at(point: &Point, history: &History) -> Self {
        Self {
            point: point.clone(),
            history: history.clone(),
            passed: Vec::new(),
        }
    }

    pub fn keep(&self, model: &Model) -> KeptCompanion {
        KeptCompanion {
            point: self.point.clone(),
            plastic: self.history.all_plastic(model),
            slip_origin: self.history.slip_origin.clone(),
            slip: self.history.slip.clone(),
            passed: self.passed.clone(),
        }
    }
}

impl KeptCompanion {
    /// For a model like the one that it was kept of; none for another one.
    pub fn place(&self, model: &Model) -> Option<Companion> {
        let (unknowns, rows) = (model.dofs.len(), model.rows.len());
        let mut points = self.passed.iter().chain([&self.point]);
        let fits = points.all(|p| p.x.len() == unknowns && p.nodes.len() == rows)
            && self.slip_origin.len() == rows
            && self.slip.len() == rows;
        fits.then(|| {
            let slip = (self.slip_origin.clone(), self.slip.clone());
            Companion {
                point: self.point.clone(),
                history: History::new(model, self.plastic.clone(), slip),
                passed: self.passed.clone(),
            }
        })
    }

    /// Its steps and its plastic elements, for whoever checks what was read.
    pub fn contents(&self) -> impl Iterator<Item = (usize, u32)> {
        let points = self.passed.iter().chain([&self.point]);
        let steps = points.map(|p| (p.step, 0));
        steps.chain(self.plastic.iter().map(|(element, _)| (0, *element)))
    }
}

impl Run<'_, '_> {
    /// Takes note of an accepted increment.
    pub(super) fn accompany(&mut self) {
        let virgin = self.history.is_virgin();
        let Some(companion) = &mut self.companion else {
            return;
        };
        if virgin {
            // Both are the same as long as nothing has yielded.
            *companion = Companion::at(&self.point, &self.history);
        } else {
            companion.passed.push(self.point.clone());
        }
    }

    /// Brings the companion to the end of the step. Returns false where the observer cancelled.
    pub(super) fn bring_companion(&mut self) -> bool {
        let Some(mut companion) = self.companion.take() else {
            return true;
        };
        let passed = take(&mut companion.passed);
        // Every second one; the last in any case.
        let odd = passed.len() % 2;
        let ends = passed.into_iter().enumerate().filter(|(i, _)| i % 2 != odd);
        let mut evaluation = None;
        for (_, mut trial) in ends {
            let before = self.counters.iterations;
            let balanced = balance_increment(
                &self.model,
                &companion.history,
                (&mut trial, None),
                &mut self.solver,
                self.observer,
                &mut self.counters,
            );
            self.counters.effort.second += self.counters.iterations - before;
            match balanced {
                Ok(found) => {
                    companion.history.advance(&mut trial, &found);
                    companion.point = trial;
                    evaluation = Some(found);
                }
                Err(Stopped {
                    why: Failure::Cancelled,
                    ..
                }) => return false,
                Err(_) => {
                    self.observer.message(
                        "the second solution, in increments twice as large, did not converge: what the \
                         increments are worth is not known",
                    );
                    return true;
                }
            }
        }
        if let Some(evaluation) = evaluation {
            let (model, history) = (&self.model, &companion.history);
            let with = (&evaluation, self.sights.as_slice());
            let state = recovered_state(model, history, &companion.point, with);
            let plastic = history.all_plastic(model);
            self.beside.doubled.push(Kept::new(&state, plastic));
        }
        self.companion = Some(companion);
        true
    }
}
