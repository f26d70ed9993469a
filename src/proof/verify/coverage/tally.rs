//! Shares and middles over many claims.

use super::measure::{BarVerdict, ClaimRecord};
use super::quantile::quantile;

/// What came of a group of claims.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Tally {
    pub claims: usize,
    /// Of bearings that have true values.
    pub compared: usize,
    pub holds: usize,
    pub missed: usize,
    pub undecidable: usize,
    pub unresolved: usize,
    /// True errors and bars of the claims that have both, relative: middle, and nine of ten.
    pub error: Option<f64>,
    pub error_90: Option<f64>,
    pub bar: Option<f64>,
}

impl Tally {
    pub fn of<'r>(records: impl IntoIterator<Item = &'r ClaimRecord>) -> Self {
        let mut tally = Self::default();
        let (mut errors, mut bars) = (Vec::new(), Vec::new());
        for record in records {
            tally.claims += 1;
            tally.compared += usize::from(record.compared);
            match record.verdict {
                BarVerdict::Holds => tally.holds += 1,
                BarVerdict::Missed => tally.missed += 1,
                BarVerdict::Undecidable => tally.undecidable += 1,
                BarVerdict::Unresolved => tally.unresolved += 1,
                BarVerdict::Unknown => {}
            }
            if let (Some(error), Some(bar)) = (record.error(), record.bar()) {
                errors.push(error);
                bars.push(bar);
            }
        }
        Self {
            error: quantile(errors.clone(), 0.5),
            error_90: quantile(errors, 0.9),
            bar: quantile(bars, 0.5),
            ..tally
        }
    }

    /// Share of the claims that can be decided that hold.
    pub fn covered(&self) -> Option<f64> {
        share(self.holds, self.holds + self.missed)
    }

    /// Of all claims about bearings that have true values.
    pub fn undecided(&self) -> Option<f64> {
        share(self.undecidable, self.compared)
    }

    /// Of all claims.
    pub fn without_bar(&self) -> Option<f64> {
        share(self.unresolved, self.claims)
    }

    /// The bar in the middle over the error in the middle.
    pub fn width(&self) -> Option<f64> {
        Some(self.bar? / self.error.filter(|e| *e > 0.0)?)
    }
}

fn share(part: usize, whole: usize) -> Option<f64> {
    (whole > 0).then(|| part as f64 / whole as f64)
}
