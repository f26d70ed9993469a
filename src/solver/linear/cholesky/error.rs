//! Why there is no factor.

/// Why a matrix has no factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FactorError {
    /// The system gives no more memory.
    #[error("not enough memory for the factor")]
    Memory,
    /// The pivot of this equation is not positive.
    #[error("the matrix is not positive definite at equation {equation}")]
    NotPositiveDefinite { equation: usize },
}
