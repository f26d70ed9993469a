//! Stick and slip of two cylinders under a constant normal and a growing tangential load.
//!
//! Both bodies of one material (Dundurs' β = 0, see
//! [`dundurs_beta`](crate::analytic::elastic::dundurs_beta)), Coulomb's coefficient μ. The stresses under
//! full sliding are in [`LineField::sliding`](crate::analytic::subsurface::LineField::sliding).

use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::LineContact;

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
        let q = error::non_negative("tangential load", tangential)?;
        let mu = error::positive("coefficient of friction", friction)?;
        let limit = error::representable("sliding load", mu * contact.line_load)?;
        let range = "between zero and the sliding load μP";
        let share = error::require("tangential load", q, q <= limit, range)? / limit;
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
