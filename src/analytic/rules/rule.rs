//! One record for all rules.

use super::verdict::{Judged, LoadError, RuleVerdict, Standing};
use crate::analytic::error::DomainError;
use serde::Serialize;

/// What a rule limits, so that it is clear of what a utilisation is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RuleMeasure {
    /// Load per length.
    LineLoad,
    /// Peak pressure, which grows with the root of the load.
    Pressure,
}

/// A limit, both as load per length and as Hertz's peak pressure under that load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Bound {
    /// Load per length.
    pub line_load: f64,
    /// Peak pressure p0.
    pub pressure: f64,
}

/// What a rule says of a roller.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// It applies.
    Holds(Bound),
    /// Something that it wants is not known, in words.
    Needs(String),
    /// The roller is outside of what it is for, in words.
    Refused(String),
}

/// Why there is no limit.
#[derive(Debug)]
pub(super) enum NoLimit {
    Needs(String),
    Refused(String),
}

impl From<DomainError> for NoLimit {
    fn from(error: DomainError) -> Self {
        Self::Refused(error.to_string())
    }
}

impl From<Result<Bound, NoLimit>> for Limit {
    fn from(found: Result<Bound, NoLimit>) -> Self {
        match found {
            Ok(bound) => Self::Holds(bound),
            Err(NoLimit::Needs(what)) => Self::Needs(what),
            Err(NoLimit::Refused(why)) => Self::Refused(why),
        }
    }
}

/// A rule and its limit for one roller.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Rule {
    /// What it is called.
    pub name: &'static str,
    /// Its formula, in one line.
    pub formula: &'static str,
    /// Where it is from.
    pub source: &'static str,
    /// What it is worth.
    pub standing: Standing,
    /// What its utilisation is of.
    pub measure: RuleMeasure,
    /// Its limit here.
    pub limit: Limit,
    /// What was taken for granted.
    pub notes: Vec<String>,
}

impl Rule {
    /// Its limit, where it applies.
    pub fn bound(&self) -> Option<Bound> {
        match &self.limit {
            Limit::Holds(bound) => Some(*bound),
            _ => None,
        }
    }

    /// What it says of a load per length; `None` where it does not apply.
    pub fn judge(&self, line_load: f64, error: LoadError) -> Option<Judged> {
        let bound = self.bound()?;
        let share = |load: f64| {
            let load = (load / bound.line_load).max(0.0);
            match self.measure {
                RuleMeasure::LineLoad => load,
                RuleMeasure::Pressure => load.sqrt(),
            }
        };
        let known = match error {
            LoadError::None => Some(0.0),
            LoadError::Within(error) => Some(error).filter(|error| error.is_finite()),
            LoadError::Unknown => None,
        };
        let span = known.map(|error| [line_load - error, line_load + error].map(share));
        let verdict = span.map(|[least, most]| RuleVerdict::of(self.standing, least, most));
        Some(Judged {
            line_load,
            pressure: bound.pressure * (line_load / bound.line_load).max(0.0).sqrt(),
            utilisation: share(line_load),
            error: span.map(|[least, most]| 0.5 * (most - least)),
            verdict: verdict.unwrap_or(RuleVerdict::Unresolved),
        })
    }
}
