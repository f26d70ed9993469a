//! The range of every dimension within which parallel rollers can be built and meshed.

use super::geometry::{LineGeometry, LinePlate};
use crate::case::bearing::error::GeometryError;
use crate::case::bearing::layout::Layout;

/// The most rollers.
pub const MOST_ROLLERS: usize = 12;
/// Neighbours keep this share of a diameter apart.
const APART: f64 = 0.01;
/// The plates reach this share of a diameter beyond the outermost lines of contact.
const BEYOND: f64 = 0.1;

impl LineGeometry {
    /// Is this a bearing that can be built and meshed?
    ///
    /// # Errors
    /// Names the first dimension that is out of its range, with the range.
    pub fn check(&self) -> Result<(), GeometryError> {
        let count = self.rollers as f64;
        GeometryError::unless(
            (1..=MOST_ROLLERS).contains(&self.rollers),
            "rollers",
            count,
            || format!("must lie between 1 and {MOST_ROLLERS}"),
            "how many rollers lie side by side",
        )?;
        self.roller().check()?;
        GeometryError::positive("plate_thickness.upper", self.upper.thickness)?;
        GeometryError::positive("plate_thickness.lower", self.lower.thickness)?;
        self.check_spacing()?;
        self.check_plate("plate_size.upper", &self.upper)?;
        self.check_plate("plate_size.lower", &self.lower)?;
        self.check_curve()
    }

    fn check_spacing(&self) -> Result<(), GeometryError> {
        let least = (1.0 + APART) * self.roller.diameter;
        GeometryError::unless(
            self.rollers == 1 || self.spacing >= least,
            "spacing",
            self.spacing,
            || "must be at least 1.01 diameters".to_owned(),
            "nearer rollers overlap, or touch each other",
        )
    }

    fn check_plate(&self, key: &'static str, plate: &LinePlate) -> Result<(), GeometryError> {
        let [across, along] = plate.plan;
        let least = 2.0 * (self.place(self.rollers) + BEYOND * self.roller.diameter);
        GeometryError::unless(
            across >= least,
            key,
            across,
            || format!("must be at least {least} along x"),
            "the plates must reach a tenth of a diameter beyond the lines of contact of the outermost rollers",
        )?;
        let least = self.roller.length;
        GeometryError::unless(
            along >= least * (1.0 - 1e-12),
            key,
            along,
            || format!("must be at least {least} along y (the roller's length)"),
            "the rollers must not stand out beyond the plates: shorten them, or make the plates longer",
        )
    }

    fn check_curve(&self) -> Result<(), GeometryError> {
        let Some(curve) = self.curve else {
            return Ok(());
        };
        let plate = if curve.upper { self.upper } else { self.lower };
        let half = plate.plan[0] / 2.0;
        let key = "plate_curve.radius";
        GeometryError::unless(
            self.rollers == 1,
            "rollers",
            self.rollers as f64,
            || "must be 1 with a curved plate".into(),
            "rollers side by side on a curved plate would not all touch a flat one",
        )?;
        let least = if curve.convex {
            half
        } else {
            half.max(1.02 * self.roller.diameter / 2.0)
        };
        GeometryError::unless(
            curve.radius > least,
            key,
            curve.radius,
            || format!("must be more than {least}"),
            "it must be more than half the plate along x, and a groove wider than the roller",
        )?;
        let depth = curve.recedes(half).abs();
        let most = match curve.convex {
            true => 0.8 * plate.thickness,
            false => 0.8 * self.roller.diameter / 2.0,
        };
        GeometryError::unless(
            depth <= most,
            key,
            curve.radius,
            || format!("makes the face {depth} deep at its edges, and at most {most} is left"),
            "a larger radius, or a plate that is narrower along x or thicker",
        )
    }
}
