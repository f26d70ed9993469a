//! Steels by name: grades that come with the program, and those of a file of one's own.
//!
//! ```
//! use brinell::case::grades::Grades;
//! use brinell::ground::units::UnitSystem;
//!
//! let grades = Grades::shipped()?;
//! let steel = grades.find("S355J2")?.in_units(UnitSystem::MmNMPa, Some(80.0))?;
//! assert_eq!(steel.yield_stress, Some(325.0));
//! assert!(grades.find("S356").is_err_and(|error| error.to_string().contains("S356")));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod grade;
mod list;
mod page;
mod read;

pub use grade::{Grade, GradeError, GradeSteel, Strength};
pub use list::Grades;
pub use page::page;
