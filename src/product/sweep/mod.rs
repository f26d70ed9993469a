//! Many cases from one: a case, a table of parameters, and a row of results for each.
//!
//! Rows are made and read first ([`read`], [`Sweep::validate`]). Each is solved in a process of its
//! own ([`run_row`]), started here ([`run`]) or by Slurm ([`emit`]); what came of it is kept beside it
//! ([`RowRecord`]), and the table is made from that.

mod budget;
mod cells;
mod children;
mod collect;
mod error;
mod figures;
mod file;
mod local;
mod one;
mod parameter;
mod place;
mod plot;
mod prepare;
mod record;
mod rows;
mod settings;
mod slurm;
mod table;
mod validate;

pub use budget::SweepBudget;
pub use collect::collect;
pub use error::{RowError, SweepError};
pub use file::{SweepFile, parse};
pub use local::{Watcher, run};
pub use one::run as run_row;
pub use place::SweepFolder;
pub use plot::draw;
pub use record::{RowRecord, RowStatus};
pub use rows::{Sweep, SweepRow, read};
pub use settings::KeyValues;
pub use slurm::{emit, ranges};
pub use table::{CSV, JSON_LINES};
