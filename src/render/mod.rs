//! What people and other programs read: tables on the terminal, `summary.json`, line loads, plots, VTK
//! files, a page for browsers, and decks for other solvers.
//!
//! Nothing here knows how a scene is solved. Fields and scalars come from
//! [`results`](crate::answer::results); here they get names, units and a file format.

pub mod check;
pub mod digest;
pub mod encode;
mod error;
pub mod fields;
pub mod figures;
pub mod grid;
pub mod inp;
pub mod joint;
pub mod left_out;
pub mod line_load;
pub mod page;
pub mod paraview;
pub mod plot;
pub mod pvd;
pub mod report;
pub mod sections;
pub mod series;
pub mod summary;
pub mod table;
pub mod terminal;
pub mod text;
pub mod utilisation;
pub mod verdict;
pub mod warnings;

pub use error::OutputError;
pub use series::VtkSeries;
pub use summary::Summary;
