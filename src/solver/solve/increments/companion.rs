//! A second solution in increments twice as large, from where something first rubs or yields.
//!
//! Plastic flow and friction are integrated along the path, and an increment is off by the
//! square of its size: all of them by a sum that halves when they do. So what the two solutions
//! differ by is what the increments of the first are worth (Richardson's estimate). Flow that turns has no mean direction here, so that both
//! differ also where they take the same increment. The companion has a history and an
//! active set of its own. It starts every increment from what the first solution found there, so
//! that a few iterations do.

use crate::solver::solve::checkpoint::companion::KeptCompanion;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::model::system::Model;

/// Where the second solution stands.
#[derive(Clone)]
pub struct Companion {
    pub point: Point,
    pub history: History,
    /// Where the first one has been since.
    pub passed: Vec<Point>,
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

/// Has a saved point as many unknowns and contact rows as `model`?
pub fn fits(point: &Point, model: &Model) -> bool {
    point.x.len() == model.dofs.len() && point.nodes.len() == model.rows.len()
}

impl KeptCompanion {
    /// For a model like the one that it was kept of; none for another one.
    pub fn place(&self, model: &Model) -> Option<Companion> {
        let rows = model.rows.len();
        let mut points = self.passed.iter().chain([&self.point]);
        let fits = points.all(|p| fits(p, model))
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
}
