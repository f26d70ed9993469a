//! A thick tube under internal pressure in plane strain: elastic (Lamé) and yielding (Hill).

use super::steel::BilinearSteel;
use crate::analytic::error::{self, DomainError};
use crate::analytic::ring::PolarStress;
use crate::analytic::search::bisect;

/// Tube of inner radius a and outer radius b.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    inner_radius: f64,
    outer_radius: f64,
    steel: BilinearSteel,
}

impl Tube {
    /// Radii a < b and the steel's curve.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a not positive or b not above a.
    pub fn new(
        inner_radius: f64,
        outer_radius: f64,
        steel: BilinearSteel,
    ) -> Result<Self, DomainError> {
        let a = error::positive("inner radius", inner_radius)?;
        let b = error::positive("outer radius", outer_radius)?;
        error::require("inner radius", a, a < b, "less than the outer radius")?;
        Ok(Self {
            inner_radius: a,
            outer_radius: b,
            steel,
        })
    }

    /// Inner radius a.
    pub fn inner_radius(&self) -> f64 {
        self.inner_radius
    }

    /// Outer radius b.
    pub fn outer_radius(&self) -> f64 {
        self.outer_radius
    }

    /// The steel.
    pub fn steel(&self) -> &BilinearSteel {
        &self.steel
    }

    /// Elastic stress at the radius r under the pressure p.
    ///
    /// ```text
    /// σ_r, σ_θ = p a²/(b² - a²) (1 ∓ b²/r²)        σ_z = ν (σ_r + σ_θ)
    /// ```
    /// Lamé; Timoshenko and Goodier, art. 28.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for p negative, r outside the wall or ν outside (-1, 0.5].
    pub fn elastic_stress(
        &self,
        pressure: f64,
        poissons_ratio: f64,
        r: f64,
    ) -> Result<PolarStress, DomainError> {
        let (mean, swing) = self.lame(pressure, r)?;
        let axial = 2.0 * error::poissons_ratio(poissons_ratio)? * mean;
        Ok(PolarStress {
            radial: mean - swing,
            hoop: mean + swing,
            axial,
            shear: 0.0,
        })
    }

    /// Elastic displacement outward at the radius r under the pressure p.
    ///
    /// ```text
    /// u = (1 + ν)/E · p a²/(b² - a²) · [(1 - 2ν) r + b²/r]
    /// ```
    /// Lamé, plane strain.
    ///
    /// # Errors
    /// As [`Tube::elastic_stress`].
    pub fn elastic_displacement(
        &self,
        pressure: f64,
        poissons_ratio: f64,
        r: f64,
    ) -> Result<f64, DomainError> {
        let (mean, swing) = self.lame(pressure, r)?;
        let nu = error::poissons_ratio(poissons_ratio)?;
        Ok((1.0 + nu) / self.steel.youngs_modulus() * ((1.0 - 2.0 * nu) * mean + swing) * r)
    }

    /// The even and the opposite part of the elastic radial and hoop stress.
    fn lame(&self, pressure: f64, r: f64) -> Result<(f64, f64), DomainError> {
        let p = error::non_negative("pressure", pressure)?;
        let r = self.inside(r)?;
        let share = self.inner_radius / self.outer_radius;
        let unit = p / ((1.0 - share) * (1.0 + share));
        // Each from a share of at most one: b/r of the mean has no bound.
        let part = |share: f64| unit * share * share;
        Ok((part(share), part(self.inner_radius / r)))
    }

    fn inside(&self, r: f64) -> Result<f64, DomainError> {
        let allowed = (self.inner_radius..=self.outer_radius).contains(&r);
        error::require(
            "radius",
            r,
            allowed,
            "between the inner and the outer radius",
        )
    }

    /// Pressure at which the bore first yields by Hill's criterion σ_θ - σ_r = 2Y/√3, which is
    /// Mises' for ν = 0.5: p_Y = (Y/√3)(1 - a²/b²).
    ///
    /// Hill, *The Mathematical Theory of Plasticity*, 1950, ch. V.
    pub fn first_yield_pressure(&self) -> f64 {
        let share = self.inner_radius / self.outer_radius;
        self.flow() * 0.5 * (1.0 - share * share)
    }

    /// Pressure at which the bore first yields by Mises' criterion with Poisson's ratio ν.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for ν outside (-1, 0.5].
    pub fn first_yield_pressure_mises(&self, poissons_ratio: f64) -> Result<f64, DomainError> {
        let unit = self.elastic_stress(1.0, poissons_ratio, self.inner_radius)?;
        Ok(self.steel.yield_stress() / unit.mises())
    }

