//! What an iteration costs, reckoned from counted operations: seconds of a machine of two cores.

use crate::solver::solve::params::{
    DIRECTIONS_PER_ITERATION, DOUBLE_FACTOR_RATE, FACTORS_PER_ITERATION,
    ITERATIONS_PER_CONDENSATION, MIXED_FILL, SECONDS_PER_DIVIDED_UNKNOWN, SECONDS_PER_FACTOR_ENTRY,
    SINGLE_FACTOR_RATE,
};

/// Of a condensed model whose factor takes `work` multiplications and has so many `entries`, where condensing took
/// `condensing` multiplications.
pub fn seconds_direct(work: f64, entries: f64, condensing: f64) -> f64 {
    FACTORS_PER_ITERATION * work / SINGLE_FACTOR_RATE
        + condensing / ITERATIONS_PER_CONDENSATION / DOUBLE_FACTOR_RATE
        + DIRECTIONS_PER_ITERATION * SECONDS_PER_FACTOR_ENTRY * entries
}

/// Of a body of which so many unknowns are `kept`, condensed in `condensing` multiplications: its part in a factor is
/// dense.
pub fn seconds_condensed(kept: usize, condensing: f64) -> f64 {
    let kept = kept as f64;
    seconds_direct(kept.powi(3) / 6.0, kept.powi(2) / 2.0, condensing)
}

/// Of a body of so many elements, left sparse.
pub fn seconds_sparse(elements: usize) -> f64 {
    let entries = factor_entries(elements);
    seconds_direct(factor_work(entries), entries, 0.0)
}

/// Which bodies are to be condensed, where an iteration takes so many seconds of each if it is `[condensed, sparse]`.
///
/// All or none of them, unless a mixture is quicker though beside a condensed body the factor of a sparse one fills in.
pub fn worth_condensing(seconds: &[[f64; 2]]) -> Vec<bool> {
    let sum = |of: &dyn Fn(&[f64; 2]) -> f64| seconds.iter().map(of).sum::<f64>();
    let (all, none) = (sum(&|s| s[0]), sum(&|s| s[1]));
    let mixed = sum(&|s| s[0].min(s[1]));
    let by_each = MIXED_FILL * mixed < all.min(none);
    let worth = |[condensed, sparse]: &[f64; 2]| {
        if by_each {
            condensed <= sparse
        } else {
            all <= none
        }
    };
    seconds.iter().map(worth).collect()
}

/// Of a divided model.
pub fn seconds_divided(unknowns: usize) -> f64 {
    SECONDS_PER_DIVIDED_UNKNOWN * unknowns as f64
}

/// About how many entries the factor of a compact body has, ordered by METIS: 73 million for a cube of 30 elements a
/// side, 241 million for one of 40, 8 to 48 for parts of a bearing of 5 to 20 thousand (within a fifth).
pub fn factor_entries(elements: usize) -> f64 {
    73e6 * (elements as f64 / 27e3).powf(1.4)
}

/// Multiplications that a factor of a compact body of so many entries takes, from bodies of 1.7 to 48 million entries
/// (within a third). Condensing the body takes about as many.
pub fn factor_work(entries: f64) -> f64 {
    1.7 * entries.powf(4.0 / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_bodies_are_condensed_or_none_unless_a_mixture_is_far_quicker() {
        assert_eq!(worth_condensing(&[[0.1, 1.0], [0.3, 0.25]]), [true, true]);
        assert_eq!(
            worth_condensing(&[[1.0, 0.5], [0.04, 0.06]]),
            [false, false]
        );
        assert_eq!(worth_condensing(&[[0.1, 10.0], [10.0, 0.1]]), [true, false]);
    }
}
