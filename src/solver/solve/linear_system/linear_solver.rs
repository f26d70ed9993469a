//! Corrections of Newton's method: the tangent system and the factor that is carried from iteration to iteration.
//!
//! The system itself is solved by a Krylov method in double precision. A factor only preconditions it: one that has
//! aged, brought up to date for contact, or a new one, in single precision where that is enough.

use crate::solver::linear::cholesky::FactorError;
use crate::solver::linear::krylov;
use crate::solver::linear::preconditioner::{Precision, Prepared};
use crate::solver::linear::sparse::SymmetricMatrix;
use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::timers::Phase;
use crate::solver::solve::equilibrium::evaluation::{Evaluation, flowing_points};
use crate::solver::solve::linear_system::correction::{Correction, Sought};
use crate::solver::solve::linear_system::low_rank_update::LowRankUpdate;
use crate::solver::solve::linear_system::proximal_springs::ProximalSprings;
use crate::solver::solve::linear_system::shifted_diagonal::{set_diagonal, shift_diagonal};
use crate::solver::solve::model::system::Model;
use crate::solver::solve::params::{
    AGED_CORRECTION, AGED_FACTOR_DIRECTIONS, AGED_FACTOR_FLOW_CHANGES, AGED_FACTOR_FLOW_SHARE,
    AGED_FACTOR_PAUSE, DIVIDED_CORRECTION_ERROR, FACTOR_DIRECTIONS, FRESH_FACTOR_DIRECTIONS,
    SINGLE_FACTOR_DIRECTIONS,
};

/// The linear solver with the factor that it carries from iteration to iteration.
#[derive(Default)]
pub struct LinearSolver {
    factor: Option<Prepared>,
    /// Number of flowing points that the factor was made for.
    flowing: usize,
    /// The last tangent: an increment may go on with it, and the next one takes its memory.
    matrix: SymmetricMatrix,
    /// Contact that has changed since.
    update: LowRankUpdate,
    /// Directions that its age has cost.
    spent: usize,
    /// Corrections for which an aged factor is not tried, after it was not good enough.
    distrust: usize,
    /// Of the factor: double once single has not been enough.
    precision: Precision,
    /// Step and unknowns of the balance that the last tangent belongs to, if it does to one.
    balanced: Option<(usize, Vec<f64>)>,
}

impl LinearSolver {
    /// Solves the tangent at `evaluation` for its residual, down to the share `tolerance` of it.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the tangent is not positive definite.
    pub fn solve(
        &mut self,
        model: &Model,
        evaluation: &Evaluation,
        (tolerance, springs): (f64, Option<&ProximalSprings>),
        counters: &mut Counters,
    ) -> Result<Correction, FactorError> {
        self.balanced = None;
        let last = std::mem::take(&mut self.matrix);
        let assemble = || model.tangent(evaluation, last);
        let mut matrix = counters.timers.time(Phase::Assemble, assemble);
        springs.inspect(|springs| springs.stiffen(model, &mut matrix));
        let correction = self.correct(model, evaluation, (&mut matrix, tolerance), counters);
        self.matrix = matrix;
        correction.inspect(|found| counters.krylov_directions += found.directions)
    }

    /// Takes note that the last tangent was that of a balance.
    pub fn balanced(&mut self, point: &Point) {
        self.balanced = Some((point.step, point.x.clone()));
    }

    /// The first correction of an increment that goes on from a balance in which steel flowed, with the tangent of that
    /// balance. `None` where there is no such tangent.
    ///
    /// Where the increment starts, all that has flowed is just at yield, and only rounding says whether it flows.
    pub fn predict(
        &mut self,
        model: &Model,
        (point, evaluation): (&Point, &Evaluation),
        counters: &mut Counters,
    ) -> Option<Correction> {
        let (step, x) = self.balanced.take()?;
        let goes_on = step == point.step && x == point.x;
        if self.flowing == 0 || !goes_on || model.is_divided() {
            return None;
        }
        let factor = self.factor.as_ref()?;
        let mut sought = Sought::new(evaluation, (model, AGED_CORRECTION));
        counters.linear_solves += 1;
        self.solve_with_aged(model, (factor, &self.matrix), &mut sought, counters);
        counters.krylov_directions += sought.found.directions;
        // It leads far from where its factor was made.
        self.spent = AGED_FACTOR_DIRECTIONS + 1;
        Some(sought.found)
    }

