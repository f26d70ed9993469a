//! A hollow (or solid) roller squeezed between two plates: exact elasticity of the annulus under
//! two opposed radial loads, by Michell's series.

mod disc;
mod order;
mod polar;

use std::f64::consts::PI;

use order::Order;
pub use polar::PolarStress;

use crate::analytic::elastic::Elastic;
use crate::analytic::error::{self, DomainError};

/// How the load meets the outer surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RingLoad {
    /// On a line (a point of the cross-section).
    Point,
    /// As the semi-elliptic pressure of a Hertz contact of this half angle, a/R in radians.
    SemiElliptic {
        /// Half of the angle that it covers, rad.
        half_angle: f64,
    },
}

/// What happens along the roller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneState {
    /// No strain along it: a long roller.
    Strain,
    /// No stress along it: a thin disc.
    Stress,
}

/// Annulus r_i ≤ r ≤ r_o under two opposed radial loads at θ = 0 and θ = π.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    inner_radius: f64,
    outer_radius: f64,
    load: f64,
    body: Elastic,
    plane: PlaneState,
    half_angle: f64,
    /// Mean pressure P/πr_o, and the constants A₀, B₀ of the axisymmetric part,
    /// σ_r = 2A₀ + B₀/r².
    mean: f64,
    constant: [f64; 2],
    /// The orders n = 2, 4, 6, ...
    orders: Vec<Order>,
}

/// Terms of the series for a point load; enough for 1e-8 up to 0.9975 of the outer radius.
const POINT_TERMS: usize = 2000;
/// Largest number of terms for a spread load.
const MOST_TERMS: usize = 200_000;

impl Ring {
    /// Annulus under the load P per length (compression positive).
    ///
    /// ```text
    /// p(θ) = (P/πr_o) [1 + 2 Σ f_n cos nθ],  n = 2, 4, ...
    /// f_n = 1 (point load),  2 J₁(nα)/nα (semi-elliptic pressure of half angle α)
    /// φ = A₀ r² + B₀ ln r + Σ (A rⁿ + B r⁻ⁿ + C rⁿ⁺² + D r⁻ⁿ⁺²) cos nθ
    /// ```
    /// Michell 1899; Timoshenko and Goodier, *Theory of Elasticity*, art. 43 to 46. The constants
    /// of each n make the shear stress on both walls and the radial stress on the inner wall zero.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for P or r_i not positive, r_i above 0.995 r_o, or a half angle
    /// outside [6e-4, π/2).
    pub fn new(
        inner_radius: f64,
        outer_radius: f64,
        load_per_length: f64,
        body: Elastic,
        plane: PlaneState,
        load: RingLoad,
    ) -> Result<Self, DomainError> {
        let ri = error::positive("inner radius", inner_radius)?;
        // In thinner walls the constants of an order cancel.
        let allowed = "at most 0.995 of the outer radius";
        error::require("inner radius", ri, ri <= 0.995 * outer_radius, allowed)?;
        Self::with_bore(ri, outer_radius, load_per_length, body, plane, load)
    }

    /// Solid cylinder of radius r_o under the load P per length.
    ///
    /// # Errors
    /// As [`Ring::new`].
    pub fn solid(
        radius: f64,
        load_per_length: f64,
        body: Elastic,
        plane: PlaneState,
        load: RingLoad,
    ) -> Result<Self, DomainError> {
        Self::with_bore(0.0, radius, load_per_length, body, plane, load)
    }

