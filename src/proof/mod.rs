//! What shows that the answers are right: claims with their sources, and the published study.

pub mod study;
pub mod verify;
