//! What a run did not need to do, and what that saved.

use std::fmt;

use serde::Serialize;

use super::text::significant;

/// Something that a run did not need to do.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct LeftOut {
    /// In words, such as "intermediate_plate: elastic, yield never checked".
    pub what: String,
    pub saved: Vec<Saving>,
}

/// A count of something that was saved.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Saving {
    pub count: u64,
    /// What is counted, in the plural.
    pub of: &'static str,
    /// Reckoned from the sizes of the model, not counted?
    pub estimate: bool,
}

impl LeftOut {
    /// With nothing said of what it saved.
    pub fn new(what: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            saved: Vec::new(),
        }
    }

    /// Saves exactly `count` of something; nothing is said of zero.
    pub fn saving(self, count: usize, of: &'static str) -> Self {
        self.add(count, of, false)
    }

    /// Saves about as many.
    pub fn saving_about(self, count: usize, of: &'static str) -> Self {
        self.add(count, of, true)
    }

    fn add(mut self, count: usize, of: &'static str, estimate: bool) -> Self {
        let count = count as u64;
        if count > 0 {
            self.saved.push(Saving {
                count,
                of,
                estimate,
            });
        }
        self
    }
}

impl fmt::Display for Saving {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.count as f64;
        let count = match self.count {
            0..1_000_000 => self.count.to_string(),
            1_000_000..1_000_000_000 => format!("{} million", significant(1e-6 * value, 4)),
            _ => format!("{} billion", significant(1e-9 * value, 4)),
        };
        let about = if self.estimate { "about " } else { "" };
        write!(f, "{about}{count} {}", self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn savings_say_how_much_and_whether_they_are_estimates() {
        let item = LeftOut::new("friction 0")
            .saving(0, "nothings")
            .saving(999_999, "friction updates")
            .saving_about(2_345_678, "unknowns");
        let said: Vec<String> = item.saved.iter().map(Saving::to_string).collect();
        assert_eq!(
            said,
            ["999999 friction updates", "about 2.346 million unknowns"]
        );
    }
}