    fn with_bore(
        inner_radius: f64,
        outer_radius: f64,
        load_per_length: f64,
        body: Elastic,
        plane: PlaneState,
        load: RingLoad,
    ) -> Result<Self, DomainError> {
        let ro = error::positive("outer radius", outer_radius)?;
        let p = error::positive("load per length", load_per_length)?;
        error::positive("Young's modulus", body.youngs_modulus())?;
        let half_angle = match load {
            RingLoad::Point => 0.0,
            RingLoad::SemiElliptic { half_angle: angle } => {
                let allowed = (6e-4..0.5 * PI).contains(&angle);
                error::require("half angle", angle, allowed, "at least 6e-4 and below π/2")?
            }
        };
        let count = match load {
            RingLoad::Point => POINT_TERMS,
            // Half the orders, up to n = 120/α.
            RingLoad::SemiElliptic { .. } => ((60.0 / half_angle) as usize).clamp(200, MOST_TERMS),
        };
        let mean = error::representable("mean pressure", p / (PI * ro))?;
        let bore = inner_radius / ro;
        let constant = -0.5 * mean / (1.0 - bore * bore);
        let pressure = |n: f64| 2.0 * mean * spread(n * half_angle);
        let terms = (1..=count).map(|i| 2.0 * i as f64);
        Ok(Self {
            inner_radius,
            outer_radius: ro,
            load: p,
            body,
            plane,
            half_angle,
            mean,
            constant: [constant, -2.0 * constant * inner_radius * inner_radius],
            orders: terms.map(|n| Order::new(n, bore, pressure(n))).collect(),
        })
    }

    /// Load P per length.
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Stress at the radius r and the angle θ from the load.
    ///
    /// Under point loads the disc's part is summed in closed form (two of Flamant's fields and an
    /// even tension), so that the rest converges up to the outer surface. Under a spread load
    /// good to about 1e-3 on the outer surface itself, much better inside.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for r outside the annulus or θ not finite, and at the very
    /// point of a point load.
    pub fn stress(&self, r: f64, theta: f64) -> Result<PolarStress, DomainError> {
        self.check(r, theta)?;
        let point = self.half_angle == 0.0;
        let x2 = self.share(r).powi(2);
        let [mut radial, mut hoop, mut shear] = [0.0; 3];
        self.sum(r, !point, |n, [a, b, c, d]| {
            let (sin, cos) = (n * theta).sin_cos();
            let (a, b) = (n * (n - 1.0) * a / x2, n * (n + 1.0) * b / x2);
            radial += (-a - b + (n + 2.0 - n * n) * c + (2.0 - n - n * n) * d) * cos;
            hoop += (a + b + (n + 2.0) * (n + 1.0) * c + (2.0 - n) * (1.0 - n) * d) * cos;
            shear += (a - b + n * (n + 1.0) * c + n * (1.0 - n) * d) * sin;
        });
        let [a0, b0] = self.constant;
        let swirl = if r > 0.0 { b0 / r / r } else { 0.0 };
        radial += 2.0 * a0 + swirl;
        hoop += 2.0 * a0 - swirl;
        if point {
            // The disc has -P/πr_o of the even part.
            let disc = disc::under_points(r / self.outer_radius, theta)?.map(|s| s * self.mean);
            radial += disc[0] + self.mean;
            hoop += disc[1] + self.mean;
            shear += disc[2];
        }
        let axial = match self.plane {
            PlaneState::Strain => self.body.poissons_ratio() * (radial + hoop),
            PlaneState::Stress => 0.0,
        };
        Ok(PolarStress {
            radial,
            hoop,
            axial,
            shear,
        })
    }

    /// Hoop stress on the inner wall at the angle θ from the load; the largest tension is under
    /// the load, the largest compression at the side. The other components are zero there,
    /// except σ_z = ν σ_θ in plane strain.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a solid cylinder or θ not finite.
    pub fn bore_stress(&self, theta: f64) -> Result<PolarStress, DomainError> {
        error::positive("inner radius", self.inner_radius)?;
        self.stress(self.inner_radius, theta)
    }

