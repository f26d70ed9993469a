//! Shares of something on the command line: `0.15`, or `"15 %"`.

use crate::ground::units::{Dimension, Quantity, UnitSystem};

/// Reads a number without a unit, or a percentage.
///
/// # Errors
/// What is wrong with it, in words.
pub fn share(text: &str) -> Result<f64, String> {
    // No unit of any system stands in it.
    let read = Quantity::parse(text);
    let share = read.and_then(|share| share.value_in(UnitSystem::MNPa, Dimension::RATIO));
    share.map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::share;

    #[test]
    fn a_share_is_a_number_or_a_percentage() {
        assert_eq!(share("0.15"), Ok(0.15));
        assert_eq!(share("15 %"), Ok(0.15));
        assert_eq!(share("15%"), Ok(0.15));
        assert_eq!(share("-1"), Ok(-1.0));
        for wrong in ["15 mm", "much", "", "nan"] {
            let said = share(wrong).expect_err(wrong);
            assert!(said.contains(wrong), "{said}");
        }
    }
}
