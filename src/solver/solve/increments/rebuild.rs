//! Preparing the model anew in the middle of a solution.
//!
//! The new model keeps other unknowns and other contact rows than the old one. What the solution has reached is carried
//! over in terms that do not depend on either: displacements of all nodes, plastic points by element, multipliers, slip and
//! status by contact node. A contact row that is new was open so far; its slip counts from here.

use crate::ground::geometry::Vec3;
use crate::solver::solve::checkpoint::plastic::Plastic;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::timers::Phase;
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::companion::Companion;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::model::settled::Settled;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::rows::contact_rows::contact_rows;
use std::collections::BTreeMap;

impl Run<'_, '_> {
    /// Prepares the model for what is expected now, and carries the state over. Contact is integrated again only where
    /// its reach has grown (`integrate`). The next increment starts from `guess`.
    pub(super) fn rebuild(
        &mut self,
        integrate: bool,
        guess: Option<&Point>,
    ) -> Result<(), SolveError> {
        // First everything in terms that do not depend on the model: displacements of all nodes, plastic elements.
        let key = |r: &ContactRow| (r.pair, r.row.node);
        let settled = &self.history.settled;
        let all = |p: &Point, settled: &Settled| self.model.displacement(p, settled);
        let accepted = all(&self.point, settled);
        let guess = guess.map(|p| (p.clone(), all(p, settled)));
        let of = |p: Point| (all(&p, settled), p);
        let end = self.end.take().map(of);
        let plastic = self.history.all_plastic(&self.model);
        let companion = self.companion.take().map(|c| {
            let passed: Vec<_> = c.passed.into_iter().map(of).collect();
            let place = (all(&c.point, &c.history.settled), c.point);
            let plastic = c.history.all_plastic(&self.model);
            (place, (c.history, plastic), passed)
        });
        let rows = self.model.rows.iter().enumerate();
        let old: BTreeMap<_, usize> = rows.map(|(i, r)| (key(r), i)).collect();

        // Two models at once would be twice the memory.
        self.solver.forget();
        self.model.release();
        let (scene, expected) = (self.model.scene, &self.expected);
        let tied = self.model.all.tied.clone();
        let (model, timers) = (&mut self.model, &mut self.counters.timers);
        let model = timers.time(Phase::Prepare, || {
            let rows = if integrate {
                contact_rows(scene, &tied, expected.reach)
            } else {
                let mut rows = std::mem::take(&mut model.rows);
                rows.append(&mut model.spare);
                rows.sort_by_key(key);
                rows
            };
            Model::new(scene, expected, (rows, tied))
        })?;
        // Then the same in terms of the new one. For each of its rows, the old row of the same contact node, if any.
        let map: Vec<Option<usize>> = model
            .rows
            .iter()
            .map(|r| old.get(&key(r)).copied())
            .collect();
        fn carry<T: Copy + Default>(map: &[Option<usize>], from: &[T]) -> Vec<T> {
            map.iter()
                .map(|i| i.map_or(T::default(), |i| from[i]))
                .collect()
        }
        let point = |point: &Point, u: &[[f64; 3]]| Point {
            x: model.unknowns(u),
            nodes: carry(&map, &point.nodes),
            ..*point
        };
        let carried = |(u, p): (Vec<Vec3>, Point)| point(&p, &u);
        let history = |history: &mut History, plastic: Plastic, u: &[Vec3]| {
            let rows = model.rows.iter().zip(&map);
            let fresh = |r: &ContactRow| [1, 2].map(|i| r.relative(u)[i]);
            history.slip_origin = rows
                .map(|(r, i)| i.map_or_else(|| fresh(r), |i| history.slip_origin[i]))
                .collect();
            history.slip = carry(&map, &history.slip);
            history.place_plastic(&model, plastic);
        };
        self.point = point(&self.point, &accepted);
        self.guess = guess.map(|(p, u)| point(&p, &u));
        self.end = end.map(carried);
        self.companion = companion.map(|((u, p), (mut h, plastic), passed)| {
            history(&mut h, plastic, &u);
            Companion {
                point: point(&p, &u),
                history: h,
                passed: passed.into_iter().map(carried).collect(),
            }
        });
        history(&mut self.history, plastic, &accepted);
        self.expected.divided = model.is_divided();
        self.counters.measure(&model);
        self.model = model;
        Ok(())
    }
}
