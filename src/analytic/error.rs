//! What a closed-form solution says to a bad argument.

use thiserror::Error;

/// An argument outside the range in which a formula holds.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DomainError {
    /// The argument cannot be used as it is.
    #[error("{argument} is {value}, but it must be {allowed}")]
    OutOfRange {
        /// Name of the argument, in words.
        argument: &'static str,
        /// The value that was found.
        value: f64,
        /// The allowed range, in words, with its limits.
        allowed: String,
    },
    /// The arguments are allowed one by one, but the result is beyond the floating-point range.
    #[error("{quantity} comes out as {value}: the arguments are too large or too small together")]
    Overflow {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value that was found.
        value: f64,
    },
    /// An iterative solution did not settle.
    #[error("{quantity} did not converge in {iterations} iterations")]
    NotConverged {
        /// Name of the quantity.
        quantity: &'static str,
        /// Iterations that were spent.
        iterations: usize,
    },
}

impl DomainError {
    pub(crate) fn out_of_range(
        argument: &'static str,
        value: f64,
        allowed: impl Into<String>,
    ) -> Self {
        Self::OutOfRange {
            argument,
            value,
            allowed: allowed.into(),
        }
    }
}

/// `value`, where `allowed_if` holds for it.
pub(crate) fn require(
    argument: &'static str,
    value: f64,
    allowed_if: bool,
    allowed: impl Into<String>,
) -> Result<f64, DomainError> {
    if allowed_if {
        Ok(value)
    } else {
        Err(DomainError::out_of_range(argument, value, allowed))
    }
}

/// Magnitudes beyond this, or below its inverse, are refused: their powers would leave the
/// floating-point range inside the formulas.
const LARGEST_NUMBER: f64 = 1e100;

/// `value`, where it is above zero and of a magnitude that the formulas can hold.
pub(crate) fn positive(argument: &'static str, value: f64) -> Result<f64, DomainError> {
    require(
        argument,
        value,
        value.is_finite() && value > 0.0,
        "positive and finite",
    )?;
    let held = (LARGEST_NUMBER.recip()..=LARGEST_NUMBER).contains(&value);
    require(argument, value, held, "between 1e-100 and 1e100")
}

/// `value`, where it is finite and not below zero.
pub(crate) fn non_negative(argument: &'static str, value: f64) -> Result<f64, DomainError> {
    let allowed = (0.0..=LARGEST_NUMBER).contains(&value);
    require(
        argument,
        value,
        allowed,
        "zero or positive, and at most 1e100",
    )
}

/// `value`, where it is finite and of a magnitude that the formulas can hold.
pub(crate) fn finite(argument: &'static str, value: f64) -> Result<f64, DomainError> {
    require(
        argument,
        value,
        value.abs() <= LARGEST_NUMBER,
        "finite, and within 1e100",
    )
}

/// Poisson's ratio of a stable isotropic solid.
pub(crate) fn poissons_ratio(value: f64) -> Result<f64, DomainError> {
    require(
        "Poisson's ratio",
        value,
        value > -1.0 && value <= 0.5,
        "above -1 and at most 0.5",
    )
}

/// Coulomb's coefficient of friction.
pub(crate) fn friction(value: f64) -> Result<f64, DomainError> {
    non_negative("coefficient of friction", value)
}

/// A positive result that the floating-point range can hold.
pub(crate) fn representable(quantity: &'static str, value: f64) -> Result<f64, DomainError> {
    if value.is_normal() {
        Ok(value)
    } else {
        Err(DomainError::Overflow { quantity, value })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_message_names_argument_value_and_range() {
        let text = positive("radius", -2.0).unwrap_err().to_string();
        assert_eq!(text, "radius is -2, but it must be positive and finite");
    }

    #[test]
    fn not_a_number_is_refused_everywhere() {
        for check in [
            positive("x", f64::NAN),
            non_negative("x", f64::NAN),
            finite("x", f64::NAN),
            poissons_ratio(f64::NAN),
            friction(f64::NAN),
            representable("x", f64::NAN),
        ] {
            assert!(check.is_err());
        }
    }
}
