//! From nodal displacement components to equations.

mod conflict;
mod cut;
mod element;
mod fixed;
mod further;
mod map;
mod number;
mod owner;
mod owners;
mod prescribed;

pub use conflict::Conflict;
pub use element::ElementTerms;
pub use fixed::FIXED;
pub use further::Further;
pub use map::DofMap;
pub use owner::Owner;
pub use owners::{Owners, owners};
pub use prescribed::{Prescribed, Source};
