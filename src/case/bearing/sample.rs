//! A bearing for tests.

use super::end_shape::RollerEnd;
use super::geometry::BearingGeometry;
use super::roller_shape::RollerShape;

/// The initial design of the reference study, in inches.
pub fn initial() -> BearingGeometry {
    BearingGeometry {
        roller: RollerShape {
            diameter: 3.0,
            wall: Some(0.75),
            length: 8.0,
            end: RollerEnd::Square,
        },
        slope: 4f64.to_radians(),
        offset: 0.0,
        intermediate_thickness: 1.0,
        upper_thickness: 1.0,
        lower_thickness: 1.0,
        plan: [8.0, 8.0],
        skew: [0.0; 2],
    }
}
