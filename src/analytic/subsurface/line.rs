//! Line contact: the field under a semi-elliptic pressure, with or without sliding.

use nalgebra::Complex;

use super::peak::PeakStress;
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::LineContact;
use crate::analytic::search::{climb, maximum};
use crate::analytic::stress::Stress;

/// Half space in plane strain under the pressure p0 √(1 - x²/a²), with the traction μp in the
/// direction +x where the other body slides that way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineField {
    half_width: f64,
    peak_pressure: f64,
    poissons_ratio: f64,
    friction: f64,
    along: f64,
}

impl LineField {
    /// Field under the half width a and peak pressure p0, in a body of Poisson's ratio ν, without
    /// traction.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a or p0 not positive, or ν outside (-1, 0.5].
    pub fn new(
        half_width: f64,
        peak_pressure: f64,
        poissons_ratio: f64,
    ) -> Result<Self, DomainError> {
        Ok(Self {
            half_width: error::positive("half width of the contact", half_width)?,
            peak_pressure: error::positive("peak pressure", peak_pressure)?,
            poissons_ratio: error::poissons_ratio(poissons_ratio)?,
            friction: 0.0,
            along: 0.0,
        })
    }

    /// Field in a body of Poisson's ratio ν under `contact`.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for ν outside (-1, 0.5].
    pub fn below(contact: &LineContact, poissons_ratio: f64) -> Result<Self, DomainError> {
        Self::new(contact.half_width, contact.peak_pressure, poissons_ratio)
    }

    /// The same pressure in full sliding, with the traction q(x) = μ p(x) on the body in +x.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for μ negative or not finite.
    pub fn sliding(self, friction: f64) -> Result<Self, DomainError> {
        Ok(Self {
            friction: error::friction(friction)?,
            ..self
        })
    }

    /// The same with a traction along the strip, too: `share` times the pressure, on the body in +y.
    ///
    /// It makes shears alone: with u as in [`stress`](Self::stress), τ_yz − i τ_xy = −share p0 u, which is harmonic, has the
    /// traction on the surface and vanishes far below (antiplane shear of a half space).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a share that is not finite.
    pub fn sheared_along(self, share: f64) -> Result<Self, DomainError> {
        error::require(
            "traction along the strip",
            share,
            share.is_finite(),
            "finite",
        )?;
        Ok(Self {
            along: share,
            ..self
        })
    }

    /// Stress at the distance x from the centre line and the depth z ≥ 0.
    ///
    /// With m² and n² = ½ [√((a² - x² + z²)² + 4x²z²) ± (a² - x² + z²)], n of the sign of x:
    /// ```text
    /// σ_x  = -(p0/a) [m (1 + (z² + n²)/(m² + n²)) - 2z]     + (μp0/a) [n (2 - (z² - m²)/(m² + n²)) - 2x]
    /// σ_z  = -(p0/a)  m (1 - (z² + n²)/(m² + n²))           + μ τ_zx of the pressure alone
    /// τ_zx = -(p0/a)  n (m² - z²)/(m² + n²)                 + μ σ_x of the pressure alone
    /// σ_y  = ν (σ_x + σ_z)
    /// ```
    /// McEwen 1949; Johnson (4.49) for the pressure, (7.8) for the traction. Evaluated as the
    /// complex function u = a²/(w + ζ), w = m + i n, ζ = z + i x, which keeps its digits far
    /// below the contact, where the printed form cancels.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for z < 0, or x or z beyond 1e100 half widths.
    pub fn stress(&self, x: f64, z: f64) -> Result<Stress, DomainError> {
        let (x, z) = (x / self.half_width, z / self.half_width);
        let reach = "finite, and within 1e100 half widths of the contact";
        error::require("distance from the centre line", x, x.abs() <= 1e100, reach)?;
        error::require("depth", z, z >= 0.0, "zero or positive")?;
        error::require("depth", z, z <= 1e100, reach)?;
        Ok(self.scaled(x, z))
    }

    /// Stress at x and z given in half widths.
    fn scaled(&self, x: f64, z: f64) -> Stress {
        let [sx, sz, shear] = pressure_field(x, z);
        let (p0, mu) = (self.peak_pressure, self.friction);
        let u = remainder(x, z);
        let xx = p0 * (sx + mu * (2.0 * u.im - shear));
        let zz = p0 * (sz + mu * shear);
        let yy = self.poissons_ratio * (xx + zz);
        Stress {
            xx,
            yy,
            zz,
            zx: p0 * (shear + mu * sx),
            xy: p0 * self.along * u.im,
            yz: -p0 * self.along * u.re,
        }
    }

