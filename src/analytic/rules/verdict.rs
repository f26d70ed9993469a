//! What a rule says of a load.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::fmt;

/// What a rule is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    /// A rule whose text was read.
    Rule,
    /// A rule of a standard that was not read: formula and factors are from books and papers about it.
    Indicative,
    /// No rule, but where the steel begins to do something.
    Threshold,
}

/// A verdict. That of an indicative rule never reads as if a standard were met.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RuleVerdict {
    /// Within the limit.
    Met,
    /// Beyond it.
    NotMet,
    /// Within, of a standard that was not read.
    IndicativeWithin,
    /// Beyond, of a standard that was not read.
    IndicativeExceeded,
    /// Below the threshold.
    Below,
    /// Beyond the threshold.
    Beyond,
    /// The error of the load leaves it open.
    Open,
    /// Nothing is known of the error of the load.
    Unresolved,
}

/// How well a load per length is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LoadError {
    /// It is given.
    None,
    /// To within this much, in its unit.
    Within(f64),
    /// Not at all.
    Unknown,
}

impl RuleVerdict {
    const ALL: [Self; 8] = [
        Self::Met,
        Self::NotMet,
        Self::IndicativeWithin,
        Self::IndicativeExceeded,
        Self::Below,
        Self::Beyond,
        Self::Open,
        Self::Unresolved,
    ];

    /// Of a utilisation that lies between `least` and `most`.
    pub fn of(standing: Standing, least: f64, most: f64) -> Self {
        let within = match (most <= 1.0, least > 1.0) {
            (true, _) => true,
            (_, true) => false,
            _ => return Self::Open,
        };
        match (standing, within) {
            (Standing::Rule, true) => Self::Met,
            (Standing::Rule, false) => Self::NotMet,
            (Standing::Indicative, true) => Self::IndicativeWithin,
            (Standing::Indicative, false) => Self::IndicativeExceeded,
            (Standing::Threshold, true) => Self::Below,
            (Standing::Threshold, false) => Self::Beyond,
        }
    }

    /// Is the limit kept, as far as that is known?
    pub fn is_within(self) -> Option<bool> {
        match self {
            Self::Met | Self::IndicativeWithin | Self::Below => Some(true),
            Self::NotMet | Self::IndicativeExceeded | Self::Beyond => Some(false),
            Self::Open | Self::Unresolved => None,
        }
    }
}

impl fmt::Display for RuleVerdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Met => "met",
            Self::NotMet => "NOT met",
            Self::IndicativeWithin => "indicative: within",
            Self::IndicativeExceeded => "indicative: exceeded",
            Self::Below => "below",
            Self::Beyond => "beyond",
            Self::Open => "open: within the error",
            Self::Unresolved => "open: load not resolved",
        })
    }
}

impl Serialize for RuleVerdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl JsonSchema for RuleVerdict {
    fn schema_name() -> Cow<'static, str> {
        "RuleVerdict".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "description": "What a rule says of a load.", "enum": Self::ALL.map(|v| v.to_string()) })
    }
}

/// A rule applied to a load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Judged {
    /// Load per length.
    pub line_load: f64,
    /// Hertz's peak pressure under it.
    pub pressure: f64,
    /// Load over limit, or pressure over limit, as the rule measures.
    pub utilisation: f64,
    /// What the utilisation may be off by, as the load may; `None` where nothing is known of it.
    pub error: Option<f64>,
    /// What the rule says.
    pub verdict: RuleVerdict,
}
