//! The range of every dimension within which a bearing can be built and meshed.

use std::f64::consts::FRAC_PI_4;

use super::error::GeometryError;
use super::geometry::BearingGeometry;
use super::layout::Layout;

impl BearingGeometry {
    /// Is this a bearing that can be built and meshed?
    ///
    /// # Errors
    /// Names the first dimension that is out of its range, with the range.
    pub fn check(&self) -> Result<(), GeometryError> {
        self.roller().check()?;
        GeometryError::positive("plate_thickness.upper", self.upper_thickness)?;
        GeometryError::positive("plate_thickness.intermediate", self.intermediate_thickness)?;
        GeometryError::positive("plate_thickness.lower", self.lower_thickness)?;
        self.check_slope()?;
        self.check_offset()
    }

    fn check_slope(&self) -> Result<(), GeometryError> {
        // A core of hexahedra needs room between the V line and its corner at 45 degrees.
        let (most, range) = match self.roller.wall {
            Some(_) => (FRAC_PI_4, "must lie between 0.05 and 45 deg"),
            None => (
                FRAC_PI_4 - 0.1,
                "must lie between 0.05 and 39 deg (solid rollers)",
            ),
        };
        GeometryError::unless(
            self.slope >= 0.05_f64.to_radians() && self.slope < most,
            "slope",
            self.slope.to_degrees(),
            || range.into(),
            "the rollers rest in valleys: on a flat plate the two V lines are one",
        )
    }

    fn check_offset(&self) -> Result<(), GeometryError> {
        let sine = self.radius() * self.slope.sin();
        for side in self.plan {
            GeometryError::unless(
                side > 2.0 * sine,
                "plate_size",
                side,
                || format!("must be more than {} (2 R sin of the slope)", 2.0 * sine),
                "the rollers must rest on the intermediate plate",
            )?;
        }
        let plate = self.plan[0].min(self.plan[1]) / 2.0 - sine;
        let most = plate.min(self.roller.length / 2.0);
        GeometryError::unless(
            self.offset >= 0.0 && self.offset < most,
            "offset",
            self.offset,
            || format!("must be at least 0, and each roller less than {most} off"),
            "the rollers must cross each other and touch the intermediate plate within its edges \
             (at offset + R sin of the slope); `offset_is = \"bearing\"` allows twice as much, as \
             half of it is the roller's",
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::bearing::end_shape::RollerEnd;
    use crate::case::bearing::sample::initial;

    #[test]
    fn impossible_bearings_are_refused_by_name() {
        type Spoil = fn(&mut BearingGeometry);
        let spoilt: [(&str, Spoil); 14] = [
            ("roller_diameter", |b| b.roller.diameter = 0.0),
            ("roller_length", |b| b.roller.length = -1.0),
            ("roller_length", |b| b.roller.length = f64::NAN),
            ("plate_thickness.upper", |b| b.upper_thickness = -1.0),
            ("plate_thickness.intermediate", |b| {
                b.intermediate_thickness = 0.0
            }),
            ("plate_thickness.lower", |b| {
                b.lower_thickness = f64::INFINITY
            }),
            ("roller_wall", |b| b.roller.wall = Some(1.6)),
            ("slope", |b| b.slope = 45f64.to_radians()),
            ("slope", |b| b.slope = 0.0),
            ("offset", |b| b.offset = 4.0),
            ("offset", |b| b.offset = -0.1),
            ("plate_size", |b| b.plan[1] = 0.2),
            ("roller_end.radius", |b| {
                b.roller.end = RollerEnd::Radius(0.8)
            }),
            ("roller_end.crown", |b| {
                b.roller.end = RollerEnd::Crown(-1.0)
            }),
        ];
        assert!(initial().check().is_ok());
        for (key, spoil) in spoilt {
            let mut bearing = initial();
            spoil(&mut bearing);
            let error = bearing.check().expect_err(key);
            assert_eq!(error.key, key, "{error}");
        }
        let mut thick = initial();
        thick.roller.wall = Some(2.0);
        let text = thick.check().expect_err("too thick").to_string();
        assert_eq!(
            text,
            "roller_wall = 2: must lie between 0.03 and 1.47 (0.01 and 0.49 diameters)"
        );
    }
}
