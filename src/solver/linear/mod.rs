//! Sparse symmetric linear algebra: pattern, ordering, factor, Krylov methods.
//!
//! Every matrix of the solver is symmetric, with friction and with plastic flow too (see
//! [`contact::law`](super::contact::law)): only its lower triangle is stored.

pub mod cholesky;
pub mod krylov;
pub mod ordering;
mod pages;
pub mod preconditioner;
pub mod schwarz;
pub mod small;
pub mod sparse;
pub mod substructure;
