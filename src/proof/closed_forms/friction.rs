//! Stick and slip of Hertz contacts under a constant normal and a growing tangential load.
//!
//! Both bodies of one material (Dundurs' β = 0, see
//! [`dundurs_beta`](crate::analytic::elastic::dundurs_beta)), Coulomb's coefficient μ. The stresses under
//! full sliding are in [`LineField::sliding`](crate::analytic::subsurface::LineField::sliding).

use crate::analytic::elastic::Elastic;
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::LineContact;
use crate::analytic::hertz::PointContact;

/// Share Q/μP of the sliding load, in [0, 1].
fn sliding_share(tangential: f64, friction: f64, normal: f64) -> Result<f64, DomainError> {
    let q = error::non_negative("tangential load", tangential)?;
    let mu = error::positive("coefficient of friction", friction)?;
    let limit = error::representable("sliding load", mu * normal)?;
    let range = "between zero and the sliding load μP";
    Ok(error::require("tangential load", q, q <= limit, range)? / limit)
}

/// Two cylinders pressed together and then pushed sideways: the middle sticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CattaneoMindlin {
    contact: LineContact,
    friction: f64,
    /// Half width c of the sticking strip; zero in full sliding.
    pub stick_half_width: f64,
}

impl CattaneoMindlin {
    /// Tangential load Q per length in [0, μw] on `contact`.
    ///
    /// ```text
    /// c/a = √(1 - Q/μw)
    /// ```
    /// Cattaneo 1938, Mindlin 1949; Johnson 7.2(d).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for μ not positive or Q outside its range.
    pub fn new(contact: LineContact, tangential: f64, friction: f64) -> Result<Self, DomainError> {
        let share = sliding_share(tangential, friction, contact.line_load)?;
        let stick_half_width = contact.half_width * (1.0 - share).sqrt();
        Ok(Self {
            contact,
            friction,
            stick_half_width,
        })
    }

    /// Traction q(x), in the direction of Q; zero outside the contact.
    ///
    /// ```text
    /// q = μp0 [√(1 - x²/a²) - (c/a) √(1 - x²/c²)]  for |x| < c,   μ p(x) outside it
    /// ```
    /// Johnson 7.2(d).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a distance that is not a number.
    pub fn traction(&self, x: f64) -> Result<f64, DomainError> {
        let slip = self.friction * self.contact.pressure(x)?;
        let c = self.stick_half_width;
        if x.abs() >= c {
            return Ok(slip);
        }
        let ratio = c / self.contact.half_width;
        let inner = (1.0 - (x / c) * (x / c)).sqrt();
        Ok(slip - self.friction * self.contact.peak_pressure * ratio * inner)
    }
}

/// Two spheres pressed together and then pushed sideways: a circle in the middle sticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MindlinSpheres {
    contact: PointContact,
    friction: f64,
    share: f64,
    /// Radius c of the sticking circle; zero in full sliding.
    pub stick_radius: f64,
}

impl MindlinSpheres {
    /// Tangential load Q in [0, μP] on `contact`.
    ///
    /// ```text
    /// c/a = (1 - Q/μP)^(1/3)
    /// ```
    /// Mindlin 1949; Johnson (7.41).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for μ not positive or Q outside its range.
    pub fn new(contact: PointContact, tangential: f64, friction: f64) -> Result<Self, DomainError> {
        let share = sliding_share(tangential, friction, contact.load)?;
        let stick_radius = contact.contact_radius * (1.0 - share).cbrt();
        Ok(Self {
            contact,
            friction,
            share,
            stick_radius,
        })
    }

    /// Shift of distant points of the two bodies against each other, along Q.
    ///
    /// ```text
    ///      3μP   2 - ν₁   2 - ν₂
    /// δ =  ─── ( ────── + ────── ) [1 - (1 - Q/μP)^(2/3)]
    ///      16a     G₁       G₂
    /// ```
    /// Johnson (7.42).
    pub fn shift(&self, first: Elastic, second: Elastic) -> f64 {
        let soft = |body: Elastic| (2.0 - body.poissons_ratio()) / body.shear_modulus();
        let slide = self.friction * self.contact.load / self.contact.contact_radius;
        let spread = 1.0 - (1.0 - self.share).cbrt().powi(2);
        3.0 / 16.0 * slide * (soft(first) + soft(second)) * spread
    }

    /// Traction at the distance r from the centre, in the direction of Q; zero outside.
    ///
    /// The rule of [`CattaneoMindlin::traction`] holds with r for x; Johnson 7.2(d).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a distance that is not a number.
    pub fn traction(&self, r: f64) -> Result<f64, DomainError> {
        let slip = self.friction * self.contact.pressure(r)?;
        let c = self.stick_radius;
        if r.abs() >= c {
            return Ok(slip);
        }
        let ratio = c / self.contact.contact_radius;
        let inner = (1.0 - (r / c) * (r / c)).sqrt();
        Ok(slip - self.friction * self.contact.peak_pressure * ratio * inner)
    }
}
