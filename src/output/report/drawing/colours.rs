//! The one colour map of the page: equal steps of a value are equal steps to the eye.

use colorous::{Gradient, VIRIDIS};

const MAP: Gradient = VIRIDIS;

/// Red, green and blue at 256 steps from the least value to the largest.
pub fn table() -> Vec<[u8; 3]> {
    (0..256)
        .map(|k| MAP.eval_rational(k, 256).as_array())
        .collect()
}

/// The colour at a share of the range, as a page writes it.
pub fn css(share: f64) -> String {
    format!("#{:x}", MAP.eval_continuous(share.clamp(0.0, 1.0)))
}
