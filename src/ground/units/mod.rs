//! Units: consistent systems, and quantities such as `65 kip` read into them.
//!
//! Everything from the scene down is a plain number in one consistent system. Units are read
//! here on the way in, and written here again on the way out. Angles are radians inside and
//! degrees outside. Conversion factors are exact: 1 in = 25.4 mm, 1 lbf = 4.4482216152605 N,
//! 1 kgf = 9.80665 N; converting a unit to itself leaves a number bit for bit as it was.

mod dimension;
mod labels;
mod quantity;
mod symbol;
mod system;
mod words;

pub use dimension::Dimension;
pub use labels::{Measure, UnitLabels};
pub use quantity::{Quantity, UnitError};
pub use system::UnitSystem;
