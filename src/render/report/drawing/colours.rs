//! The one colour map of the page: equal steps of a value are equal steps to the eye, and the many
//! parts that carry little are light, on the screen and in ink.

use colorous::MAGMA;

/// The part of the map that is used, from the least value to the largest: not to black, in which
/// edges could not be seen.
const ENDS: [f64; 2] = [0.985, 0.06];

/// Red, green and blue at 256 steps from the least value to the largest.
pub fn table() -> Vec<[u8; 3]> {
    let colour = |k: u16| at(f64::from(k) / 255.0).as_array();
    (0..256).map(colour).collect()
}

/// The colour at a share of the range, as a page writes it.
pub fn css(share: f64) -> String {
    format!("#{:x}", at(share.clamp(0.0, 1.0)))
}

fn at(share: f64) -> colorous::Color {
    let [first, last] = ENDS;
    MAGMA.eval_continuous(first + share * (last - first))
}
