//! A table as data: title, headings with their units, rows of cells, notes. What a table says is decided once;
//! each backend writes it in its own way.

mod cell;
mod data;
pub mod html;
pub mod markdown;
pub mod text;

pub use cell::{Cell, Number};
pub use data::{Heading, Table};
