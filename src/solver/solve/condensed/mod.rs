//! Static condensation: bodies seen from where contact or plastic flow acts on them, and what that costs.

pub mod assembly;
pub mod condense;
pub mod cost;
pub mod groups;
pub mod size;
pub mod static_condensation;
pub mod transfer;
