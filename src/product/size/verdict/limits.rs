//! What a design is held against.

use crate::product::size::candidate::Candidate;
use crate::product::size::request::Request;

/// The limits of a design, and the radius of its rollers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Of p0.
    pub pressure: f64,
    /// Of the elastic Mises stress.
    pub yield_stress: f64,
    /// Half of D.
    pub radius: f64,
}

impl Limits {
    /// Of a bearing of two crossed rollers.
    pub fn of(request: &Request, design: &Candidate) -> Self {
        Self {
            pressure: request.limit.value * request.yield_stress,
            yield_stress: request.yield_stress,
            radius: 0.5 * design.diameter,
        }
    }
}
