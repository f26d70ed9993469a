//! A roller off the centre: how the load spreads along it (statics).

use super::error::{self, DomainError};

/// A roller of length L under the load P, whose resultant passes e beside its mid-length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DisplacedRoller {
    load: f64,
    length: f64,
    offset: f64,
}

/// A picture of the line load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpreadLoad {
    /// Largest load per length.
    pub largest: f64,
    /// Length that carries load, from the end next to the resultant.
    pub bearing_length: f64,
}

impl DisplacedRoller {
    /// Load P, length L, offset e in [0, L/2).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for P or L not positive, or e outside its range.
    pub fn new(load: f64, length: f64, offset: f64) -> Result<Self, DomainError> {
        let length = error::positive("length", length)?;
        let e = error::non_negative("offset of the load", offset)?;
        error::require(
            "offset of the load",
            e,
            e < 0.5 * length,
            "less than half the length",
        )?;
        Ok(Self {
            load: error::positive("load", load)?,
            length,
            offset: e,
        })
    }

    /// Even load over the length centred on the resultant, w = P / (L - 2e).
    ///
    /// What (2-51) of the reference study assumes. It balances the load, but needs surfaces that
    /// turn until all of that length bears alike.
    pub fn block(&self) -> SpreadLoad {
        let bearing_length = self.length - 2.0 * self.offset;
        SpreadLoad {
            largest: self.load / bearing_length,
            bearing_length,
        }
    }

    /// Linear distribution that cannot pull, as under a rigid plate on a bed of springs.
    ///
    /// ```text
    /// e ≤ L/6:  w = (P/L)(1 + 6e/L) over L         else:  w = 2P / 3(L/2 - e) over 3(L/2 - e)
    /// ```
    pub fn linear(&self) -> SpreadLoad {
        let Self {
            load,
            length,
            offset,
        } = *self;
        if 6.0 * offset <= length {
            let largest = load / length * (1.0 + 6.0 * offset / length);
            return SpreadLoad {
                largest,
                bearing_length: length,
            };
        }
        let bearing_length = 3.0 * (0.5 * length - offset);
        SpreadLoad {
            largest: 2.0 * load / bearing_length,
            bearing_length,
        }
    }

    /// Length L at which [`linear`](Self::linear) presses with just `largest` per length under the
    /// load P, whose resultant passes e beside mid-length: [`linear`](Self::linear) solved for L.
    ///
    /// ```text
    /// L = (P + √(P² + 24 e P w)) / 2w  where that is 6e or more, else  L = 2e + 4P / 3w
    /// ```
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for P or w not positive, or e negative.
    pub fn length_for(load: f64, offset: f64, largest: f64) -> Result<f64, DomainError> {
        let p = error::positive("load", load)?;
        let e = error::non_negative("offset of the load", offset)?;
        let w = error::positive("largest load per length", largest)?;
        let bearing_all_along = 0.5 * (p / w) * (1.0 + (1.0 + 24.0 * e * w / p).sqrt());
        let length = if bearing_all_along >= 6.0 * e {
            bearing_all_along
        } else {
            2.0 * e + 4.0 * p / (3.0 * w)
        };
        error::representable("length", length)
    }

    /// The linear distribution at the distance y from mid-length, positive towards the resultant;
    /// zero where the roller lifts off and beyond its ends.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a y that is not finite.
    pub fn linear_at(&self, y: f64) -> Result<f64, DomainError> {
        let half = 0.5 * self.length;
        if error::finite("distance from mid-length", y)?.abs() > half {
            return Ok(0.0);
        }
        let SpreadLoad {
            largest,
            bearing_length,
        } = self.linear();
        if 6.0 * self.offset <= self.length {
            let mean = self.load / self.length;
            return Ok(mean + (largest - mean) * y / half);
        }
        Ok((largest * (1.0 - (half - y) / bearing_length)).max(0.0))
    }
}
