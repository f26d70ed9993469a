//! What shows that the answers are right: claims with their sources, the closed forms that only they need, and the
//! published study.

pub mod closed_forms;
pub mod study;
pub mod verify;
