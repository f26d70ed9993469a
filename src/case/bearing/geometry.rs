//! Dimensions of the bearing and where its parts lie.

use super::roller_shape::RollerShape;

/// A rolling bearing: two crossed rollers between three plates.
///
/// z points up and the origin is the centre of the intermediate plate, whose top is the valley
/// z = t/2 + |x| tan θ and whose bottom is the ridge z = -t/2 - |y| tan θ. The upper roller lies
/// along y at x = s, the upper plate is centred on x = 2 s; the lower roller lies along x at
/// y = s, the lower plate is centred on y = 2 s. The stack just touches at every interface.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingGeometry {
    /// Both rollers.
    pub roller: RollerShape,
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
    /// By how much each is turned about the vertical, in radians: the upper one and the lower one.
    pub skew: [f64; 2],
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
        self.roller.radius()
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::bearing::sample::initial;

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
}
