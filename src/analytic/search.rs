//! Roots and maxima of smooth functions of one or two variables.

/// The root of `f` between `low` and `high`, at which `f` must differ in sign, to the last bits.
pub(crate) fn bisect(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let rises = f(low) < f(high);
    // 200 halvings exhaust the digits of any bracket used here.
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low.min(high) || middle >= low.max(high) {
            break;
        }
        if (f(middle) > 0.0) == rises {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

/// Place and value of the largest `f` in `[low, high]`: the best of `samples` equal steps,
/// sharpened by golden sections around it. The place is good to about 1e-8 of the range.
pub(crate) fn maximum(f: impl Fn(f64) -> f64, low: f64, high: f64, samples: usize) -> (f64, f64) {
    let step = (high - low) / samples as f64;
    let mut best = (low, f(low));
    for i in 1..=samples {
        let x = low + step * i as f64;
        let value = f(x);
        if value > best.1 {
            best = (x, value);
        }
    }
    let sharp = golden(&f, (best.0 - step).max(low), (best.0 + step).min(high));
    if sharp.1 > best.1 { sharp } else { best }
}

fn golden(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> (f64, f64) {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let mut x = [high - RATIO * (high - low), low + RATIO * (high - low)];
    let mut value = x.map(&f);
    for _ in 0..60 {
        if value[0] > value[1] {
            high = x[1];
            x = [high - RATIO * (high - low), x[0]];
            value = [f(x[0]), value[0]];
        } else {
            low = x[0];
            x = [x[1], low + RATIO * (high - low)];
            value = [value[1], f(x[1])];
        }
    }
    if value[0] > value[1] {
        (x[0], value[0])
    } else {
        (x[1], value[1])
    }
}

/// Place and value of a maximum of `f` next to `start`, by a compass search whose first step is
/// `step` long. `f` may give negative infinity outside its domain.
pub(crate) fn climb(f: impl Fn([f64; 2]) -> f64, start: [f64; 2], step: f64) -> ([f64; 2], f64) {
    let mut best = (start, f(start));
    let mut step = step;
    while step > 1e-10 {
        let [x, y] = best.0;
        let mut moved = false;
        for next in [[x + step, y], [x - step, y], [x, y + step], [x, y - step]] {
            let value = f(next);
            if value > best.1 {
                best = (next, value);
                moved = true;
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bisect_finds_rising_and_falling_roots() {
        assert!((bisect(|x| x * x - 2.0, 0.0, 2.0) - 2f64.sqrt()).abs() < 1e-15);
        assert!((bisect(|x| 2.0 - x * x, 0.0, 2.0) - 2f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn maximum_looks_at_the_ends_too() {
        let (x, value) = maximum(|x| -(x - 0.3) * (x - 0.3), 0.0, 1.0, 7);
        assert!((x - 0.3).abs() < 1e-7 && value.abs() < 1e-14);
        assert_eq!(maximum(|x| x, 0.0, 1.0, 7), (1.0, 1.0));
    }

    #[test]
    fn climb_finds_a_hill() {
        let hill = |p: [f64; 2]| -(p[0] - 1.0).powi(2) - 3.0 * (p[1] + 2.0).powi(2);
        let (place, _) = climb(hill, [0.0, 0.0], 0.5);
        assert!((place[0] - 1.0).abs() < 1e-7 && (place[1] + 2.0).abs() < 1e-7);
    }
}
