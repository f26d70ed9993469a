//! What is expected before anything is solved, and which contact rows that keeps.

use crate::model::scene::Scene;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::rows::least_gaps::LeastGaps;
use crate::solver::solve::start::extent::{likely_gap, reach};

impl Expected {
    /// What is known before anything is solved, the bodies of `scene` in touch.
    pub fn at_start(scene: &Scene) -> Self {
        Self {
            reach: reach(scene),
            contact: likely_gap(scene),
            flow: Vec::new(),
            divided: false,
        }
    }

    /// Splits rows into those that may close and the others.
    pub fn split(&self, rows: Vec<ContactRow>) -> (Vec<ContactRow>, Vec<ContactRow>) {
        let least = LeastGaps::of(&rows);
        rows.into_iter()
            .partition(|row| least.beyond(row) <= self.contact)
    }
}
