//! Going on from a saved increment.

use crate::solver::contact::law::Node;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::restart::{Restart, Touching};
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::increments::companion::fits;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::model::system::Model;
use std::collections::BTreeMap;

impl Run<'_, '_> {
    /// Takes up what a run before has left.
    pub(super) fn go_on_from(&mut self, restart: &Restart) {
        let timers = self.counters.timers;
        (self.point, self.history) = restart.place(&self.model);
        self.counters = restart.counters;
        self.counters.measure(&self.model);
        self.counters.timers.add(&timers);
        self.size = restart.size;
        self.finished.clone_from(&restart.finished);
        let model = &self.model;
        self.states = (restart.finished.iter().map(|kept| kept.restore(model))).collect();
        self.last = restart.last.restore(model);
        self.beside = restart.beside.clone();
        self.end = (self.beside.end.take()).filter(|end| fits(end, model));
        self.companion = (restart.companion.as_ref()).and_then(|kept| kept.place(model));
        if restart.companion.is_some() && self.companion.is_none() {
            self.observer.message(
                "the second solution does not fit the model any more: what increments are worth is not known from here",
            );
        }
        let (step, time) = restart.after();
        self.observer.message(&format!(
            "goes on after {:.3} % of step `{}`",
            100.0 * time,
            model.scene.steps[step].name
        ));
    }
}

impl Restart {
    /// Unknowns, contact and history, for a model that was prepared for what is expected here.
    pub(in crate::solver::solve) fn place(&self, model: &Model) -> (Point, History) {
        let displacement = &self.last.state.displacement;
        let known: BTreeMap<(usize, u32), &Touching> = (self.touching.iter())
            .map(|t| ((t.pair as usize, t.node), t))
            .collect();
        let touching: Vec<Touching> = (model.rows.iter())
            .map(|r| match known.get(&(r.pair, r.row.node)) {
                Some(known) => **known,
                None => {
                    let [_, s, t] = r.relative(displacement);
                    Touching {
                        pair: r.pair as u32,
                        node: r.row.node,
                        law: Node::default(),
                        slip_origin: [s, t],
                        slip: 0.0,
                    }
                }
            })
            .collect();
        let slip = touching.iter().map(|t| (t.slip_origin, t.slip)).unzip();
        let history = History::new(model, self.last.plastic.clone(), slip);
        let point = Point {
            step: self.last.state.step,
            time: self.last.state.time,
            x: model.unknowns(displacement),
            nodes: touching.iter().map(|t| t.law).collect(),
            cautious: self.cautious,
        };
        (point, history)
    }
}
