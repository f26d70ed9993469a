//! Dimensions of the bearing and where its parts lie.

use std::f64::consts::FRAC_PI_4;

use super::end_shape::RollerEnd;
use super::error::GeometryError;

/// A rolling bearing: two crossed rollers between three plates.
///
/// z points up and the origin is the centre of the intermediate plate, whose top is the valley
/// z = t/2 + |x| tan θ and whose bottom is the ridge z = -t/2 - |y| tan θ. The upper roller lies
/// along y at x = s, the upper plate is centred on x = 2 s; the lower roller lies along x at
/// y = s, the lower plate is centred on y = 2 s. The stack just touches at every interface.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingGeometry {
    /// D, of both rollers.
    pub diameter: f64,
    /// Wall of hollow rollers; `None` for solid ones.
    pub wall: Option<f64>,
    /// L, of both rollers.
    pub length: f64,
    /// θ, of the two faces on either side of each valley line, in radians.
    pub slope: f64,
    /// s, of the roller axes from the centre planes of the intermediate plate.
    pub offset: f64,
    /// t, where the two valley lines cross.
    pub intermediate_thickness: f64,
    /// Thickness of the upper plate.
    pub upper_thickness: f64,
    /// Thickness of the lower plate.
    pub lower_thickness: f64,
    /// Plates along x and along y.
    pub plan: [f64; 2],
    /// Of both rollers.
    pub end: RollerEnd,
}

/// Which roller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Roller {
    /// Along y.
    Upper,
    /// Along x.
    Lower,
}

impl Roller {
    /// Both, from the top down.
    pub const BOTH: [Self; 2] = [Self::Upper, Self::Lower];

    /// The name of its body in the mesh.
    pub fn body(self) -> &'static str {
        match self {
            Self::Upper => "upper_roller",
            Self::Lower => "lower_roller",
        }
    }

    /// The coordinate along its axis: 1 (y) or 0 (x).
    pub fn axis(self) -> usize {
        match self {
            Self::Upper => 1,
            Self::Lower => 0,
        }
    }

    /// The horizontal coordinate across its axis: 0 (x) or 1 (y).
    pub fn across(self) -> usize {
        1 - self.axis()
    }

    /// +1 above the intermediate plate, -1 below.
    pub fn side(self) -> f64 {
        match self {
            Self::Upper => 1.0,
            Self::Lower => -1.0,
        }
    }
}

impl BearingGeometry {
    /// R = D/2.
    pub fn radius(&self) -> f64 {
        self.diameter / 2.0
    }

    /// Radius of the bore; zero for a solid roller.
    pub fn bore_radius(&self) -> f64 {
        self.wall.map_or(0.0, |wall| self.radius() - wall)
    }

    /// Are the rollers in the middle? Then the bearing is symmetric about x = 0 and y = 0.
    pub fn is_centred(&self) -> bool {
        self.offset == 0.0
    }

    /// |z| of the roller axes: t/2 + s tan θ + R / cos θ.
    pub fn axis_height(&self) -> f64 {
        self.intermediate_thickness / 2.0
            + self.offset * self.slope.tan()
            + self.radius() / self.slope.cos()
    }

    /// Distance of the lines on which a roller touches its slopes from the valley line:
    /// s + R sin θ. A centred roller touches both slopes, a displaced one only the slope on the
    /// side that it is displaced to.
    pub fn v_line(&self) -> f64 {
        self.offset + self.radius() * self.slope.sin()
    }

    /// Positions across the roller of its lines of contact with the intermediate plate.
    pub fn v_lines(&self) -> Vec<f64> {
        let line = self.v_line();
        if self.is_centred() {
            vec![-line, line]
        } else {
            vec![line]
        }
    }

    /// |z| of the inner faces of the upper and the lower plate.
    pub fn flat_face(&self) -> f64 {
        self.axis_height() + self.radius()
    }

    /// The thickness of the thinnest plate.
    pub fn thinnest_plate(&self) -> f64 {
        let outer = self.upper_thickness.min(self.lower_thickness);
        outer.min(self.intermediate_thickness)
    }

    /// z of the lowest and the highest point of the stack.
    pub fn height_range(&self) -> [f64; 2] {
        [
            -self.flat_face() - self.lower_thickness,
            self.flat_face() + self.upper_thickness,
        ]
    }

    /// The centre of `roller`, in the middle of its axis.
    pub fn roller_centre(&self, roller: Roller) -> [f64; 3] {
        let mut centre = [0.0; 3];
        centre[roller.across()] = self.offset;
        centre[2] = roller.side() * self.axis_height();
        centre
    }

