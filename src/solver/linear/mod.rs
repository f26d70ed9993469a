//! Sparse symmetric linear algebra: pattern, ordering, factor, Krylov methods.

pub mod cholesky;
pub mod krylov;
pub mod ordering;
mod pages;
pub mod preconditioner;
pub mod schwarz;
pub mod small;
pub mod sparse;
pub mod substructure;
