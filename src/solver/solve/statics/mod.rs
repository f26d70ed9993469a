//! The statics of rigid bodies: is there a balance at all, and if not, how do the bodies move?

pub mod bears;
pub mod friction_cone;
pub mod imbalance;
pub mod nonnegative;
pub mod ridges;
