//! The profile of a roller near its ends.

/// The shape of the ends of a roller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RollerEnd {
    /// A sharp edge.
    Square,
    /// The edge rounded with this radius.
    Radius(f64),
    /// A logarithmic crown that has dropped this much at the ends.
    Crown(f64),
    /// Both: the drops of the two add up.
    CrownedRadius {
        /// Of the rounded edge.
        radius: f64,
        /// Drop of the crown at the ends.
        crown: f64,
    },
}

impl RollerEnd {
    /// Radius of the edge, where it is rounded.
    pub fn radius(self) -> Option<f64> {
        match self {
            Self::Radius(radius) | Self::CrownedRadius { radius, .. } => Some(radius),
            Self::Square | Self::Crown(_) => None,
        }
    }

    /// What both ends take off the straight part of a roller where they are rounded.
    pub fn rounded(self) -> f64 {
        2.0 * self.radius().unwrap_or(0.0)
    }

    /// Does the profile drop all along the roller?
    pub fn is_crowned(self) -> bool {
        matches!(self, Self::Crown(_) | Self::CrownedRadius { .. })
    }

    /// How far the profile of a roller of `length` and `radius` lies below the cylinder at the
    /// distance `along` from its middle.
    ///
    /// The crown is Lundberg's, whose logarithm is infinite at the very end, in the form of
    /// Johns and Gohar that bounds it: A ln 1/(1 - (1 - ε)(2 y/L)²) with ε = 0.3033 · 2 b/L.
    /// The half-width b is that of a strip of steel on steel at p0 = E*/100, b = 0.02 R; A is
    /// such that the end drop is as given.
    pub fn drop_at(self, along: f64, length: f64, radius: f64) -> f64 {
        let half = length / 2.0;
        match self {
            Self::Square => 0.0,
            Self::Radius(fillet) => {
                let into = (along.abs() - (half - fillet)).clamp(0.0, fillet);
                fillet - (fillet * fillet - into * into).sqrt()
            }
            Self::Crown(drop) => {
                let bound = 0.3033 * 0.02 * radius / half;
                let share = (along / half).powi(2).min(1.0);
                drop * (1.0 - (1.0 - bound) * share).ln() / bound.ln()
            }
            Self::CrownedRadius {
                radius: fillet,
                crown,
            } => {
                let of = |end: Self| end.drop_at(along, length, radius);
                of(Self::Radius(fillet)) + of(Self::Crown(crown))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fillet_is_a_quarter_circle() {
        let end = RollerEnd::Radius(0.25);
        assert_eq!(end.drop_at(3.75, 8.0, 1.5), 0.0);
        assert_eq!(end.drop_at(-4.0, 8.0, 1.5), 0.25);
        let along = 3.75 + 0.25 * 0.6;
        assert!((end.drop_at(along, 8.0, 1.5) - 0.25 * 0.2).abs() < 1e-15);
    }

    #[test]
    fn a_crown_with_a_fillet_drops_by_both() {
        let end = RollerEnd::CrownedRadius {
            radius: 0.25,
            crown: 0.002,
        };
        assert!((end.drop_at(4.0, 8.0, 1.5) - 0.252).abs() < 1e-15);
        let crown = RollerEnd::Crown(0.002).drop_at(3.0, 8.0, 1.5);
        assert_eq!(end.drop_at(3.0, 8.0, 1.5), crown);
    }

    #[test]
    fn a_crown_starts_in_the_middle_and_ends_at_its_drop() {
        let end = RollerEnd::Crown(0.002);
        assert_eq!(end.drop_at(0.0, 8.0, 1.5), 0.0);
        assert!((end.drop_at(4.0, 8.0, 1.5) - 0.002).abs() < 1e-17);
        assert_eq!(end.drop_at(-3.0, 8.0, 1.5), end.drop_at(3.0, 8.0, 1.5));
        // Flat in the middle: a quarter of the way out, a hundredth of the drop.
        assert!(end.drop_at(1.0, 8.0, 1.5) < 0.02 * 0.002);
    }
}
