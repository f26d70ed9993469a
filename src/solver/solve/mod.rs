//! The solution strategy: increments, Newton iterations, linear solves.
//!
//! Bodies are small-strain; contact is integrated once on the undeformed geometry, so that the
//! sparsity pattern, the elastic stiffness and the contact operator are made once a scene. Each
//! iteration changes only what yields, opens, sticks or slips.
//!
//! Layers, each of which uses only those above it:
//!
//! | layer | what it is |
//! |---|---|
//! | `params` | the tuning constants |
//! | `checkpoint/` | all that is serialised, as plain data |
//! | `observer`, `no_balance`, `error` | what the outside is told |
//! | `rows/` | contact rows: mortar operator and law |
//! | `ties/` | which components follow which others |
//! | `start/` | lengths of the scene, floating bodies in touch, what is expected |
//! | `rigid/`, `statics/` | rigid-body modes, rest and balance of rigid bodies |
//! | `condensed/` | static condensation of the bodies |
//! | `model/` | the condensed system: unknowns, stiffness, loads |
//! | `equilibrium/` | residual, tangent, history |
//! | `linear_system/` | one correction: Krylov method, aged factors |
//! | `newton/` | one increment: Newton's method, active set, proximal point |
//! | `recovery/` | a solution in the terms of the scene |
//! | `working_set/` | what happened beyond what the model was prepared for |
//! | `increments/` | steps, cut-back, a second solution, going on |
//! | `unfolding` | half-turn symmetry: one half solved, the whole told |
//! | `forecast`, `spring_back` | what needs no increments |

mod checkpoint;
mod condensed;
mod equilibrium;
mod error;
mod forecast;
mod increments;
mod linear_system;
mod model;
mod newton;
mod no_balance;
mod observer;
mod params;
mod recovery;
mod rigid;
mod rows;
mod spring_back;
mod start;
mod statics;
mod ties;
mod unfolding;
mod working_set;

pub use checkpoint::counters::Counters;
pub use checkpoint::kept::Stranger;
pub use checkpoint::restart::Restart;
pub use checkpoint::timers::{Phase, Timers};
pub use error::{Flowing, Obstacle, SolveError};
pub use forecast::{Forecast, PairForecast, forecast};
pub use increments::solution::{Solution, Unfinished};
pub use increments::solve::{resume, solve};
pub use no_balance::NoBalance;
pub use observer::{Iteration, Observer, Silent};
pub use rigid::free_motion::{FreeMotion, free_motions};
pub use spring_back::spring_back;
pub use start::close_gaps::{Closing, close_gaps};
pub use start::extent::travel;
pub use start::overlap::overlap_at_touch;
pub use ties::error::TieError;
pub use ties::unknowns::{joints, unknowns};
