//! How large the next increment may be.

use crate::solver::solve::increments::run::Run;
use crate::solver::solve::params::{EQUAL_STEP_SHARES, NO_LOAD_LEFT, UNLOADED_LOAD_LEFT};
use crate::solver::solve::start::can_yield::can_yield;

impl Run<'_, '_> {
    /// Share of a step that its first increment tries.
    pub(super) fn first_increment(&self) -> f64 {
        let scene = self.model.scene;
        let yields = (0..scene.mesh.hexes.len() as u32).any(|e| can_yield(scene, e));
        let path_matters = yields || self.model.scene.rubs();
        if path_matters {
            scene.controls.first_increment
        } else {
            1.0
        }
    }

    /// Where the next increment has to end at the latest.
    pub(super) fn planned_end(&self, step: usize, time: f64) -> f64 {
        let plan = self.beside.plan.iter().filter(|plan| plan.step == step);
        let mut ends = plan.flat_map(|plan| plan.ends.iter().copied());
        ends.find(|end| *end > time + EQUAL_STEP_SHARES)
            .unwrap_or(1.0)
    }

    /// The share of the step in which all loads fall to a third. Contact shrinks with the load: what
    /// is solved in one increment from full load to next to none changes beyond recognition.
    pub(super) fn relief(&self, step: usize, time: f64) -> f64 {
        let scene = self.model.scene;
        let loads = scene.acting_names().into_iter().map(|name| {
            let at = |time| scene.factor(name, step, time).abs();
            [0.0, time, 1.0].map(at)
        });
        loads
            .filter(|[before, now, _]| *now > NO_LOAD_LEFT * before)
            .map(|[_, now, then]| {
                if then < UNLOADED_LOAD_LEFT * now {
                    (1.0 - time) * (1.0 - UNLOADED_LOAD_LEFT) * now / (now - then)
                } else {
                    f64::INFINITY
                }
            })
            .reduce(f64::max)
            .unwrap_or(f64::INFINITY)
    }

    /// Share of a step that is done.
    pub(super) fn stands(&self, step: usize) -> f64 {
        if self.point.step == step {
            self.point.time
        } else {
            0.0
        }
    }
}
