//! Saving an accepted increment.

use crate::solver::solve::checkpoint::companion::KeptCompanion;
use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::checkpoint::kept::Kept;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::restart::{Beside, Restart, Touching};
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::model::system::Model;
use std::sync::Arc;

impl Run<'_, '_> {
    pub(super) fn checkpoint(&mut self) -> Result<(), SolveError> {
        let (model, history, point) = (&self.model, &self.history, &self.point);
        let (finished, last, size) = (&self.finished, &self.last, self.size);
        let (expected, counters) = (&self.expected, &self.counters);
        let (companion, beside, end) = (self.companion.as_ref(), &self.beside, &self.end);
        let make = || {
            let last = Kept::new(last, history.all_plastic(model));
            let beside = Beside {
                end: end.clone(),
                ..beside.clone()
            };
            Restart::new(
                model,
                history,
                point,
                (finished, last),
                (beside, companion.map(|c| c.keep(model))),
                (expected.clone(), size),
                *counters,
            )
        };
        self.observer
            .checkpoint(&make)
            .map_err(SolveError::Observer)
    }
}

impl Restart {
    /// Where the solution stands that goes on after `last`, in increments of `size`.
    pub(in crate::solver::solve) fn new(
        model: &Model,
        history: &History,
        point: &Point,
        (finished, last): (&[Arc<Kept>], Kept),
        (beside, companion): (Beside, Option<KeptCompanion>),
        (expected, size): (Expected, f64),
        counters: Counters,
    ) -> Self {
        let rows = model.rows.iter().enumerate();
        Self {
            finished: finished.to_vec(),
            last,
            beside,
            companion,
            touching: rows
                .map(|(i, r)| Touching {
                    pair: r.pair as u32,
                    node: r.row.node,
                    law: point.nodes[i],
                    slip_origin: history.slip_origin[i],
                    slip: history.slip[i],
                })
                .collect(),
            expected,
            size,
            cautious: point.cautious,
            counters,
        }
    }
}
