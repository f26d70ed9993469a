//! Dimensions of parallel rollers between two plates, and where they lie.

use crate::case::bearing::roller_shape::RollerShape;

/// One to twelve rollers side by side between two plates.
///
/// z points up, the rollers lie along y, side by side along x, and the origin is the middle of all of them. The stack
/// just touches at every interface.
#[derive(Debug, Clone, PartialEq)]
pub struct LineGeometry {
    /// How many rollers.
    pub rollers: usize,
    /// Distance between the axes of neighbours; 0 for a single roller.
    pub spacing: f64,
    /// Each of the rollers.
    pub roller: RollerShape,
    /// By how much each is turned about the vertical, in radians; missing ones lie straight.
    pub skew: Vec<f64>,
    /// The plate above.
    pub upper: LinePlate,
    /// The plate below.
    pub lower: LinePlate,
    /// One of the plates curved across the roller; both flat where there is none.
    pub curve: Option<PlateCurve>,
    /// Is the bearing its own image across x = 0, in its steels and temperatures too?
    pub alike: bool,
}

/// A plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePlate {
    /// Below or above the line of contact.
    pub thickness: f64,
    /// Along x and along y.
    pub plan: [f64; 2],
}

/// A plate whose face is a cylinder along the roller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlateCurve {
    /// The upper plate, or the lower one?
    pub upper: bool,
    /// Radius of the face.
    pub radius: f64,
    /// Does it bulge towards the roller? Else the roller lies in a groove.
    pub convex: bool,
}

impl PlateCurve {
    /// Curvature across the roller, positive where the face bulges towards it.
    pub fn curvature(&self) -> f64 {
        match self.convex {
            true => 1.0 / self.radius,
            false => -1.0 / self.radius,
        }
    }

    /// How far the face at `across` has gone away from the roller, off the tangent at the line of contact.
    pub fn recedes(&self, across: f64) -> f64 {
        let drop = self.radius
            - (self.radius * self.radius - across * across)
                .max(0.0)
                .sqrt();
        if self.convex { drop } else { -drop }
    }
}

impl LineGeometry {
    /// Where roller `number`, counted from 1, lies along x.
    pub fn place(&self, number: usize) -> f64 {
        // Whole steps from the middle, so that images lie exactly across from each other.
        (2.0 * number as f64 - 1.0 - self.rollers as f64) / 2.0 * self.spacing
    }

    /// The body of roller `number`.
    pub fn body(&self, number: usize) -> String {
        match self.rollers {
            1 => "roller".to_owned(),
            _ => format!("roller_{number}"),
        }
    }

    /// The end of the names of what belongs to one roller.
    pub(super) fn suffix(&self, number: usize) -> String {
        match self.rollers {
            1 => String::new(),
            _ => format!("_{number}"),
        }
    }

    /// Curvature of the upper or the lower plate.
    pub fn curvature(&self, upper: bool) -> f64 {
        let own = self.curve.filter(|curve| curve.upper == upper);
        own.map_or(0.0, |curve| curve.curvature())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_recedes_as_its_circle() {
        let mut curve = PlateCurve {
            upper: false,
            radius: 5.0,
            convex: true,
        };
        assert_eq!(curve.recedes(0.0), 0.0);
        assert!((curve.recedes(3.0) - 1.0).abs() < 1e-15);
        assert_eq!(curve.curvature(), 0.2);
        curve.convex = false;
        assert!((curve.recedes(-4.0) + 2.0).abs() < 1e-15);
        assert_eq!(curve.curvature(), -0.2);
    }
}
