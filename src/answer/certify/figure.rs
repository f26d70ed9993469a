//! A figure and what it is worth.

use crate::ground::units::Measure;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// A figure and what it is worth.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Such as "peak Mises".
    pub what: Quantity,
    /// Body or interface; "overall" for the scene.
    pub place: String,
    /// In the unit of the scene.
    pub value: f64,
    /// By cause.
    pub error: Errors,
    /// Why the figure or its error should be read with care.
    pub note: Option<&'static str>,
    /// Does it lie beside a loaded edge? The mesh decides it more than any other.
    pub at_edge: bool,
}

impl Figure {
    /// What the figure may be off by, in its unit; `None` where nothing can be said.
    pub fn bar(&self) -> Option<f64> {
        self.error.total().filter(|error| error.is_finite())
    }

    /// The same, of the figure; `None` of zero, too.
    pub fn relative_bar(&self) -> Option<f64> {
        let share = self.bar()? / self.value.abs();
        share.is_finite().then_some(share)
    }

    /// Says that the mesh does not resolve it, and why.
    pub(super) fn leave_open(&mut self, why: &'static str) {
        self.error.discretisation = None;
        self.note = Some(why);
    }

    /// Is its error known?
    pub fn is_resolved(&self) -> bool {
        self.bar().is_some()
    }
}

/// A figure as `summary.json` has it.
#[derive(Serialize, JsonSchema)]
struct Record<'a> {
    /// The quantity.
    what: Quantity,
    /// Body, interface or surface; "overall" for the scene.
    #[serde(rename = "where")]
    place: &'a str,
    /// In the unit of the case.
    value: f64,
    /// The absolute error, in the unit of `value`; null where nothing is known.
    error: Option<f64>,
    /// The same over the size of `value`, a bare number; null where nothing is known, and of zero.
    relative_error: Option<f64>,
    /// Is the error known?
    resolved: bool,
    /// Why the figure or its error should be read with care.
    note: Option<&'a str>,
    /// Absolute errors by cause, in the unit of `value`.
    causes: Errors,
}

impl Serialize for Figure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let record = Record {
            what: self.what,
            place: &self.place,
            value: self.value,
            error: self.bar(),
            relative_error: self.relative_bar(),
            resolved: self.is_resolved(),
            note: self.note,
            causes: self.error,
        };
        record.serialize(serializer)
    }
}

impl JsonSchema for Figure {
    fn schema_name() -> Cow<'static, str> {
        "Figure".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Record::json_schema(generator)
    }
}

/// Does another stand in the place of a claim? Beside a peak at a loaded edge, which has no limit or one that the mesh does not
/// show, stands the one away from such edges.
pub fn is_replaced(claims: &[Figure], claim: &Figure) -> bool {
    let away = || figure(claims, claim.what.away_from_edges()?, &claim.place);
    !claim.is_resolved() && away().is_some()
}

/// The figures of which nothing can be said, and that nothing is said in place of.
pub fn unresolved(claims: &[Figure]) -> Vec<&Figure> {
    let unsure = claims.iter().filter(|c| !c.is_resolved());
    unsure.filter(|c| !is_replaced(claims, c)).collect()
}

/// The claim of `what` at `place`.
pub fn figure<'f>(figures: &'f [Figure], what: Quantity, place: &str) -> Option<&'f Figure> {
    figures.iter().find(|c| c.what == what && c.place == place)
}

/// What a claim is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Travel of what loads the scene, along the load.
    Descent,
    /// Largest nodal Mises stress of a body; below a strip that the mesh resolves, less what extrapolation overshoots by.
    PeakMises,
    /// Where that lies at a loaded edge: the largest away from such edges.
    MisesAway,
    /// The same two of the elastic solution, where the body has yielded.
    ElasticPeakMises,
    /// Away from loaded edges.
    ElasticMisesAway,
    /// Largest equivalent plastic strain at an integration point.
    PeakPlasticStrain,
    /// Largest consistent nodal pressure.
    PeakPressure,
    /// Where that is at a loaded edge, or where a fillet that the mesh does not resolve may hide a higher one: the largest
    /// away from there.
    PressureAway,
    /// Hertz's pressure under the largest load per length.
    HertzPressure,
    /// Largest load per length, normal to the surface.
    LineLoad,
    /// Where that is at a fillet that the mesh does not resolve: the largest away from there.
    LineLoadAway,
    /// Half-width of the strip, or of the most heavily loaded line of contact.
    HalfWidth,
    /// Area of a contact, of the whole.
    ContactArea,
    /// Length in contact of the most heavily loaded line.
    ContactLength,
    /// How far from the middle of the carrier the force of a contact acts, along its lines.
    Eccentricity,
    /// Mises stress on the inner wall below the load.
    BoreMises,
    /// Force of an interface across the load.
    HorizontalForce,
    /// Depth of a dent that stays.
    Dent,
}

