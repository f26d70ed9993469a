//! Point contact of spheres: the stresses on the axis.

use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::PointContact;
use crate::analytic::search::maximum;
use crate::analytic::stress::Stress;
use crate::analytic::subsurface::PeakStress;

/// Half space under the pressure p0 √(1 - r²/a²) on a circle, without traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereField {
    contact_radius: f64,
    peak_pressure: f64,
    poissons_ratio: f64,
}

impl SphereField {
    /// Field under the contact radius a and peak pressure p0, in a body of Poisson's ratio ν.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a or p0 not positive, or ν outside (-1, 0.5].
    pub fn new(
        contact_radius: f64,
        peak_pressure: f64,
        poissons_ratio: f64,
    ) -> Result<Self, DomainError> {
        Ok(Self {
            contact_radius: error::positive("contact radius", contact_radius)?,
            peak_pressure: error::positive("peak pressure", peak_pressure)?,
            poissons_ratio: error::poissons_ratio(poissons_ratio)?,
        })
    }

    /// Field in a body of Poisson's ratio ν under `contact`.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for ν outside (-1, 0.5].
    pub fn below(contact: &PointContact, poissons_ratio: f64) -> Result<Self, DomainError> {
        Self::new(
            contact.contact_radius,
            contact.peak_pressure,
            poissons_ratio,
        )
    }

    /// Stress on the axis at the depth z ≥ 0; shear stresses vanish there.
    ///
    /// ```text
    /// σ_x = σ_y = -p0 [(1 + ν)(1 - ζ arctan(1/ζ)) - ½ / (1 + ζ²)]        ζ = z/a
    /// σ_z = -p0 / (1 + ζ²)
    /// ```
    /// Johnson (3.45).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for z negative or not finite.
    pub fn on_axis(&self, depth: f64) -> Result<Stress, DomainError> {
        Ok(self.scaled(error::non_negative("depth", depth)? / self.contact_radius))
    }

    fn scaled(&self, zeta: f64) -> Stress {
        let p0 = self.peak_pressure;
        let decay = 1.0 / (1.0 + zeta * zeta);
        let across = -p0 * ((1.0 + self.poissons_ratio) * arc_deficit(zeta) - 0.5 * decay);
        Stress::normal(across, across, -p0 * decay)
    }

    /// The largest Mises stress on the axis (twice the shear stress there), which is the largest
    /// in the body for the ratios of metals: 0.6200 p0 at 0.4809 a for ν = 0.3.
    pub fn peak_mises_on_axis(&self) -> PeakStress {
        let (zeta, value) = maximum(|zeta| self.scaled(zeta).mises(), 0.0, 2.0, 100);
        PeakStress {
            value,
            x: 0.0,
            depth: zeta * self.contact_radius,
        }
    }
}

/// 1 - ζ arctan(1/ζ), by its series where the difference would cancel.
fn arc_deficit(zeta: f64) -> f64 {
    if zeta < 100.0 {
        return 1.0 - zeta * 1f64.atan2(zeta);
    }
    let square = 1.0 / zeta / zeta;
    square * (1.0 / 3.0 - square * (1.0 / 5.0 - square / 7.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_meets_the_arc() {
        let direct = 1.0 - 100.0 * 1f64.atan2(100.0);
        assert!((arc_deficit(100.0) / direct - 1.0).abs() < 1e-10);
        assert_eq!(arc_deficit(0.0), 1.0);
    }
}
