//! The solution strategy: increments, Newton iterations, linear solves.
//!
//! Bodies are small-strain; contact is integrated once on the undeformed geometry, so that the
//! sparsity pattern, the elastic stiffness and the contact operator are made once a scene. Each
//! iteration changes only what yields, opens, sticks or slips.

mod anchor;
mod bodies;
mod bounds;
mod consistent;
mod cost;
mod counters;
mod diagnosis;
mod driver;
mod effort;
mod energy;
mod error;
mod evaluate;
mod forecast;
mod foresight;
mod history;
mod holding;
mod line_search;
mod linear_solver;
mod model;
mod newton;
mod observer;
mod params;
mod reaction;
mod restart;
mod rigid;
mod rows;
mod size;
mod spring_back;
mod start;
mod state;
mod statics;
mod timers;
mod update;

pub use counters::Counters;
pub use driver::{Solution, Unfinished, resume, solve};
pub use error::{NoBalance, SolveError};
pub use forecast::{Forecast, PairForecast, forecast};
pub use holding::{FreeMotion, free_motions};
pub use observer::{Iteration, Observer, Silent};
pub use restart::{Restart, Stranger};
pub use spring_back::spring_back;
pub use start::{Closing, close_gaps};
pub use timers::{Phase, Timers};
