//! What the tables of a run say, each once: the terminal and the page write the same ones.

mod bodies;
mod certificate;
mod compared;
mod contact;
mod hand_checks;
mod load_line;
mod rules;
mod sizing;
mod slices;
mod statics;
mod steps;
mod ties;
mod unloaded;

pub use bodies::bodies;
pub use certificate::certificate;
pub use compared::compared;
pub use contact::{contact, lines};
pub use hand_checks::hand_checks;
pub use load_line::load_line;
pub use rules::{rule_table, rules};
pub use sizing::sizing;
pub use slices::slices;
pub use statics::{checks, statics};
pub use steps::steps;
pub use ties::ties;
pub use unloaded::unloaded;
