//! Scenes that several families solve, and what is read from their contact.

pub mod bumps;
pub mod problem_h;
pub mod profile;
pub mod rubbing;
