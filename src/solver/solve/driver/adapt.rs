//! Preparing the model anew for what was not foreseen.

use super::Run;
use super::companion::Companion;
use crate::ground::geometry::Vec3;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::foresight::{Ahead, Unforeseen};
use crate::solver::solve::history::{History, Plastic, Settled};
use crate::solver::solve::linear_solver::LinearSolver;
use crate::solver::solve::model::Model;
use crate::solver::solve::newton::Point;
use crate::solver::solve::rows::{ContactRow, contact_rows};
use crate::solver::solve::timers::Phase;
use std::collections::BTreeMap;

impl Run<'_, '_> {
    /// What happens where the model was not prepared for it, now or in the next increment.
    pub(super) fn look(&mut self, trial: &Point, next: f64) -> Unforeseen {
        let (model, history) = (&self.model, &self.history);
        let ahead = self.ahead(trial.step, next);
        let look = || Unforeseen::new(model, history, &self.sights, trial, ahead);
        self.counters.timers.time(Phase::Recover, look)
    }

    /// What is known in `step` of the flow to come, where loads grow by the share `next` in the next increment.
    pub(super) fn ahead(&self, step: usize, next: f64) -> Ahead {
        let seen = self.beside.elastic.as_ref();
        match seen.is_some_and(|end| end.state.step == step) {
            _ if self.unloads(step) => Ahead::Less,
            true => Ahead::Known,
            false => Ahead::To(1.0 + next),
        }
    }

    /// Prepares the model anew; the next increment starts from `guess`.
    pub(super) fn prepare_for(
        &mut self,
        unforeseen: Unforeseen,
        guess: Option<&Point>,
    ) -> Result<(), SolveError> {
        let (integrate, flow_only) = (unforeseen.is_approach(), unforeseen.is_flow_only());
        let known = flow_only && self.model.keeps(&unforeseen.flow);
        self.expected.learn(unforeseen);
        if known {
            self.check_more_elements();
            self.guess = guess.cloned();
        } else {
            self.rebuild(integrate, guess)?;
        }
        let c = &self.counters;
        self.observer.message(&format!(
            "{} contact nodes may close, {} elements yield: {} of {} unknowns kept",
            c.contact_rows,
            self.model.yielding.len(),
            c.kept_equations,
            c.equations,
        ));
        Ok(())
    }

    /// An element that flows only has to be looked at, where its nodes were not condensed.
    fn check_more_elements(&mut self) {
        let beside = self.companion.as_mut().map(|c| &mut c.history);
        let histories: Vec<_> = [&mut self.history].into_iter().chain(beside).collect();
        let plastic: Vec<_> = (histories.iter().map(|h| h.all_plastic(&self.model))).collect();
        self.model.watch(&self.expected.flow);
        for (history, plastic) in histories.into_iter().zip(plastic) {
            history.place_plastic(&self.model, plastic);
        }
        self.counters.watched_elements = self.model.yielding.len();
    }

    /// What has flowed is taken for elastic again, as long as it does not: while loads are taken off hardly anything
    /// flows, and elastic bodies are condensed.
    pub(super) fn settle(&mut self) -> Result<(), SolveError> {
        self.expected.flow.clear();
        self.expected.divided = false;
        self.rebuild(false, None)
    }

    /// Prepares the model for what is expected now, and carries the state over.
    pub(super) fn rebuild(
        &mut self,
        integrate: bool,
        guess: Option<&Point>,
    ) -> Result<(), SolveError> {
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
        self.solver = LinearSolver::default();
        self.model.release();
        let (scene, expected) = (self.model.scene, &self.expected);
        let (model, timers) = (&mut self.model, &mut self.counters.timers);
        let model = timers.time(Phase::Prepare, || {
            let rows = if integrate {
                contact_rows(scene, expected.reach)
            } else {
                let mut rows = std::mem::take(&mut model.rows);
                rows.append(&mut model.spare);
                rows.sort_by_key(key);
                rows
            };
            Model::new(scene, expected, rows)
        })?;
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
