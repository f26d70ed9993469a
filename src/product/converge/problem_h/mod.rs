//! Problem H: a half cylinder pressed on a block, the yardstick of error against time.
//!
//! Half cylinder R = 1.5 in on a block 1.5 in deep and 3 in wide, both of E = 29500 ksi and
//! ν = 0.3, plane strain, 8.125 kip/in as uniform pressure on the cut face, frictionless. The gap
//! is taken along the contact normal on the undeformed geometry.

mod limits;
mod quantities;
mod reading;
mod shipped;

pub use limits::{
    HALF_WIDTH, LOAD, MISES_BLOCK, MISES_CYLINDER, MISES_SOURCE, POISSON, PRESSURE, YOUNG,
};
pub use quantities::quantities;
pub use reading::{Mises, ProblemHReading, read};
pub use shipped::{NAME, case, is_problem_h};