    /// Pressure at which a tube without hardening has yielded throughout: (2Y/√3) ln(b/a).
    pub fn limit_pressure(&self) -> f64 {
        self.flow() * (self.outer_radius / self.inner_radius).ln()
    }

    /// 2Y/√3.
    fn flow(&self) -> f64 {
        2.0 * self.steel.yield_stress() / 3f64.sqrt()
    }

    /// Pressure that drives the plastic front to the radius c.
    ///
    /// With Y' = 2Y/√3 and the tangent modulus E_t:
    /// ```text
    /// p = Y' [(1 - E_t/E) ln(c/a) + (E_t/2E)(c²/a² - 1) + ½ (1 - c²/b²)]
    /// ```
    /// Hill ch. V for E_t = 0 (any ν, with Hill's criterion). With hardening the closed form holds
    /// for an incompressible material, ν = 0.5, where Mises' criterion is Hill's.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for c outside the wall.
    pub fn pressure_at_front(&self, front: f64) -> Result<f64, DomainError> {
        let c = self.inside(front)? / self.inner_radius;
        let beyond = front / self.outer_radius;
        let hardening = self.steel.tangent_modulus() / self.steel.youngs_modulus();
        let plastic = (1.0 - hardening) * c.ln() + 0.5 * hardening * (c * c - 1.0);
        Ok(self.flow() * (plastic + 0.5 * (1.0 - beyond * beyond)))
    }

    /// Radius of the plastic front under the pressure p.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for p below first yield or above the pressure at which the
    /// front reaches the outside.
    pub fn front(&self, pressure: f64) -> Result<f64, DomainError> {
        let (a, b) = (self.inner_radius, self.outer_radius);
        let (first, full) = (self.first_yield_pressure(), self.pressure_at_front(b)?);
        let allowed = pressure >= first && pressure <= full;
        let range = format!("between first yield, {first}, and full yield, {full}");
        error::require("pressure", pressure, allowed, range)?;
        Ok(bisect(
            |c| self.pressure_at_front(c).unwrap_or(full) - pressure,
            a,
            b,
        ))
    }

    /// Displacement outward at the radius r with the front at c, incompressible (ν = 0.5):
    /// u = (√3/2)(Y/E) c²/r. Exact for Mises, with or without hardening.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for c or r outside the wall.
    pub fn displacement_incompressible(&self, front: f64, r: f64) -> Result<f64, DomainError> {
        let c = self.inside(front)?;
        Ok(0.5 * 3f64.sqrt() * self.steel.yield_strain() * c * (c / self.inside(r)?))
    }

    /// Displacement outward at the radius r with the front at c, compressible, without hardening.
    ///
    /// ```text
    /// u = (1 + ν)(1 - 2ν) σ_r r/E + (1 - ν²) Y' c²/Er
    /// σ_r = ½ Y' c² (1/b² - 1/r²) outside the front, -Y' [½ + ln(c/r) - ½ c²/b²] inside
    /// ```
    /// Hill ch. V. Exact for a Tresca-type criterion; for Mises with ν = 0.3 and b = 2a it is
    /// 0.06 % low at 73 % of the limit pressure and 2.3 % at 99 %:
    /// [`tube_mises`](super::tube_mises) has those values.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for c or r outside the wall, ν outside (-1, 0.5], or a steel
    /// that hardens.
    pub fn displacement_compressible(
        &self,
        front: f64,
        poissons_ratio: f64,
        r: f64,
    ) -> Result<f64, DomainError> {
        let tangent = self.steel.tangent_modulus();
        error::require(
            "tangent modulus",
            tangent,
            tangent == 0.0,
            "zero for this formula",
        )?;
        let nu = error::poissons_ratio(poissons_ratio)?;
        let (c, r) = (self.inside(front)?, self.inside(r)?);
        let (e, flow) = (self.steel.youngs_modulus(), self.flow());
        let beyond = (c / self.outer_radius).powi(2);
        let radial = if r >= c {
            0.5 * flow * (beyond - (c / r).powi(2))
        } else {
            -flow * (0.5 + (c / r).ln() - 0.5 * beyond)
        };
        let even = (1.0 + nu) * (1.0 - 2.0 * nu) * radial * r;
        Ok((even + (1.0 - nu * nu) * flow * c * (c / r)) / e)
    }
}
