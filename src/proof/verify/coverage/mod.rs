//! Do the bars hold? Claims of ordinary runs of many bearings beside values of much finer meshes.
//!
//! Ten bearings have names; a seed draws thirty of crossed rollers (`draw`) and ten of parallel ones (`draw_lines`). The true values of a set are in a
//! file below `cases/coverage`, from two fine meshes each (`make`, `pair`, `reference`); `measure` solves a bearing
//! on the presets and judges every claim of its certificate, whatever it is about; `exclusion` asks of two meshes whether
//! their claims can both be true, which takes no true value; `page` and
//! `criteria` say what came of it.

mod bearing;
mod criteria;
pub mod draw;
mod draw_lines;
mod exclusion;
mod fine;
mod make;
mod measure;
mod page;
mod pair;
mod quantile;
pub mod reference;
mod run;
mod set;
mod solution;
mod tally;

pub use bearing::Bearing;
pub use criteria::{CoverageCriterion, criteria};
pub use measure::{BarVerdict, ClaimRecord, judge};
pub use page::{demands, line, page};
pub use pair::Truth;
pub use reference::References;
pub use run::{CoverageAnswer, CoverageRun, presets};
pub use set::Set;
pub use solution::{ClaimReading, Keep};
pub use tally::Tally;
