//! Sizes of a model, for the counters.

use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::model::system::Model;

impl Counters {
    /// Sizes of a model.
    pub fn measure(&mut self, model: &Model) {
        self.equations = model.all.len();
        self.kept_equations = model.dofs.len();
        self.preparations += 1;
        self.kept_factor_entries = model.preconditioner.factor_entries();
        self.factor_entries = model.bodies.factor_entries() + self.kept_factor_entries;
        self.watched_elements = model.yielding.len();
        self.contact_rows = model.rows.len();
    }
}