    /// Is this a bearing that can be built and meshed?
    ///
    /// # Errors
    /// Names the first dimension that is out of its range, with the range.
    pub fn check(&self) -> Result<(), GeometryError> {
        GeometryError::positive("roller_diameter", self.diameter)?;
        GeometryError::positive("roller_length", self.length)?;
        GeometryError::positive("plate_thickness.upper", self.upper_thickness)?;
        GeometryError::positive("plate_thickness.intermediate", self.intermediate_thickness)?;
        GeometryError::positive("plate_thickness.lower", self.lower_thickness)?;
        self.check_slope()?;
        self.check_wall()?;
        self.check_offset()?;
        self.end.check(self)
    }

    fn check_slope(&self) -> Result<(), GeometryError> {
        // A core of hexahedra needs room between the V line and its corner at 45 degrees.
        let (most, range) = match self.wall {
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

    fn check_wall(&self) -> Result<(), GeometryError> {
        let Some(wall) = self.wall else {
            return Ok(());
        };
        let [least, most] = [0.01 * self.diameter, 0.49 * self.diameter];
        GeometryError::unless(
            wall >= least && wall <= most,
            "roller_wall",
            wall,
            || format!("must lie between {least} and {most} (0.01 and 0.49 diameters)"),
            "a roller without a bore is solid",
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
        let most = plate.min(self.length / 2.0);
        GeometryError::unless(
            self.offset >= 0.0 && self.offset < most,
            "offset",
            self.offset,
            || format!("must be at least 0 and less than {most}"),
            "the rollers must cross each other and touch the intermediate plate within its edges \
             (at offset + R sin of the slope)",
        )
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The initial design of the reference study, in inches.
    pub fn initial() -> BearingGeometry {
        BearingGeometry {
            diameter: 3.0,
            wall: Some(0.75),
            length: 8.0,
            slope: 4f64.to_radians(),
            offset: 0.0,
            intermediate_thickness: 1.0,
            upper_thickness: 1.0,
            lower_thickness: 1.0,
            plan: [8.0, 8.0],
            end: RollerEnd::Square,
        }
    }

    #[test]
    fn a_roller_touches_its_slopes_and_cuts_none() {
        for offset in [0.0, 1.25, 2.5] {
            let bearing = BearingGeometry {
                offset,
                ..initial()
            };
            let [sine, cosine] = [bearing.slope.sin(), bearing.slope.cos()];
            // Distance of the axis from the plane of the slope on the side `side`.
            let distance = |side: f64| {
                let up = bearing.axis_height() - bearing.intermediate_thickness / 2.0;
                up * cosine - side * offset * sine
            };
            assert!((distance(1.0) - bearing.radius()).abs() < 1e-14);
            assert!(distance(-1.0) >= bearing.radius() - 1e-14);
            assert_eq!(bearing.v_lines().len(), if offset == 0.0 { 2 } else { 1 });
            assert!((bearing.v_line() - offset - 0.104_634_7).abs() < 1e-6);
        }
    }

    #[test]
    fn impossible_bearings_are_refused_by_name() {
        type Spoil = fn(&mut BearingGeometry);
        let spoilt: [(&str, Spoil); 14] = [
            ("roller_diameter", |b| b.diameter = 0.0),
            ("roller_length", |b| b.length = -1.0),
            ("roller_length", |b| b.length = f64::NAN),
            ("plate_thickness.upper", |b| b.upper_thickness = -1.0),
            ("plate_thickness.intermediate", |b| {
                b.intermediate_thickness = 0.0
            }),
            ("plate_thickness.lower", |b| {
                b.lower_thickness = f64::INFINITY
            }),
            ("roller_wall", |b| b.wall = Some(1.6)),
            ("slope", |b| b.slope = 45f64.to_radians()),
            ("slope", |b| b.slope = 0.0),
            ("offset", |b| b.offset = 4.0),
            ("offset", |b| b.offset = -0.1),
            ("plate_size", |b| b.plan[1] = 0.2),
            ("roller_end.radius", |b| b.end = RollerEnd::Radius(0.8)),
            ("roller_end.crown", |b| b.end = RollerEnd::Crown(-1.0)),
        ];
        assert!(initial().check().is_ok());
        for (key, spoil) in spoilt {
            let mut bearing = initial();
            spoil(&mut bearing);
            let error = bearing.check().expect_err(key);
            assert_eq!(error.key, key, "{error}");
        }
        let mut thick = initial();
        thick.wall = Some(2.0);
        let text = thick.check().expect_err("too thick").to_string();
        assert_eq!(
            text,
            "roller_wall = 2: must lie between 0.03 and 1.47 (0.01 and 0.49 diameters)"
        );
    }
}
