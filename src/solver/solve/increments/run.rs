//! A solution under way.

use crate::model::state::State;
use crate::solver::contact::facing::Sight;
use crate::solver::contact::law::Node;
use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::checkpoint::kept::Kept;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::restart::Beside;
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::increments::companion::Companion;
use crate::solver::solve::linear_system::linear_solver::LinearSolver;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::observer::Observer;
use std::sync::Arc;

/// All that a solution carries from increment to increment.
pub struct Run<'a, 'o> {
    pub model: Model<'a>,
    /// Where the sides of each pair face each other.
    pub sights: Vec<Vec<Sight>>,
    /// The working set that the model was prepared for.
    pub expected: Expected,
    pub observer: &'o mut dyn Observer,
    pub solver: LinearSolver,
    pub history: History,
    /// In increments twice as large; none where it is not wanted or has not converged.
    pub companion: Option<Companion>,
    /// What is found beside the solution itself.
    pub beside: Beside,
    /// The last accepted point.
    pub point: Point,
    /// A better first guess than the last accepted state.
    pub guess: Option<Point>,
    /// The end of the step if no steel yielded, from which its last increment starts.
    pub end: Option<Point>,
    pub counters: Counters,
    /// Has statics been asked about this increment?
    pub asked: bool,
    /// Were bodies held back by springs for its first guess?
    pub held_back: bool,
    /// Share of the step that the next increment tries.
    pub size: f64,
    /// Has it been cut back?
    pub cut: bool,
    /// Was the first step tried as a whole, after all that is smaller had failed?
    pub tried_whole: bool,
    /// The ends of the finished steps.
    pub states: Vec<State>,
    /// The last accepted state; empty before the first.
    pub last: State,
    /// What the states of the finished steps and the last one can be restored from.
    pub finished: Vec<Arc<Kept>>,
}

impl<'a, 'o> Run<'a, 'o> {
    pub(super) fn new(
        model: Model<'a>,
        expected: Expected,
        observer: &'o mut dyn Observer,
    ) -> Self {
        let rows = model.rows.len();
        let mut counters = Counters::default();
        counters.measure(&model);
        let history = History::virgin(&model);
        let point = Point {
            step: 0,
            time: 0.0,
            x: vec![0.0; model.dofs.len()],
            nodes: vec![Node::default(); rows],
            cautious: false,
        };
        let wanted = model.scene.controls.increment_error;
        Self {
            expected: Expected {
                divided: model.is_divided(),
                ..expected
            },
            companion: wanted.then(|| Companion::at(&point, &history)),
            beside: Beside::default(),
            history,
            point,
            sights: Vec::new(),
            solver: LinearSolver::default(),
            guess: None,
            end: None,
            asked: false,
            held_back: false,
            size: 0.0,
            cut: false,
            tried_whole: false,
            states: Vec::new(),
            last: State::default(),
            finished: Vec::new(),
            counters,
            model,
            observer,
        }
    }

    pub(super) fn untouched(&self) -> Vec<String> {
        let pairs = self.model.scene.contacts.iter().enumerate();
        pairs
            .filter(|(index, _)| {
                let mut rows = self.model.rows.iter().chain(&self.model.spare);
                !rows.any(|r| r.pair == *index)
            })
            .map(|(_, pair)| pair.name.clone())
            .collect()
    }
}
