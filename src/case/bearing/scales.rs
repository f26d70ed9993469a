//! Finer elements where a figure asks for them: four groups of sizes, each with a scale of its own.

use super::sizes::Sizes;

/// Times the sizes of a mesh by what they decide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Elements across the contact lines and below them, the region of fine elements staying as wide and deep as it
    /// is: pressures and the stress below the strip.
    pub contact: f64,
    /// From there to the coarse elements, by how much they grow from one to the next: the stress below the strip. Growth by
    /// 2.5 right beyond a region as deep as the strip is wide makes that 1.3 % too large, however fine the region is.
    pub transition: f64,
    /// Elements around a roller and through its wall: the stress of the bore and the descent. The plates, which move
    /// the descent by a quarter as much, take the root.
    pub round: f64,
    /// Elements along the rollers: the largest load per length, and what is beside the ends.
    pub along: f64,
}

impl Default for Scales {
    fn default() -> Self {
        Self::all(1.0)
    }
}

impl Scales {
    /// All groups alike.
    pub fn all(scale: f64) -> Self {
        Self {
            contact: scale,
            transition: scale,
            round: scale,
            along: scale,
        }
    }

    /// Both, one after the other.
    pub fn and(&self, other: &Self) -> Self {
        Self {
            contact: self.contact * other.contact,
            transition: self.transition * other.transition,
            round: self.round * other.round,
            along: self.along * other.along,
        }
    }

    /// This share of the way, in logarithms: 0 leaves a mesh as it is.
    pub fn part(&self, share: f64) -> Self {
        Self {
            contact: self.contact.powf(share),
            transition: self.transition.powf(share),
            round: self.round.powf(share),
            along: self.along.powf(share),
        }
    }

    /// The sizes times these scales.
    pub(super) fn of(&self, mut sizes: Sizes) -> Sizes {
        let count = |count: &mut f64, scale: f64| {
            if scale != 1.0 {
                *count = (*count / scale).round().max(1.0);
            }
        };
        sizes.roller_size *= self.contact;
        sizes.plate_size *= self.contact;
        for fine in [&mut sizes.fine_elements, &mut sizes.fine_layers] {
            *fine = (*fine / self.contact).round().max(1.0);
        }
        // The transition decides less than the elements at the peak.
        let growth = self.transition.sqrt();
        sizes.growth = sizes.growth.powf(growth);
        sizes.depth_growth = sizes.depth_growth.powf(growth);
        sizes.around_cap *= self.round;
        sizes.wall_cap *= self.round;
        count(&mut sizes.wall_least, self.round);
        let plates = self.round.sqrt();
        for cap in [
            &mut sizes.plan_cap,
            &mut sizes.middle_cap,
            &mut sizes.depth_cap,
        ] {
            *cap *= plates;
        }
        count(&mut sizes.depth_least, plates);
        for along in [
            &mut sizes.crossing_size,
            &mut sizes.end_size,
            &mut sizes.along_cap,
        ] {
            *along *= self.along;
        }
        count(&mut sizes.along_least, self.along);
        sizes.along_growth = sizes.along_growth.powf(self.along);
        sizes
    }
}