    /// The largest Mises stress in the body.
    ///
    /// Without traction on the axis below the surface (for ν = 0.3: 0.5575 p0 at 0.7043 a), at
    /// the surface for ν < 0.194, where it is (1 - 2ν) p0. With traction it moves off the axis
    /// and, for ν = 0.3, to the surface from μ = 0.27 on. Found by search over the closed-form
    /// field; the value is good to 1e-12, the place to about 1e-7 of a.
    pub fn peak_mises(&self) -> PeakStress {
        let mises = |x: f64, z: f64| self.scaled(x, z).mises();
        let peak = |value: f64, x: f64, z: f64| PeakStress {
            value,
            x: x * self.half_width,
            depth: z * self.half_width,
        };
        if self.friction == 0.0 && self.along == 0.0 {
            let (z, value) = maximum(|z| mises(0.0, z), 0.0, 2.0, 100);
            return peak(value, 0.0, z);
        }
        // The traction bends the surface maximum into an edge: search it apart from the inside.
        let (x, on_surface) = maximum(|x| mises(x, 0.0), -1.0, 1.0, 400);
        let grid = (1..=40)
            .flat_map(|i| (-24..=24).map(move |j| [0.05 * f64::from(j), 0.04 * f64::from(i)]));
        let highest = |a: [f64; 2], b: [f64; 2]| {
            if mises(b[0], b[1]) > mises(a[0], a[1]) {
                b
            } else {
                a
            }
        };
        let start = grid.fold([0.0, 0.7], highest);
        let inside = |p: [f64; 2]| {
            if p[1] < 0.0 {
                f64::NEG_INFINITY
            } else {
                mises(p[0], p[1])
            }
        };
        let (place, value) = climb(inside, start, 0.02);
        if value > on_surface {
            peak(value, place[0], place[1])
        } else {
            peak(on_surface, x, 0.0)
        }
    }

    /// The largest shear stress in the x-z plane on the axis, without regard to traction:
    /// 0.3003 p0 at 0.7862 a, whatever ν. Johnson 4.2(c).
    pub fn peak_shear_on_axis(&self) -> PeakStress {
        let still = Self {
            friction: 0.0,
            ..*self
        };
        let (z, value) = maximum(|z| still.scaled(0.0, z).shear_in_zx(), 0.0, 2.0, 100);
        PeakStress {
            value,
            x: 0.0,
            depth: z * self.half_width,
        }
    }
}

/// w = m + i n for a = 1, without cancellation in either part: m n = x z.
fn root(x: f64, z: f64) -> Complex<f64> {
    let real = 1.0 - x * x + z * z;
    let large = (0.5 * (real.hypot(2.0 * x * z) + real.abs())).sqrt();
    let small = if large == 0.0 {
        0.0
    } else {
        (x * z).abs() / large
    };
    let (m, n) = if real >= 0.0 {
        (large, small)
    } else {
        (small, large)
    };
    Complex::new(m, if x < 0.0 { -n } else { n })
}

/// u = w - ζ for a = 1.
fn remainder(x: f64, z: f64) -> Complex<f64> {
    (root(x, z) + Complex::new(z, x)).inv()
}

/// σ_x, σ_z and τ_zx under the pressure alone, for a = p0 = 1.
fn pressure_field(x: f64, z: f64) -> [f64; 3] {
    let u = remainder(x, z);
    if z == 0.0 {
        // Also the edges of the contact, where w vanishes.
        return [-u.re, -u.re, 0.0];
    }
    let w = root(x, z);
    let sx = -(u * (u + Complex::new(0.0, x)) / w).re;
    let sz = -(u * (w + z) / w).re;
    [sx, sz, z * (u / w).im]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// McEwen's formulas as printed.
    fn printed(x: f64, z: f64) -> [f64; 3] {
        let t = 1.0 - x * x + z * z;
        let s = t.hypot(2.0 * x * z);
        let m = (0.5 * (s + t)).sqrt();
        let n = x.signum() * (0.5 * (s - t)).sqrt();
        let share = (z * z + n * n) / s;
        let sx = -(m * (1.0 + share) - 2.0 * z);
        [sx, -m * (1.0 - share), -n * (m * m - z * z) / s]
    }

    #[test]
    fn the_complex_form_is_mcewens() {
        for x in [-2.0, -1.0, -0.4, 0.0, 0.3, 1.0, 1.7] {
            for z in [0.01, 0.2, 0.7, 1.5, 4.0] {
                for (a, b) in pressure_field(x, z).iter().zip(printed(x, z)) {
                    assert!((a - b).abs() < 1e-13, "{x} {z}: {a} {b}");
                }
            }
        }
    }

    /// The traction along the strip is there on its surface and nowhere beside it, and shears balance: ∂τ_xy/∂x + ∂τ_yz/∂z = 0.
    #[test]
    fn a_traction_along_the_strip_is_in_balance() {
        let field = LineField::new(2.0, 3.0, 0.3).unwrap();
        let field = field.sheared_along(0.2).unwrap();
        let at = |x: f64, z: f64| field.stress(x, z).unwrap();
        for x in [-1.9f64, 0.0, 1.2] {
            let pressure = 3.0 * (1.0 - 0.25 * x * x).sqrt();
            assert!((at(x, 0.0).yz + 0.2 * pressure).abs() < 1e-14);
        }
        assert!(at(2.5, 0.0).yz.abs() < 1e-14);
        let d = 1e-5;
        for [x, z] in [[0.3, 0.5], [-1.7, 1.1], [3.0, 2.0]] {
            let of_xy = at(x + d, z).xy - at(x - d, z).xy;
            let of_yz = at(x, z + d).yz - at(x, z - d).yz;
            assert!((of_xy + of_yz).abs() < 1e-9, "{x} {z}");
        }
    }

    #[test]
    fn edges_and_far_field_are_finite() {
        let field = LineField::new(2.0, 3.0, 0.3).unwrap().sliding(0.2).unwrap();
        let edge = field.stress(-2.0, 0.0).unwrap();
        assert!((edge.xx - 2.0 * 0.2 * 3.0).abs() < 1e-14);
        assert!(field.stress(1e90, 1e90).unwrap().mises().is_finite());
        assert!(field.stress(0.0, -1.0).is_err());
        assert!(field.stress(f64::NAN, 1.0).is_err());
    }
}
