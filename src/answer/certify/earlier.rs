//! What the bars of a step need of those before it.

use super::descent::Travel;
use crate::answer::results::peaks::BodyPeaks;
use crate::ground::geometry::Vec3;

/// The end of a step before the one that is certified.
#[derive(Debug, Clone)]
pub struct Earlier<'a> {
    /// Forces of every contact pair, in their order.
    pub forces: Vec<Vec3>,
    /// Of what is loaded.
    pub travel: Option<Travel>,
    /// Peaks of every body, in their order.
    pub peaks: &'a [BodyPeaks],
}
