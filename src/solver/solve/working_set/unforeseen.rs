//! Working-set prediction: what happened beyond what the model was prepared for.
//!
//! Contact is integrated up to a generous initial gap, but only rows that are likely to close are kept when the bodies are
//! condensed; likewise only elements that are likely to flow. Together they are the *working set*. The answer must not
//! depend on that choice, so every solution is checked in full before it is accepted. The working set was too small where
//! - a row that was left out is penetrated,
//! - the surfaces overlap where no row acts,
//! - contact has closed all rows that were kept of a pair, and may go on beyond them,
//! - an element that was taken for elastic yields.
//!
//! Then the set is enlarged, the bodies are condensed anew, and the increment is solved again.

use crate::solver::contact::facing::Sight;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::params::{CLOSING_GROWTH, CLOSING_MARGIN, REACH_MARGIN};
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::rows::least_gaps::LeastGaps;
use crate::solver::solve::working_set::flow::{Ahead, unexpected_flow};
use crate::solver::solve::working_set::overlap::{Overlap, closed_throughout};

/// What a solution asks for beyond the working set of its model.
#[derive(Debug, Default, PartialEq)]
pub struct Unforeseen {
    /// Initial gap of the farthest place where surfaces overlap though contact was not integrated there.
    approach: Option<f64>,
    /// Initial gap, over the least one of its pair, of the farthest row that was left out though contact closes there.
    contact: Option<f64>,
    /// Elements that yield, or soon will, though the model takes them for elastic.
    pub flow: Vec<u32>,
    /// Is the solution wrong without it? Else it only helps the next increment.
    pub missed: bool,
}

impl Unforeseen {
    /// Checks all of the solution `x` of `model`, whose displacements of all nodes are `u`; `ahead` says how far flow is to
    /// be foreseen.
    pub fn new(
        model: &Model,
        history: &History,
        sights: &[Vec<Sight>],
        (x, u): (&Point, &[[f64; 3]]),
        ahead: Ahead,
    ) -> Self {
        let least = LeastGaps::of(&model.rows);
        // A row that was left out is penetrated where the relative displacement exceeds its gap.
        let beyond = |r: &&ContactRow| r.relative(u)[0] > r.row.gap;
        let closing = model.spare.iter().filter(beyond);
        let closing = closing.map(|row| least.beyond(row));
        let overlap = Overlap::find(model, sights, u);
        let narrow = closed_throughout(model, x).map(|row| least.beyond(row));
        let contact = closing
            .chain(overlap.left_out)
            .chain(narrow)
            .reduce(f64::max);
        let (flow, yields) = unexpected_flow(model, &history.settled, (x, u), ahead);
        Self {
            approach: overlap.not_integrated,
            contact,
            flow,
            missed: yields || contact.is_some() || overlap.not_integrated.is_some(),
        }
    }

    /// Nothing at all?
    pub fn is_empty(&self) -> bool {
        !self.missed && self.flow.is_empty()
    }

    /// Nothing but elements that flow?
    pub fn is_flow_only(&self) -> bool {
        self.approach.is_none() && self.contact.is_none()
    }

    /// Elements one of which flows, and nothing else.
    pub fn of_flow(flow: Vec<u32>) -> Self {
        Self {
            flow,
            missed: true,
            ..Self::default()
        }
    }

    /// Adds the contact that another look found missing.
    pub fn add_contact(&mut self, other: Self) {
        self.missed = true;
        let most = |a: Option<f64>, b| a.into_iter().chain(b).reduce(f64::max);
        self.approach = most(self.approach, other.approach);
        self.contact = most(self.contact, other.contact);
    }

    /// Does contact have to be integrated farther?
    pub fn is_approach(&self) -> bool {
        self.approach.is_some()
    }
}

impl Expected {
    /// Enlarges the working set by what was unforeseen, with some margin so that the next increments need no more.
    pub fn learn(&mut self, unforeseen: Unforeseen) {
        if let Some(approach) = unforeseen.approach {
            self.reach = REACH_MARGIN * approach;
            self.contact = self.contact.max(CLOSING_MARGIN * approach);
        }
        if let Some(gap) = unforeseen.contact {
            self.contact = (CLOSING_GROWTH * self.contact).max(CLOSING_MARGIN * gap);
        }
        self.flow.extend(unforeseen.flow);
        self.flow.sort_unstable();
    }
}
