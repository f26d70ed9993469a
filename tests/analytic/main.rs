//! The closed-form solutions against independent numbers.
//!
//! Each table names the book and equation; its numbers were computed by a separate program, and
//! many of them checked there by another method (quadrature, finite elements, boundary elements).
//! Units are in, kip, ksi unless a table says otherwise.

// The tables stand as they were computed, also where a number looks like 1/√2.
#![allow(clippy::approx_constant)]

mod contact;
mod handbook;
mod hertz;
mod ring;
mod robust;
mod rules;
mod sizing;
mod statics;
mod steel;
mod subsurface;
mod tube;

/// Fails unless `value` is within the relative `tolerance` of `expected` (absolute, where
/// `expected` is zero).
#[track_caller]
fn close(what: &str, value: f64, expected: f64, tolerance: f64) {
    let scale = if expected == 0.0 { 1.0 } else { expected.abs() };
    let error = (value - expected).abs() / scale;
    assert!(
        error <= tolerance,
        "{what}: {value}, expected {expected}, off by {error:.2e}"
    );
}

/// The steel of the reference study: E = 29500 ksi, ν = 0.3.
fn steel() -> brinell::analytic::Elastic {
    brinell::analytic::Elastic::new(29500.0, 0.3).unwrap()
}
