//! The peak below strips as half spaces have it, beside the one that nodes show.

use crate::answer::results::peaks::BodyPeaks;

/// Share of what the rest of the stress beside the half spaces does, and of how unevenly, that the stress below them is off,
const OF_REST: f64 = 0.5;
/// and of itself at least. (Of 68 peaks below strips of bearings drawn by a seed, with one to two nodes in a half-width, 64 are within;
/// they err by 1.5 % in the middle, nodal averages by 12 %.)
const LEAST: f64 = 0.01;

/// What the half spaces below the strips on a body say of its peak, and how far off that may be.
#[derive(Debug, Clone, Copy)]
pub(super) struct HalfSpaces {
    pub mises: f64,
    pub error: f64,
    /// What nodes do not show either.
    by_turn: f64,
    /// Does a strip carry up to an edge, where the stress may be larger?
    pub at_edge: bool,
}

/// Where a peak that is read at nodes lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FromStrip {
    /// In the middle of a strip, on the surface.
    AtSurface,
    /// Below one.
    Below,
    /// Below none.
    Elsewhere,
}

impl HalfSpaces {
    /// Below the strips on a body; `pressures_off` say by pair how far their stress may be off, of itself. `None` where they say nothing,
    /// or the load of the strip is not known.
    pub fn below(body: &BodyPeaks, pressures_off: &[Option<f64>]) -> Option<Self> {
        let below = body.below_strips?;
        let of_load = (*pressures_off.get(below.pair)?)?;
        let of_rest = OF_REST * below.uneven.hypot(below.by_rest);
        let apart = of_rest.hypot(of_load * below.mises);
        Some(Self {
            mises: below.mises,
            error: apart + LEAST * below.mises + below.by_turn,
            by_turn: below.by_turn,
            at_edge: below.at_edge,
        })
    }

    /// Where that share of it may be wrong besides.
    pub fn with_share(self, share: f64) -> Self {
        Self {
            error: self.error + share * self.mises,
            ..self
        }
    }

    /// The peak and its error, beside the one that is read at nodes: of the strip, or elsewhere on the body. `None` where that stands
    /// as it is.
    pub fn beside(
        self,
        (value, error): (f64, Option<f64>),
        place: FromStrip,
    ) -> Option<(f64, f64)> {
        let of_strip = place != FromStrip::Elsewhere;
        match error {
            // Where both do not agree within their errors, neither is as well known as it says.
            Some(error) if of_strip => {
                // In the depth friction that turns has no part in what nodes show.
                let at_surface = place == FromStrip::AtSurface;
                let error = error.max(if at_surface { self.by_turn } else { 0.0 });
                let apart = (self.mises - value).abs();
                Some(match self.error < error {
                    true => (self.mises, self.error.max(apart - error)),
                    false => (value, error.max(apart - self.error)),
                })
            }
            None if of_strip => Some((self.mises, self.error)),
            // What is read elsewhere may be the larger one, or this.
            Some(error) if self.mises > value => {
                Some((self.mises, self.error.max(value + error - self.mises)))
            }
            Some(error) => Some((value, error.max(self.mises + self.error - value))),
            None => None,
        }
    }
}