    /// Displacement [u_r, u_θ] at the radius r and the angle θ, u_r outward positive.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for r outside the annulus or θ not finite; for a point load
    /// also within 30 degrees of it for r above 0.9975 r_o: it moves without bound.
    pub fn displacement(&self, r: f64, theta: f64) -> Result<[f64; 2], DomainError> {
        self.check(r, theta)?;
        let beside = theta.sin().abs() >= 0.5;
        let converges = self.half_angle > 0.0 || r <= 0.9975 * self.outer_radius || beside;
        error::require(
            "radius",
            r,
            converges,
            "at most 0.9975 of the outer radius near a point load",
        )?;
        let nu = self.body.poissons_ratio();
        let kappa = match self.plane {
            PlaneState::Strain => 3.0 - 4.0 * nu,
            PlaneState::Stress => (3.0 - nu) / (1.0 + nu),
        };
        let x = self.share(r);
        let [mut radial, mut around] = [0.0; 2];
        self.sum(r, true, |n, [a, b, c, d]| {
            let (sin, cos) = (n * theta).sin_cos();
            let (a, b, c, d) = (n * a / x, n * b / x, c * x, d * x);
            radial += (b - a + (kappa - n - 1.0) * c + (kappa + n - 1.0) * d) * cos;
            around += (a + b + (kappa + n + 1.0) * c - (kappa - n + 1.0) * d) * sin;
        });
        let [a0, b0] = self.constant;
        let swirl = if r > 0.0 { b0 / r } else { 0.0 };
        let stiffness = 2.0 * self.body.shear_modulus();
        let radial = radial * self.outer_radius + (kappa - 1.0) * a0 * r - swirl;
        Ok([radial / stiffness, around * self.outer_radius / stiffness])
    }

    /// Change of the diameter 2r at the angle θ from the load, 2 u_r(r, θ): negative under the
    /// load (θ = 0), positive across it (θ = π/2).
    ///
    /// # Errors
    /// As [`Ring::displacement`].
    pub fn diameter_change(&self, r: f64, theta: f64) -> Result<f64, DomainError> {
        Ok(2.0 * self.displacement(r, theta)?[0])
    }

    fn check(&self, r: f64, theta: f64) -> Result<(), DomainError> {
        let inside = (self.inner_radius..=self.outer_radius).contains(&r);
        error::require(
            "radius",
            r,
            inside,
            "between the inner and the outer radius",
        )?;
        error::finite("angle", theta).map(|_| ())
    }

    /// r/r_o, kept off zero so that rⁿ⁻² has its limit in the middle of a solid cylinder.
    fn share(&self, r: f64) -> f64 {
        (r / self.outer_radius).max(1e-100)
    }

    /// Calls `add` with n and the four constants, each times its power of r; without the disc's
    /// share unless `with_disc`.
    fn sum(&self, r: f64, with_disc: bool, mut add: impl FnMut(f64, [f64; 4])) {
        let rise = self.share(r).powi(2);
        let fall = if self.inner_radius > 0.0 {
            (self.inner_radius / r).powi(2)
        } else {
            0.0
        };
        let share = if with_disc { 1.0 } else { 0.0 };
        let (mut outer, mut inner, mut n) = (1.0, 1.0, 0.0);
        for Order {
            disc,
            bore: [a, b, c, d],
        } in &self.orders
        {
            (outer, inner, n) = (outer * rise, inner * fall, n + 2.0);
            let (a, c) = (a + share * disc[0], c + share * disc[1]);
            add(n, [a * outer, b * inner, c * outer, d * inner]);
            if outer.max(inner) < 1e-40 {
                break;
            }
        }
    }
}

/// 2 J₁(t)/t.
fn spread(t: f64) -> f64 {
    if t == 0.0 { 1.0 } else { 2.0 * libm::j1(t) / t }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_form_and_series_of_the_disc_agree() {
        let body = Elastic::new(1.0, 0.3).unwrap();
        let disc = Ring::solid(2.0, 3.0, body, PlaneState::Strain, RingLoad::Point).unwrap();
        // A load spread over a thousandth of the radius is a point load for the inside.
        let spread = RingLoad::SemiElliptic { half_angle: 1e-3 };
        let spread = Ring::solid(2.0, 3.0, body, PlaneState::Strain, spread).unwrap();
        for (r, theta) in [(0.0, 0.3), (0.5, 0.0), (1.0, 1.0), (1.5, 2.0), (1.8, 1.5)] {
            let (a, b) = (
                disc.stress(r, theta).unwrap(),
                spread.stress(r, theta).unwrap(),
            );
            for (a, b) in [(a.radial, b.radial), (a.hoop, b.hoop), (a.shear, b.shear)] {
                assert!((a - b).abs() < 1e-5, "{r} {theta}: {a} {b}");
            }
        }
    }
}
