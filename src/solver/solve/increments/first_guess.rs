//! The first guess of an increment.

use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::newton::proximal_point::approach_balance;
use crate::solver::solve::params::FIRST_TOUCH_REACH;
use crate::solver::solve::rigid::rest::at_rest;
use crate::solver::solve::rows::least_gaps::LeastGaps;

impl Run<'_, '_> {
    /// Finds a first guess at `target` with rigid bodies, where they find rest, and prepares all rows that press
    /// there.
    pub(super) fn come_to_rest(&mut self, target: f64) -> Result<(), SolveError> {
        loop {
            let model = &self.model;
            let rows: Vec<_> = model.rows.iter().chain(&model.spare).collect();
            let factor = |name: &str| model.scene.factor(name, 0, target);
            let Some(mut rest) = at_rest(model.scene, &rows, &factor) else {
                return Ok(());
            };
            let spare = rest.nodes.split_off(model.rows.len());
            if spare.iter().any(|node| node.closed) {
                self.expected.contact = f64::INFINITY;
                self.rebuild(false, None)?;
                continue;
            }
            self.guess = Some(Point {
                x: model.unknowns(&rest.displacement),
                nodes: rest.nodes,
                ..self.point.clone()
            });
            // Where they rest they are in balance.
            self.asked = true;
            return Ok(());
        }
    }

    /// Finds a first guess at `target` with bodies that springs hold back. False where the observer cancelled.
    pub(super) fn hold_back(&mut self, step: usize, target: f64) -> bool {
        self.observer
            .message("bodies are held back by springs that become weaker, for a first guess");
        let before = self.counters.iterations;
        let mut guess = self.predict(step, target);
        self.touch(&mut guess);
        let held = approach_balance(
            &self.model,
            &self.history,
            &mut guess,
            &mut self.solver,
            self.observer,
            &mut self.counters,
        );
        self.guess = Some(guess);
        self.counters.effort.held_back += self.counters.iterations - before;
        held.is_ok()
    }

    /// First guess at `target`: where things stand, or the elastic end of the step where that is nearer and
    /// nothing has flowed yet.
    /// On along the last increment would be worse: as contact grows bodies turn towards each other, and
    /// nodes that were closing part again.
    pub(super) fn predict(&mut self, step: usize, target: f64) -> Point {
        let stands = self.stands(step);
        let virgin = self.history.is_virgin();
        let nearer = |end: &mut Point| virgin && end.step == step && 1.0 - target < target - stands;
        let guess = self.guess.take();
        let guess = guess.or_else(|| self.end.take_if(nearer));
        Point {
            step,
            time: target,
            ..guess.unwrap_or_else(|| self.point.clone())
        }
    }

    /// Where nothing presses yet, lets the rows carry that all but touch: bodies float until then.
    pub(super) fn touch(&self, trial: &mut Point) {
        let mut pressed = vec![false; self.model.scene.contacts.len()];
        for (row, node) in self.model.rows.iter().zip(&trial.nodes) {
            pressed[row.pair] |= node.closed;
        }
        let least = LeastGaps::of(&self.model.rows);
        let near = FIRST_TOUCH_REACH * self.model.reach;
        for (row, node) in self.model.rows.iter().zip(&mut trial.nodes) {
            if !pressed[row.pair] && least.beyond(row) <= near {
                (node.closed, node.sticks) = (true, true);
            }
        }
    }
}
