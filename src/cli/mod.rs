//! Commands: arguments and printing.

pub mod hertz;
