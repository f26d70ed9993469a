//! Planes of nodes beside the ends of rollers.

use super::grading::Stop;
use super::parameter::Parameter;
use super::roller_shape::RollerShape;
use crate::model::scene::EDGE_REACH;

/// What a plane of nodes parts from the rest at either end of a roller; nothing where both lengths are 0.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct EndZone {
    /// Radius of a rounded end. Without a plane where the fillet begins, a facet across that place makes the roller shorter
    /// than it is.
    radius: f64,
    /// How far from a sharp end the stress of a loaded edge counts. Without a plane there figures away from edges are read
    /// farther from the edge on one mesh and less on another.
    reach: f64,
}

impl EndZone {
    /// Of rollers that press on faces as long as these and have so much `room` inside of an end. Do the ends `carry`?
    pub fn new(
        roller: &RollerShape,
        faces: impl IntoIterator<Item = f64>,
        (carry, room): (bool, f64),
    ) -> Self {
        let own = roller.length.max(roller.diameter);
        let reach = EDGE_REACH * faces.into_iter().fold(own, f64::min);
        let if_fits = |length: f64| if length < 0.5 * room { length } else { 0.0 };
        let (radius, reach) = match roller.end.radius() {
            Some(radius) => (if_fits(radius), 0.0),
            None if carry => (0.0, if_fits(reach)),
            None => (0.0, 0.0),
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

    /// Elements at a sharp end, and where a fillet begins, are no longer than `most` and a share of the way from the end to
    /// the plane. Next to a sharp end a third: the second row carries too little, the third as much too much. A displaced
    /// roller stands on the beginning of its fillet: with a third it sank up to 3.4 % too far, with a fifth 1.3 %.
    pub fn end_size(self, most: f64) -> f64 {
        match self.length() {
            0.0 => most,
            fillet if self.radius > 0.0 => most.min(fillet / 5.0),
            reach => most.min(reach / 3.0),
        }
    }

    /// Stops of a grading from inside of a roller to its end at `end`, as in the templates: elements are smallest at a sharp
    /// end, and where a fillet begins.
    pub fn stops(self, end_size: f64, end: f64) -> Vec<Stop> {
        let size = Some(end_size);
        let plane = (end - self.length().copysign(end), size, 1.0);
        let end = (end, size.filter(|_| self.radius == 0.0), 1.0);
        match self.length() {
            0.0 => vec![end],
            _ => vec![plane, end],
        }
    }

    /// From an end to the plane.
    fn length(self) -> f64 {
        self.radius + self.reach
    }
}
