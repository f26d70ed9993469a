//! What a roller of a bearing is made to, of whatever template.

use super::end_shape::RollerEnd;
use super::error::GeometryError;
use std::f64::consts::PI;

/// The dimensions of all rollers of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollerShape {
    /// D.
    pub diameter: f64,
    /// Wall of hollow rollers; `None` for solid ones.
    pub wall: Option<f64>,
    /// L.
    pub length: f64,
    /// Its ends.
    pub end: RollerEnd,
}

impl RollerShape {
    /// R = D/2.
    pub fn radius(&self) -> f64 {
        self.diameter / 2.0
    }

    /// Radius of the bore; zero for a solid roller.
    pub fn bore_radius(&self) -> f64 {
        self.wall.map_or(0.0, |wall| self.radius() - wall)
    }

    /// Length of its straight part, which bears: without rounded ends.
    pub fn straight(&self) -> f64 {
        self.length - self.end.rounded()
    }

    /// Where it ceases to face a plate of the length `plate`, from the middle: at its end, or at that of a plate that is shorter than its straight
    /// part.
    pub fn ends_on(&self, plate: f64) -> f64 {
        0.5 * if plate < self.straight() {
            plate
        } else {
            self.length
        }
    }

    /// Area of its cross-section.
    pub fn cross_section(&self) -> f64 {
        PI * (self.radius().powi(2) - self.bore_radius().powi(2))
    }

    /// The wall, or of a solid roller the half of its radius, to go by with element sizes.
    pub(super) fn nominal_wall(&self) -> f64 {
        self.wall.unwrap_or(self.diameter / 4.0)
    }

    /// Can it be made?
    pub(super) fn check(&self) -> Result<(), GeometryError> {
        GeometryError::positive("roller_diameter", self.diameter)?;
        GeometryError::positive("roller_length", self.length)?;
        self.check_wall()?;
        self.check_end()
    }

    fn check_wall(&self) -> Result<(), GeometryError> {
        let Some(wall) = self.wall else {
            return Ok(());
        };
        let [least, most] = [0.01, 0.49].map(|share| share * self.diameter);
        GeometryError::unless(
            wall >= least && wall <= most,
            "roller_wall",
            wall,
            || format!("must lie between {least} and {most} (0.01 and 0.49 diameters)"),
            "a roller without a bore is solid",
        )
    }

    fn check_end(&self) -> Result<(), GeometryError> {
        const HELP: &str = "the end of the roller must keep some of its wall";
        let (depth, of) = match self.wall {
            Some(wall) => (wall, "half the wall"),
            None => (self.diameter / 2.0, "half the radius"),
        };
        let (most, of) = match self.length / 2.0 < depth {
            true => (0.25 * self.length, "a quarter of the length"),
            false => (0.5 * depth, of),
        };
        let within = |key, value: f64| {
            let range = || format!("must be more than 0 and at most {most} ({of})");
            GeometryError::unless(value > 0.0 && value <= most, key, value, range, HELP)
        };
        match self.end {
            RollerEnd::Square => Ok(()),
            RollerEnd::Radius(radius) => within("roller_end.radius", radius),
            RollerEnd::Crown(crown) => within("roller_end.crown", crown),
            RollerEnd::CrownedRadius { radius, crown } => {
                within("roller_end.radius", radius)?;
                within("roller_end.crown", crown)?;
                let range = || {
                    let both = crown + radius;
                    format!("takes {both} with the radius, and at most {most} is left ({of})")
                };
                let fits = crown + radius <= most;
                GeometryError::unless(fits, "roller_end.crown", crown, range, HELP)
            }
        }
    }
}
