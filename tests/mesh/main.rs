//! The mesh reader on every format, on every kind of wrong file, and on noise.

mod bad_input;
mod formats;
mod never_panics;
