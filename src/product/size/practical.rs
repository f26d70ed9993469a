//! Practical sizes: diameters that are made, and lengths that are easily drawn.
//!
//! Eight diameters to a doubling with inches (... 4, 4.5, 5, 5.5, 6, 6.5, 7, 7.5, 8 ...), in metric
//! units the twenty to a decade of ISO 3 (... 100, 112, 125, 140, 160 ...). Lengths and thicknesses
//! are rounded up by no more than a thirty-second of themselves, in steps of halves, quarters,
//! eighths of an inch and so on, or of 1, 2, 5 times a power of ten.

use crate::ground::units::UnitSystem;

/// R20 of ISO 3 (1973), rounded as there, in hundredths: whole numbers divide to the decimal fraction
/// that people write.
const R20: [f64; 20] = [
    100.0, 112.0, 125.0, 140.0, 160.0, 180.0, 200.0, 224.0, 250.0, 280.0, 315.0, 355.0, 400.0,
    450.0, 500.0, 560.0, 630.0, 710.0, 800.0, 900.0,
];

/// Eighths of an octave.
const OCTAVE: [f64; 8] = [1.0, 1.125, 1.25, 1.375, 1.5, 1.625, 1.75, 1.875];

/// Lengths are rounded up by at most their own size over this.
const FINENESS: f64 = 32.0;

/// Practical diameters of `least` and more, ascending without end.
pub fn diameters(units: UnitSystem, least: f64) -> impl Iterator<Item = f64> {
    let (base, sizes, finer): (f64, &'static [f64], i32) = if in_inches(units) {
        (2.0, &OCTAVE, 0)
    } else {
        (10.0, &R20, 2)
    };
    let first = least.log(base).floor() as i32 - finer;
    // Rounding in the logarithm may lose a size at the seam.
    (first - 1..)
        .flat_map(move |power| sizes.iter().map(move |size| scaled(*size, base, power)))
        .skip_while(move |diameter| *diameter < least * (1.0 - 1e-12))
}

/// `value` rounded up to a practical length.
pub fn rounded_up(units: UnitSystem, value: f64) -> f64 {
    let most = value / FINENESS;
    let step = if in_inches(units) {
        2f64.powi(most.log2().floor() as i32)
    } else {
        let power = most.log10().floor() as i32;
        let share = [5.0, 2.0, 1.0]
            .into_iter()
            .find(|s| scaled(*s, 10.0, power) <= most);
        scaled(share.unwrap_or(1.0), 10.0, power)
    };
    // What is practical already stays, whatever the last digit says.
    let steps = (value / step - 1e-9).ceil();
    match step < 1.0 && !in_inches(units) {
        // Division by a whole number gives the decimal fraction that people write.
        true => steps / (1.0 / step).round(),
        false => steps * step,
    }
}

fn in_inches(units: UnitSystem) -> bool {
    units.length() == "in"
}

/// `size` times a power of `base`; a negative power of ten divides, which is exact to the last digit.
fn scaled(size: f64, base: f64, power: i32) -> f64 {
    if power < 0 {
        size / base.powi(-power)
    } else {
        size * base.powi(power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use UnitSystem::{InKipKsi, MNPa, MmNMPa};

    fn some(units: UnitSystem, least: f64, count: usize) -> Vec<f64> {
        diameters(units, least).take(count).collect()
    }

    #[test]
    fn the_study_s_diameters_are_among_them() {
        assert_eq!(some(InKipKsi, 2.9, 5), [3.0, 3.25, 3.5, 3.75, 4.0]);
        assert_eq!(some(InKipKsi, 4.5, 3), [4.5, 5.0, 5.5]);
        assert_eq!(some(InKipKsi, 7.9, 2), [8.0, 9.0]);
        assert_eq!(some(MmNMPa, 113.0, 3), [125.0, 140.0, 160.0]);
        assert_eq!(some(MNPa, 0.113, 3), [0.125, 0.14, 0.16]);
        assert_eq!(some(InKipKsi, 0.1, 1), [0.1015625]);
    }

    #[test]
    fn lengths_are_rounded_up_a_little() {
        assert_eq!(rounded_up(InKipKsi, 8.14), 8.25);
        assert_eq!(rounded_up(InKipKsi, 8.25), 8.25);
        assert_eq!(rounded_up(InKipKsi, 1.3), 1.3125);
        assert_eq!(rounded_up(MmNMPa, 207.0), 210.0);
        assert_eq!(rounded_up(MmNMPa, 31.3), 31.5);
        assert_eq!(rounded_up(MNPa, 0.207), 0.21);
        for value in [1e-7, 3.3e-3, 0.77, 1.0, 9.99, 64.0, 1e5] {
            for units in UnitSystem::ALL {
                let up = rounded_up(units, value);
                assert!(up >= value * (1.0 - 1e-9) && up <= value * (1.0 + 1.0 / FINENESS));
            }
        }
    }
}
