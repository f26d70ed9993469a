//! Observed orders and extrapolated limits.

/// An error that is this small, relative to the largest of its series, is rounding.
const ROUNDING: f64 = 1e-11;
/// Orders that an extrapolation may rest on: below, its limit lies beyond every level; elements of the first order have no more than
/// twice that order in energies, and twice that again where meshes are alike.
const SOUND: std::ops::Range<f64> = 0.5..4.5;

/// The order p in |error| ∝ size^p between two levels; `None` where an error vanishes.
pub fn between(sizes: [f64; 2], errors: [f64; 2]) -> Option<f64> {
    let [a, b] = errors.map(f64::abs);
    let order = (a / b).ln() / (sizes[0] / sizes[1]).ln();
    (a > 0.0 && b > 0.0 && order.is_finite()).then_some(order)
}

/// The order p in |error| ∝ size^p by least squares on the logarithms, over all points whose error
/// is no rounding; `None` for fewer than two.
pub fn fitted(points: &[(f64, f64)]) -> Option<f64> {
    let largest = points.iter().map(|p| p.1.abs()).fold(0.0, f64::max);
    let logs: Vec<(f64, f64)> = points
        .iter()
        .filter(|(size, error)| *size > 0.0 && error.abs() > ROUNDING * largest)
        .map(|(size, error)| (size.ln(), error.abs().ln()))
        .collect();
    if logs.len() < 2 {
        return None;
    }
    let count = logs.len() as f64;
    let [x, y] = [
        logs.iter().map(|l| l.0).sum::<f64>() / count,
        logs.iter().map(|l| l.1).sum::<f64>() / count,
    ];
    let [xy, xx] = logs.iter().fold([0.0; 2], |[xy, xx], l| {
        [xy + (l.0 - x) * (l.1 - y), xx + (l.0 - x).powi(2)]
    });
    (xx > 0.0).then_some(xy / xx).filter(|p| p.is_finite())
}

/// A limit beyond the finest level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    pub value: f64,
    /// The order that the three levels behind it show.
    pub order: f64,
}

/// Richardson's extrapolation from three levels, coarse to fine, each finer by the same ratio.
/// `None` where the values do not approach a limit steadily, with an order that can be trusted.
pub fn richardson(sizes: [f64; 3], values: [f64; 3]) -> Option<Limit> {
    let ratio = sizes[1] / sizes[2];
    let same = (sizes[0] / sizes[1] / ratio - 1.0).abs() < 0.01;
    let [first, last] = [values[0] - values[1], values[1] - values[2]];
    let order = (first / last).ln() / ratio.ln();
    // Not a number where the differences change sign.
    if !(same && ratio > 1.0 && SOUND.contains(&order)) {
        return None;
    }
    Some(Limit {
        value: values[2] - last / (ratio.powf(order) - 1.0),
        order,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: [f64; 3] = [0.4, 0.2, 0.1];

    #[test]
    fn a_power_law_gives_its_order_and_limit() {
        let value = |h: f64| 5.0 - 3.0 * h.powf(1.7);
        let limit = richardson(SIZES, SIZES.map(value)).unwrap();
        assert!((limit.value - 5.0).abs() < 1e-12 && (limit.order - 1.7).abs() < 1e-12);
        let points = SIZES.map(|h| (h, value(h) - 5.0));
        assert!((fitted(&points).unwrap() - 1.7).abs() < 1e-12);
        let [a, b, _] = points;
        assert!((between([a.0, b.0], [a.1, b.1]).unwrap() - 1.7).abs() < 1e-12);
    }

    #[test]
    fn what_does_not_converge_has_no_limit() {
        assert_eq!(richardson(SIZES, [1.0, 2.0, 1.5]), None, "it turns");
        assert_eq!(richardson(SIZES, [1.0, 1.1, 1.3]), None, "it diverges");
        assert_eq!(richardson(SIZES, [1.0, 1.0, 1.0]), None, "nothing changes");
        assert_eq!(richardson([0.4, 0.2, 0.15], [1.0, 1.5, 1.75]), None);
        assert_eq!(fitted(&[(0.1, 0.0), (0.2, 0.0)]), None);
        assert_eq!(between([0.2, 0.1], [1.0, 0.0]), None);
    }
}
