//! What an iteration costs, reckoned from counted operations: seconds of a machine of two cores.

use crate::solver::solve::params::{
    DIRECTIONS_PER_ITERATION, DOUBLE_FACTOR_RATE, FACTORS_PER_ITERATION,
    ITERATIONS_PER_CONDENSATION, SECONDS_PER_DIVIDED_UNKNOWN, SECONDS_PER_FACTOR_ENTRY,
    SINGLE_FACTOR_RATE,
};

/// Of a condensed model whose factor takes `work` multiplications and has so many `entries`, where condensing took
/// `condensing` multiplications.
pub fn seconds_direct(work: f64, entries: f64, condensing: f64) -> f64 {
    FACTORS_PER_ITERATION * work / SINGLE_FACTOR_RATE
        + condensing / ITERATIONS_PER_CONDENSATION / DOUBLE_FACTOR_RATE
        + DIRECTIONS_PER_ITERATION * SECONDS_PER_FACTOR_ENTRY * entries
}

/// Of a divided model.
pub fn seconds_divided(unknowns: usize) -> f64 {
    SECONDS_PER_DIVIDED_UNKNOWN * unknowns as f64
}

/// Multiplications that eliminating the inside of a compact body of so many factor entries takes, from bodies of 1.7 to
/// 40 million entries (within a quarter).
pub fn condensation_work(entries: f64) -> f64 {
    1.7 * entries.powf(4.0 / 3.0)
}
