//! Planes of nodes beside the ends of rollers.

use super::grading::Stop;
use super::parameter::Parameter;
use super::roller_shape::RollerShape;
use crate::model::scene::EDGE_REACH;

/// What planes of nodes part from the rest at either end of a roller; nothing where both lengths are 0.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct EndZone {
    /// Radius of a rounded end. Without a plane where the fillet begins, a facet across that place makes the roller shorter
    /// than it is.
    radius: f64,
    /// How far from a sharp end, or from where a fillet begins, the stress of a loaded edge counts. Without a plane there
    /// figures away from edges are read farther from the edge on one mesh and less on another.
    reach: f64,
}

/// Elements from a loaded edge to where it ceases to count. The second row from a sharp end carries too little, the third as
/// much too much.
const IN_REACH: f64 = 3.0;

impl EndZone {
    /// Of rollers that press on faces as long as these and have so much `room` inside of an end. Do square ends `carry`?
    pub fn new(
        roller: &RollerShape,
        faces: impl IntoIterator<Item = f64>,
        (carry, room): (bool, f64),
    ) -> Self {
        let own = roller.length.max(roller.diameter);
        let reach = EDGE_REACH * faces.into_iter().fold(own, f64::min);
        let fits = |length: f64| length < 0.5 * room;
        let radius = roller.end.radius().filter(|radius| fits(*radius));
        let carry = carry || radius.is_some();
        let radius = radius.unwrap_or(0.0);
        let reach = if carry && fits(radius + reach) {
            reach
        } else {
            0.0
        };
        Self { radius, reach }
    }

    /// The same of the edge of a plate that is shorter than the roller.
    pub fn sharp(self) -> Self {
        Self {
            radius: 0.0,
            ..self
        }
    }

    /// What tells the templates of it.
    pub fn parameters(self) -> impl Iterator<Item = Parameter> {
        let all = [("EndRadius", self.radius), ("EdgeReach", self.reach)];
        (all.into_iter())
            .filter(|(_, length)| *length > 0.0)
            .map(|(name, length)| Parameter::length(name, length))
    }

    /// Elements at a sharp end, and where a fillet begins, are no longer than `most` and a share of the way from there to
    /// where the edge ceases to count, and a fifth of a fillet: a displaced roller stands on its beginning, and with a third it
    /// sank up to 3.4 % too far, with a fifth 1.3 %.
    pub fn end_size(self, most: f64) -> f64 {
        let bounds = [self.reach / IN_REACH, self.radius / 5.0];
        let given = bounds.into_iter().filter(|bound| *bound > 0.0);
        given.fold(most, f64::min)
    }

    /// Stops of a grading from inside of a roller to its end at `end`, as in the templates: elements are smallest at a sharp
    /// end, and where a fillet begins.
    pub fn stops(self, end_size: f64, end: f64) -> Vec<Stop> {
        let from_end = |distance: f64, size: Option<f64>| (end - distance.copysign(end), size, 1.0);
        let (radius, size) = (self.radius, Some(end_size));
        let mut stops = Vec::new();
        if self.reach > 0.0 {
            let size = end_size.max(self.reach / IN_REACH);
            stops.push(from_end(radius + self.reach, Some(size)));
        }
        if radius > 0.0 {
            stops.push(from_end(radius, size));
        }
        stops.push((end, size.filter(|_| radius == 0.0), 1.0));
        stops
    }
}