/// Estimated errors of a figure, in its unit and without sign; `None` where nothing is known.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Errors {
    /// Of the mesh.
    pub discretisation: Option<f64>,
    /// Beyond that, where a peak lies next to what belongs to a loaded edge: elements along the line of contact decide it.
    /// `None` elsewhere.
    pub beside_edge: Option<f64>,
    /// Of the penetration that is left.
    pub penetration: Option<f64>,
    /// Of the size of the increments in plastic flow, what friction remembers meanwhile included: zero
    /// where nothing depends on the path. `None` where no second solution tells, which a note says.
    pub increment: Option<f64>,
}

impl Errors {
    /// Of the mesh alone.
    pub(super) fn only_of_mesh(discretisation: Option<f64>) -> Self {
        Self {
            discretisation,
            ..Self::default()
        }
    }

    /// Their sum, as far as they are known; `None` where the error of the mesh is not.
    pub fn total(&self) -> Option<f64> {
        let rest = self.penetration.unwrap_or(0.0) + self.increment.unwrap_or(0.0);
        self.of_mesh().map(|mesh| mesh + rest)
    }

    /// What the mesh does; `None` where nothing is known of it.
    pub fn of_mesh(&self) -> Option<f64> {
        let beside_edge = self.beside_edge.unwrap_or(0.0);
        self.discretisation.map(|mesh| mesh + beside_edge)
    }
}

impl Quantity {
    /// Of a figure that may be at a loaded edge, the one away from such edges.
    pub fn away_from_edges(self) -> Option<Self> {
        match self {
            Self::PeakMises => Some(Self::MisesAway),
            Self::ElasticPeakMises => Some(Self::ElasticMisesAway),
            Self::PeakPressure => Some(Self::PressureAway),
            Self::LineLoad => Some(Self::LineLoadAway),
            _ => None,
        }
    }

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Descent => "descent",
            Self::PeakMises => "peak Mises",
            Self::MisesAway => "Mises away from edges",
            Self::ElasticPeakMises => "peak Mises, elastic",
            Self::ElasticMisesAway => "Mises away from edges, elastic",
            Self::PeakPlasticStrain => "peak plastic strain",
            Self::PeakPressure => "peak pressure",
            Self::PressureAway => "pressure away from edges",
            Self::HertzPressure => "Hertz's p0 of the line load",
            Self::LineLoad => "largest line load",
            Self::LineLoadAway => "line load away from edges",
            Self::HalfWidth => "half-width",
            Self::ContactArea => "contact area",
            Self::ContactLength => "length in contact",
            Self::Eccentricity => "eccentricity",
            Self::BoreMises => "bore Mises",
            Self::HorizontalForce => "horizontal force",
            Self::Dent => "dent",
        }
    }

    /// What it is measured in.
    pub fn measure(self) -> Measure {
        match self {
            Self::Descent
            | Self::HalfWidth
            | Self::ContactLength
            | Self::Eccentricity
            | Self::Dent => Measure::Length,
            Self::PeakMises
            | Self::MisesAway
            | Self::ElasticPeakMises
            | Self::ElasticMisesAway
            | Self::PeakPressure
            | Self::PressureAway
            | Self::HertzPressure
            | Self::BoreMises => Measure::Stress,
            Self::LineLoad | Self::LineLoadAway => Measure::LineLoad,
            Self::ContactArea => Measure::Area,
            Self::HorizontalForce => Measure::Force,
            Self::PeakPlasticStrain => Measure::Ratio,
        }
    }
}

/// A claim of which nothing is known yet.
pub(super) fn figure_of(what: Quantity, place: &str, value: f64) -> Figure {
    Figure {
        what,
        place: place.to_owned(),
        value,
        error: Errors::default(),
        note: None,
        at_edge: false,
    }
}
