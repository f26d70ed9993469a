//! The stress of a bore under the load line, where the peak of its body lies there.

use super::figure::{Figure, Quantity, figure};
use crate::answer::results::bore::BoreStress;
use crate::ground::geometry::Vec3;

/// The stress of a bore as it is claimed, and the node of the largest one there.
pub(super) struct AtBore {
    pub body: String,
    pub at: Vec3,
    pub mises: f64,
    pub error: Option<f64>,
}

impl AtBore {
    /// Of all `bores`, by what is claimed of them.
    pub fn all(bores: &[(String, BoreStress)], claims: &[Figure]) -> Vec<Self> {
        let of = |(body, stress): &(String, BoreStress)| {
            let claim = figure(claims, Quantity::BoreMises, body)?;
            Some(Self {
                body: body.clone(),
                at: stress.nodal_at?,
                mises: claim.value,
                error: claim.error.discretisation,
            })
        };
        bores.iter().filter_map(of).collect()
    }
}
