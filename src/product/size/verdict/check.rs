//! One figure against its limit.

use super::standing::SizeStanding;
use serde::Serialize;

/// What is held against a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LimitKind {
    /// Hertz's p0 under the largest load per length of a line of contact, (2-49).
    ContactPressure,
    /// Largest elastic Mises stress of a part, against yield.
    ElasticMises,
    /// Largest plastic strain of a part, against none.
    PlasticStrain,
    /// Plastic strain beside a loaded edge of a contact surface.
    EdgePlasticStrain,
    /// Balance, penetration, friction: is the solution to be believed?
    Solution,
}

impl LimitKind {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::ContactPressure => "p0",
            Self::ElasticMises => "elastic Mises",
            Self::PlasticStrain => "plastic strain",
            Self::EdgePlasticStrain => "plastic strain at edges",
            Self::Solution => "solution",
        }
    }
}

/// One figure against its limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LimitCheck {
    pub kind: LimitKind,
    /// A body or an interface.
    #[serde(rename = "where")]
    pub place: String,
    /// Across, of a line of contact.
    pub across: Option<f64>,
    /// Largest load per length of a line of contact, and where along it.
    pub line_load: Option<f64>,
    pub along: Option<f64>,
    pub value: Option<f64>,
    /// Estimated, of the value, in its unit.
    pub error: Option<f64>,
    /// Is it a peak beside a loaded edge, which belongs to the mesh?
    pub at_edge: bool,
    pub limit: Option<f64>,
    pub utilisation: Option<f64>,
    pub standing: SizeStanding,
    pub remark: Option<String>,
}

impl LimitCheck {
    /// Of which nothing but its kind and place is known yet.
    pub fn bare(kind: LimitKind, place: &str) -> Self {
        Self {
            kind,
            place: place.to_string(),
            across: None,
            line_load: None,
            along: None,
            value: None,
            error: None,
            at_edge: false,
            limit: None,
            utilisation: None,
            standing: SizeStanding::NotJudged,
            remark: None,
        }
    }
}
