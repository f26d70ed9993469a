//! How a figure stands to its limit.

use serde::Serialize;

/// Why nothing is known of a figure's error.
pub const UNRESOLVED: &str = "this mesh does not resolve it";

/// How a figure stands to its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SizeStanding {
    Met,
    /// Met, but by less than the estimated error.
    MetWithinError,
    /// Missed, but by less than the estimated error.
    MissedWithinError,
    Missed,
    /// Not to be told on this mesh.
    Open,
    /// Nothing is known of the figure's error: no verdict on this mesh.
    Unresolved,
    /// Beside a loaded edge, where a figure belongs to the mesh.
    NotJudged,
}

impl SizeStanding {
    /// Of `value`, good to ± `error`, against the most that is allowed; where nothing is known of the error there is no verdict.
    pub fn of(value: f64, error: Option<f64>, limit: f64) -> Self {
        let Some(error) = error else {
            return Self::Unresolved;
        };
        match (value <= limit, (value - limit).abs() < error) {
            (true, false) => Self::Met,
            (true, true) => Self::MetWithinError,
            (false, true) => Self::MissedWithinError,
            // What is not a number is not met.
            (false, false) => Self::Missed,
        }
    }

    /// Does it miss the limit?
    pub fn is_missed(self) -> bool {
        matches!(self, Self::Missed | Self::MissedWithinError)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_shows_how_sure_a_limit_is_met() {
        let of = |value, error| SizeStanding::of(value, error, 100.0);
        assert_eq!(of(90.0, Some(5.0)), SizeStanding::Met);
        assert_eq!(of(96.0, Some(5.0)), SizeStanding::MetWithinError);
        assert_eq!(of(50.0, None), SizeStanding::Unresolved);
        assert_eq!(of(104.0, Some(5.0)), SizeStanding::MissedWithinError);
        assert_eq!(of(106.0, Some(5.0)), SizeStanding::Missed);
        assert_eq!(of(200.0, None), SizeStanding::Unresolved);
        assert!(of(f64::NAN, Some(5.0)).is_missed());
        assert!(!SizeStanding::Open.is_missed() && !SizeStanding::NotJudged.is_missed());
    }
}