    /// [`Self::solve`] with the tangent `matrix`.
    fn correct(
        &mut self,
        model: &Model,
        evaluation: &Evaluation,
        (matrix, tolerance): (&mut SymmetricMatrix, f64),
        counters: &mut Counters,
    ) -> Result<Correction, FactorError> {
        counters.linear_solves += 1;
        counters.element_tangents += (evaluation.plastic.iter().filter(|a| a.flows())).count();
        let mut sought = Sought::new(evaluation, (model, tolerance));
        if self.try_aged(model, evaluation, matrix, &mut sought, counters) {
            return Ok(sought.found);
        }
        self.distrust = self.distrust.saturating_sub(1);
        sought.found.refactored = true;
        let mut enough = false;
        while !enough {
            let factor = self.factorise(model, matrix, counters)?;
            let multiply = |x: &[f64], y: &mut [f64]| model.pattern.multiply(matrix, x, y);
            let precondition =
                |x: &mut [f64]| (model.preconditioner).apply(&model.pattern, &factor, multiply, x);
            let is_single = factor.precision() == Precision::Single;
            let (residual, tolerance) = (&sought.residual, sought.tolerance);
            let directions = if is_single {
                SINGLE_FACTOR_DIRECTIONS
            } else {
                FACTOR_DIRECTIONS
            };
            let solve = || {
                if model.is_soft() {
                    // Every direction costs as much as the last: no more than the next iteration can use.
                    krylov::minimise(
                        multiply,
                        precondition,
                        residual,
                        DIVIDED_CORRECTION_ERROR,
                        tolerance,
                        FACTOR_DIRECTIONS,
                    )
                } else {
                    krylov::solve(multiply, precondition, residual, tolerance, directions)
                }
            };
            let (dx, outcome) = counters.timers.time(Phase::LinearSolve, solve);
            enough = sought.take(&dx, &outcome, multiply) || !is_single;
            if !enough {
                self.precision = Precision::Double;
            }
            self.factor = Some(factor);
        }
        self.flowing = flowing_points(evaluation);
        self.spent = 0;
        self.update = LowRankUpdate::new(model, evaluation);
        Ok(sought.found)
    }

    /// Solves with the factor of an earlier tangent, if there is one that is worth it. Returns whether that is enough.
    fn try_aged(
        &mut self,
        model: &Model,
        evaluation: &Evaluation,
        matrix: &SymmetricMatrix,
        sought: &mut Sought,
        counters: &mut Counters,
    ) -> bool {
        let flowing = flowing_points(evaluation);
        let changes = AGED_FACTOR_FLOW_CHANGES.max(flowing / AGED_FACTOR_FLOW_SHARE);
        let little_flow = flowing.abs_diff(self.flowing) <= changes;
        let is_worth_it = self.spent <= AGED_FACTOR_DIRECTIONS && little_flow;
        let trusted = self.distrust == 0 && !model.is_divided() && is_worth_it;
        // Renewing the parts that changed costs next to nothing.
        let Some(factor) = self.factor.as_ref().filter(|_| trusted) else {
            return false;
        };
        let update = &mut self.update;
        let prepare = || update.prepare(model, evaluation, factor);
        if !counters.timers.time(Phase::LinearSolve, prepare) {
            return false;
        }
        let enough = self.solve_with_aged(model, (factor, matrix), sought, counters);
        self.spent += (sought.found.directions).saturating_sub(FRESH_FACTOR_DIRECTIONS);
        if !enough {
            self.distrust = AGED_FACTOR_PAUSE;
        }
        enough
    }

    /// Solves for what is sought with the tangent `matrix` and the aged `factor`, to [`AGED_CORRECTION`] at least.
    /// Returns whether that is enough.
    fn solve_with_aged(
        &self,
        model: &Model,
        (factor, matrix): (&Prepared, &SymmetricMatrix),
        sought: &mut Sought,
        counters: &mut Counters,
    ) -> bool {
        let multiply = |x: &[f64], y: &mut [f64]| model.pattern.multiply(matrix, x, y);
        let precondition = |x: &mut [f64]| {
            let update = |x: &mut [f64]| self.update.correct(x);
            (model.preconditioner).solve_updated(factor, x, Some(&update));
        };
        let wanted = sought.tolerance;
        sought.tolerance = wanted.min(AGED_CORRECTION);
        let share = wanted / sought.tolerance;
        let (residual, tolerance) = (&sought.residual, sought.tolerance);
        let limit = AGED_FACTOR_DIRECTIONS;
        let solve = || krylov::solve(multiply, precondition, residual, tolerance, limit);
        let (dx, outcome) = counters.timers.time(Phase::LinearSolve, solve);
        let enough = sought.take(&dx, &outcome, multiply);
        sought.tolerance *= share;
        enough
    }

    /// A factor of `matrix`, with a diagonal that is a trifle larger.
    fn factorise(
        &mut self,
        model: &Model,
        matrix: &mut SymmetricMatrix,
        counters: &mut Counters,
    ) -> Result<Prepared, FactorError> {
        let diagonal = shift_diagonal(&model.pattern, matrix);
        let (old, precision) = (self.factor.take(), self.precision);
        let matrices = [&*matrix, &model.stiffness];
        let factorise =
            || (model.preconditioner).factorise(&model.pattern, matrices, precision, old);
        let factor = counters.timers.time(Phase::Factorise, factorise)?;
        set_diagonal(&model.pattern, matrix, &diagonal);
        counters.factorisations += 1;
        Ok(factor)
    }

    /// Forgets all factors, but not how precise they have to be.
    pub fn forget(&mut self) {
        *self = Self {
            precision: self.precision,
            ..Self::default()
        };
    }
}
