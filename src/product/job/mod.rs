//! One case from its file to its results on disk: mesh, solve, write, summarise.

mod calculation;
mod check;
mod checkpoint;
mod clock;
mod compare;
mod error;
mod even_load;
mod export;
mod files;
mod folder;
mod hand_checks;
mod left_out;
mod limits;
mod mesh;
mod options;
mod outcome;
mod record;
mod report;
mod rollers;
mod rules;
mod run;
mod second;
mod sizing;
mod strips;
mod summarise;
mod verified;

pub use check::check;
pub use checkpoint::{Checkpoint, FILE as CHECKPOINT_FILE};
pub use error::JobError;
pub use export::{Exported, export};
pub use mesh::{FILE as MESH_FILE, find_mesh, forecast, keep_mesh, make_mesh, unknowns};
pub use options::Options;
pub use outcome::Outcome;
pub use run::{has_checkpoint, is_sized_by_lines, run, run_beside, run_on, run_on_beside};
pub use second::Twin;
pub use strips::kept as found_strips;
