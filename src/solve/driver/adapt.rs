//! Preparing the model anew for what was not foreseen.

use super::Run;
use super::companion::Companion;
use crate::geometry::Vec3;
use crate::solve::error::SolveError;
use crate::solve::evaluate::History;
use crate::solve::foresight::Unforeseen;
use crate::solve::model::Model;
use crate::solve::newton::{LinearSolver, Point};
use crate::solve::rows::{ContactRow, contact_rows};
use crate::solve::timers::Phase;
use std::collections::BTreeMap;

impl Run<'_, '_> {
    /// What happens where the model was not prepared for it, now or in the next increment.
    pub(super) fn look(&mut self, trial: &Point, next: f64) -> Unforeseen {
        let (model, sights) = (&self.model, &self.sights);
        let look = || Unforeseen::new(model, sights, trial, 1.0 + next);
        self.counters.timers.time(Phase::Recover, look)
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
        let old = self.model.yielding.clone();
        self.model.watch(&self.expected.flow);
        self.history.watch(&old, &self.model.yielding);
        let new = &self.model.yielding;
        self.companion.iter_mut().for_each(|c| c.watch(&old, new));
        self.counters.watched_elements = self.model.yielding.len();
    }

    /// Prepares the model for what is expected now, and carries the state over.
    pub(super) fn rebuild(
        &mut self,
        integrate: bool,
        guess: Option<&Point>,
    ) -> Result<(), SolveError> {
        let key = |r: &ContactRow| (r.pair, r.row.node);
        let all = |model: &Model, p: &Point| model.displacement(&p.x, p.step, p.time);
        let accepted = all(&self.model, &self.point);
        let guess = guess.map(|p| (p.clone(), all(&self.model, p)));
        let of = |p: Point| (all(&self.model, &p), p);
        let end = self.end.take().map(of);
        let companion = self.companion.take().map(|c| {
            let passed: Vec<_> = c.passed.into_iter().map(of).collect();
            (of(c.point), c.history, passed)
        });
        let rows = self.model.rows.iter().enumerate();
        let old: BTreeMap<_, usize> = rows.map(|(i, r)| (key(r), i)).collect();

        self.expected.divided = self.model.is_divided();
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
        let history = |history: &mut History, u: &[Vec3]| {
            let rows = model.rows.iter().zip(&map);
            let fresh = |r: &ContactRow| [1, 2].map(|i| r.relative(u)[i]);
            history.slip_origin = rows
                .map(|(r, i)| i.map_or_else(|| fresh(r), |i| history.slip_origin[i]))
                .collect();
            history.slip = carry(&map, &history.slip);
            history.watch(&self.model.yielding, &model.yielding);
        };
        self.point = point(&self.point, &accepted);
        self.guess = guess.map(|(p, u)| point(&p, &u));
        self.end = end.map(carried);
        self.companion = companion.map(|((u, p), mut h, passed)| {
            history(&mut h, &u);
            Companion {
                point: point(&p, &u),
                history: h,
                passed: passed.into_iter().map(carried).collect(),
            }
        });
        history(&mut self.history, &accepted);
        self.counters.measure(&model);
        self.model = model;
        Ok(())
    }
}
