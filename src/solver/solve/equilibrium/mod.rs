//! Residual, tangent and history: whether forces balance at a trial displacement.

pub mod evaluation;
pub mod history;
pub mod residual;
pub mod tangent;
