//! Does a bearing stand? Every part and every line of contact against its limit.

mod advice;
mod check;
mod design;
mod files;
mod limits;
mod line;
mod part;
mod position;
mod standing;
mod table;

pub use advice::{Advice, short_by_at_most};
pub use check::{LimitCheck, LimitKind};
pub use design::DesignVerdict;
pub use files::{forget_verdict, write_verdict};
pub use limits::Limits;
pub use position::Placed;
pub use standing::SizeStanding;
pub use table::{Checked, Design, page, render, render_checked};
