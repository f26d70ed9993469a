//! What an iteration costs, reckoned from counted operations: seconds of a machine of two cores. Only ratios decide.
//!
//! Measured on bearings of 25 to 220 thousand unknowns, elastic and plastic.

/// Multiplications a second of a sparse factor in single precision, with dense blocks of a thousand and more,
const SINGLE: f64 = 4.5e10;
/// and in double, in which bodies are condensed: 2.4 to 2.9e10.
const DOUBLE: f64 = 2.5e10;
/// Seconds a direction and entry of such a factor, all else of an iteration with it; 1.5 to 2.1e-9 in double.
const ENTRY: f64 = 1.2e-9;
/// New factors an iteration: the others bring an old one up to date. 0.3 to 0.5 where steel flows.
const RENEWED: f64 = 0.4;
/// Directions an iteration.
const DIRECTIONS: f64 = 5.0;
/// Seconds an unknown of a divided model: 6.5e-6 to 1.6e-5, in 12 to 30 directions; and there are 1.2 to 1.5 times as
/// many iterations as with one factor, which solves to more digits.
const DIVIDED: f64 = 1.6e-5;
/// Iterations before bodies are condensed once more.
const ITERATIONS: f64 = 15.0;

/// Of a condensed model whose factor takes `work` multiplications and has so many `entries`, where condensing took
/// `condensing` multiplications.
pub fn direct(work: f64, entries: f64, condensing: f64) -> f64 {
    RENEWED * work / SINGLE + condensing / ITERATIONS / DOUBLE + DIRECTIONS * ENTRY * entries
}

/// Of a divided model.
pub fn divided(unknowns: usize) -> f64 {
    DIVIDED * unknowns as f64
}

/// Multiplications that eliminating the inside of a compact body of so many factor entries takes, from bodies of 1.7 to
/// 40 million entries (within a quarter).
pub fn work_of(entries: f64) -> f64 {
    1.7 * entries.powf(4.0 / 3.0)
}
