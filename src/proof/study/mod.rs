//! The published study, rerun: its cases on the coarse mesh of its kind and on resolved ones.

mod cells;
mod check;
mod compare;
mod member;
mod page;
mod quantities;

pub use check::{Difference, check};
pub use member::{MEMBERS, Member, Meshes, NAME, SolvedMember};
pub use page::{PAGE, PagePart, parts, write, write_pictures};
