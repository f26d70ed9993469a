//! What a factor is made of.

use bytemuck::Pod;
use faer::traits::RealField;
use std::ops::{AddAssign, SubAssign};

/// A floating-point number of single or double precision.
pub trait Number: RealField + Pod + AddAssign + SubAssign {
    fn rounded(value: f64) -> Self;
    fn widened(self) -> f64;
}

impl Number for f64 {
    fn rounded(value: f64) -> Self {
        value
    }

    fn widened(self) -> f64 {
        self
    }
}

impl Number for f32 {
    fn rounded(value: f64) -> Self {
        value as f32
    }

    fn widened(self) -> f64 {
        f64::from(self)
    }
}
