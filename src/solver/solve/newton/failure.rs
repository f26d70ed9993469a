//! Why an increment was given up.

use crate::solver::linear::cholesky::FactorError;

/// Why an increment was given up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Failure {
    /// The iteration limit was reached at this residual and penetration.
    Slow {
        residual: f64,
        penetration: f64,
        /// The residual that rounding may leave, where that is what is left.
        rounding: Option<f64>,
        /// Contact nodes that changed in the last iteration.
        changed: usize,
        /// Where the residual and the violation of contact are largest.
        equation: usize,
        row: Option<usize>,
    },
    /// Displacements grew beyond the model, or stopped being numbers.
    Runaway {
        node: u32,
        axis: usize,
    },
    Factor(FactorError),
    /// An element flows that is not watched, though no node of it was condensed.
    UnforeseenFlow,
    Cancelled,
}

/// An increment that was given up.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopped {
    pub why: Failure,
    /// Elements that flowed as long as displacements were sound; of unforeseen flow those to watch from now on.
    pub flowing: Vec<u32>,
}
