//! A flat punch whose edges are rounded, pressed into a half space in plane strain.
//!
//! Where the flat part ends the curvature jumps. The pressure is finite there, unlike below a sharp edge, but it has
//! a narrow peak of several times its mean.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::analytic::error::{self, DomainError};
use crate::analytic::search::{bisect, maximum};

/// The contact of a punch that is flat for -b < x < b and rounded with the radius R beyond.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundedPunch {
    /// Load P per length of the punch.
    pub load: f64,
    /// Half-width a of the contact.
    pub half_width: f64,
    /// φ0, sin φ0 = b/a.
    flat: f64,
}

impl RoundedPunch {
    /// `compliance` is 1/E* as in [`contact_compliance`](crate::analytic::contact_compliance).
    ///
    /// ```text
    /// 2 P R / (b² E*) = (π - 2 φ0) / (2 sin² φ0) - cot φ0
    /// ```
    /// Ciavarella, Hills and Monno, Proc. IMechE C 212 (1998) 319, after Shtaerman 1949. It holds as long as the
    /// parabola that it takes for the circle does: for a - b well below R.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive.
    pub fn new(
        load: f64,
        flat_half_width: f64,
        radius: f64,
        compliance: f64,
    ) -> Result<Self, DomainError> {
        let load = error::positive("load per length", load)?;
        let b = error::positive("half-width of the flat part", flat_half_width)?;
        let radius = error::positive("radius of the edges", radius)?;
        let compliance = error::positive("compliance", compliance)?;
        let pressed = 2.0 * load * radius * compliance / (b * b);
        let excess =
            |flat: f64| (PI - 2.0 * flat) / (2.0 * flat.sin().powi(2)) - 1.0 / flat.tan() - pressed;
        let flat = bisect(excess, 1e-6, FRAC_PI_2);
        Ok(Self {
            load,
            half_width: b / flat.sin(),
            flat,
        })
    }

    /// Pressure at the distance x from the middle; zero outside the contact. With x = a sin φ:
    ///
    /// ```text
    /// p = 2P/πa / (π - 2 φ0 - sin 2 φ0) · { (π - 2 φ0) cos φ
    ///     + sin φ ln |sin(φ + φ0) / sin(φ - φ0)| + sin φ0 ln |tan((φ + φ0)/2) tan((φ - φ0)/2)| }
    /// ```
    pub fn pressure(&self, x: f64) -> f64 {
        let share = x.abs() / self.half_width;
        if !(share < 1.0) {
            return 0.0;
        }
        self.at_angle(share.asin())
    }

    /// Place and value of the largest pressure.
    pub fn peak_pressure(&self) -> (f64, f64) {
        let (angle, pressure) = maximum(|angle| self.at_angle(angle), 0.0, FRAC_PI_2, 2000);
        (self.half_width * angle.sin(), pressure)
    }

    fn at_angle(&self, angle: f64) -> f64 {
        /// Both logarithms are infinite where the flat part ends; their sum is not.
        const OFF_THE_CORNER: f64 = 1e-9;
        let flat = self.flat;
        let angle = if (angle - flat).abs() < OFF_THE_CORNER {
            flat + OFF_THE_CORNER
        } else {
            angle
        };
        let (sum, difference) = (angle + flat, angle - flat);
        let rounded = angle.sin() * (sum.sin() / difference.sin()).abs().ln()
            + flat.sin() * ((0.5 * sum).tan() * (0.5 * difference).tan()).abs().ln();
        let scale =
            2.0 * self.load / (PI * self.half_width) / (PI - 2.0 * flat - (2.0 * flat).sin());
        scale * ((PI - 2.0 * flat) * angle.cos() + rounded)
    }
}
