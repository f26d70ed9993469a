//! The book and the README: their commands run, their output is what the program prints, their cases
//! are cases, their links lead somewhere, and the reference is what the code says.
//!
//! `cargo test --release --test book -- --ignored` runs the slow blocks, too.

mod blocks;
mod keys;
mod output;
mod pages;
mod run;
