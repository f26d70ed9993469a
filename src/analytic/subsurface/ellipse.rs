//! Elliptic contact: the stresses on the axis.

use crate::analytic::elliptic_integrals::rd;
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::EllipticContact;
use crate::analytic::search::maximum;
use crate::analytic::stress::Stress;
use crate::analytic::subsurface::PeakStress;

/// Half space under the pressure p0 √(1 - x²/a² - y²/b²) on an ellipse, without traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipseField {
    semi_axes: [f64; 2],
    peak_pressure: f64,
    poissons_ratio: f64,
}

impl EllipseField {
    /// Field under the semi-axes a ≥ b and peak pressure p0, in a body of Poisson's ratio ν.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for b or p0 not positive, b > a, b/a < 1e-12, or ν outside
    /// (-1, 0.5].
    pub fn new(
        semi_axes: [f64; 2],
        peak_pressure: f64,
        poissons_ratio: f64,
    ) -> Result<Self, DomainError> {
        let long = error::positive("long semi-axis", semi_axes[0])?;
        let short = error::positive("short semi-axis", semi_axes[1])?;
        let allowed = short <= long && short >= 1e-12 * long;
        error::require(
            "short semi-axis",
            short,
            allowed,
            "between 1e-12 and 1 long semi-axis",
        )?;
        Ok(Self {
            semi_axes,
            peak_pressure: error::positive("peak pressure", peak_pressure)?,
            poissons_ratio: error::poissons_ratio(poissons_ratio)?,
        })
    }

    /// Field in a body of Poisson's ratio ν under `contact`.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for ν outside (-1, 0.5].
    pub fn below(contact: &EllipticContact, poissons_ratio: f64) -> Result<Self, DomainError> {
        Self::new(contact.semi_axes, contact.peak_pressure, poissons_ratio)
    }

    /// Stress on the axis at the depth z ≥ 0; shear stresses vanish there.
    ///
    /// With ζ = z/a, k = b/a, T = √((k² + ζ²)/(1 + ζ²)), g = 1 / (1 + ζ²)(1 + T) and Carlson's
    /// X = (ζ/3) R_D(ζ², ζ² + k², ζ² + 1), Y = (ζ/3) R_D(ζ², ζ² + 1, ζ² + k²):
    /// ```text
    /// σ_x = 2k p0 [X - g/2 + ν (Y - g/T)]
    /// σ_y = 2k p0 [Y - g/2T + ν (X - g)]
    /// σ_z = -k p0 / √((1 + ζ²)(k² + ζ²))
    /// ```
    /// Fessler and Ollerton 1957, Johnson (3.69), their differences of Legendre integrals put
    /// into symmetric form: good for the circle (k = 1) and the strip (k → 0) alike.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for z negative or not finite.
    pub fn on_axis(&self, depth: f64) -> Result<Stress, DomainError> {
        let zeta = error::non_negative("depth", depth)? / self.semi_axes[0];
        // Farther down, ζ² would leave the floating-point range.
        error::require("depth", depth, zeta <= 1e60, "within 1e60 long semi-axes")?;
        Ok(self.scaled(zeta))
    }

    fn scaled(&self, zeta: f64) -> Stress {
        let k = self.semi_axes[1] / self.semi_axes[0];
        let (p0, nu) = (self.peak_pressure, self.poissons_ratio);
        let square = zeta * zeta;
        let (outer, inner) = (1.0 + square, k * k + square);
        let t = (inner / outer).sqrt();
        let g = 1.0 / (outer * (1.0 + t));
        let term = |a: f64, b: f64| {
            if zeta == 0.0 {
                0.0
            } else {
                zeta / 3.0 * rd(square, a, b)
            }
        };
        let (x, y) = (term(inner, outer), term(outer, inner));
        Stress::normal(
            2.0 * k * p0 * (x - 0.5 * g + nu * (y - g / t)),
            2.0 * k * p0 * (y - 0.5 * g / t + nu * (x - g)),
            -k * p0 / (outer * inner).sqrt(),
        )
    }

    /// The largest Mises stress on the axis; at 0.48 b (circle) to 0.72 b depth for ν = 0.3.
    pub fn peak_mises_on_axis(&self) -> PeakStress {
        let k = self.semi_axes[1] / self.semi_axes[0];
        let (in_short_axes, value) = maximum(|z| self.scaled(z * k).mises(), 0.0, 2.0, 100);
        PeakStress {
            value,
            x: 0.0,
            depth: in_short_axes * self.semi_axes[1],
        }
    }
}
