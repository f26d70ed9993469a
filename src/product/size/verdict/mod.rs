//! Does a bearing stand? Every part and every line of contact against its limit.

mod advice;
mod check;
mod design;
mod files;
mod line;
mod part;
mod position;
mod standing;
mod table;

pub use advice::Advice;
pub use check::{LimitCheck, LimitKind};
pub use design::DesignVerdict;
pub use position::Placed;
pub use standing::Standing;
pub use table::render;
