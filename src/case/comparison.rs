//! `[comparison]`: printed values to set beside the results. They never decide a run.

use serde::Serialize;

use super::assumption::Assumption;
use super::error::CaseError;
use super::keys;
use super::parse::{Field, Table};
use super::place::Located;
use crate::ground::units::Dimension;

/// Which of the three Mises values stands beside the printed one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Default)]
#[serde(rename_all = "snake_case")]
pub enum MisesRead {
    /// Mises of the mean stress of an element.
    #[default]
    Centroid,
    /// At the integration points of elements.
    IntegrationPoint,
    /// Averaged at nodes.
    Nodal,
}

/// What a printed value measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ComparedMeasure {
    /// Largest Mises stress of a body, of the `rollers`, the `plates`, or `overall`.
    Mises,
    /// Largest contact pressure of an interface, or `overall`.
    MaxPressure,
    /// Motion of the top face since all interfaces just touched.
    Descent,
}

/// One printed value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Printed {
    /// The quantity.
    pub what: ComparedMeasure,
    /// A body, an interface, `rollers`, `plates` or `overall`.
    pub place: String,
    /// In the units of the case.
    pub value: f64,
}

/// The printed values of a case.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct PrintedValues {
    /// Where they were printed.
    pub source: Option<String>,
    /// Where Mises stresses are read.
    pub mises_read: MisesRead,
    /// The printed values.
    pub values: Vec<Printed>,
    /// The places again, where they stand in the case file.
    #[serde(skip)]
    places: Vec<(ComparedMeasure, Located<String>)>,
}

impl PrintedValues {
    pub(super) fn read(
        root: &Table,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<Option<Self>, CaseError> {
        let Some(field) = root.get("comparison") else {
            return Ok(None);
        };
        let table = field.table()?.only(&keys::COMPARISON)?;
        let choices = [
            ("centroid", MisesRead::Centroid),
            ("integration_point", MisesRead::IntegrationPoint),
            ("nodal", MisesRead::Nodal),
        ];
        let read = table.maybe("mises_read", |field| field.choice(&choices))?;
        let mises_read = read.as_ref().map(|r| r.value).unwrap_or_default();
        let word = choices
            .iter()
            .find(|(_, read)| *read == mises_read)
            .map_or("", |c| c.0);
        let why = "where the printed Mises stress was read is not said; all three readings are \
                   printed, this one is set beside it";
        assumptions.push(Assumption::new(
            "comparison.mises_read",
            word,
            why,
            read.is_some(),
        ));

        let (mut values, mut named) = (Vec::new(), Vec::new());
        for (key, what) in [
            ("mises", ComparedMeasure::Mises),
            ("max_pressure", ComparedMeasure::MaxPressure),
        ] {
            let Some(field) = table.get(key) else {
                continue;
            };
            let places = field.table()?;
            for place in places.keys() {
                let value = places
                    .need(place)?
                    .quantity(Dimension::STRESS)?
                    .positive()?
                    .value;
                values.push(Printed {
                    what,
                    place: place.to_string(),
                    value,
                });
                let named_at = Located {
                    value: place.to_string(),
                    place: places.place_of_key(place),
                };
                named.push((what, named_at));
            }
        }
        if let Some(field) = table.get("descent") {
            let value = field.quantity(Dimension::LENGTH)?.value;
            values.push(Printed {
                what: ComparedMeasure::Descent,
                place: "overall".to_string(),
                value,
            });
        }
        let source = table.maybe("source", Field::string)?;
        Ok(Some(Self {
            source: source.map(|s| s.value),
            mises_read,
            values,
            places: named,
        }))
    }

    /// Refuses places that have no such value: stresses are of bodies, pressures of interfaces.
    pub(super) fn check_places(&self, bodies: &[&str], pairs: &[&str]) -> Result<(), CaseError> {
        let stressed = [&["overall", "rollers", "plates"], bodies].concat();
        let pressed = [&["overall"], pairs].concat();
        for (what, place) in &self.places {
            let (known, kind) = match what {
                ComparedMeasure::MaxPressure => (&pressed, "an interface"),
                _ => (&stressed, "a body"),
            };
            if !known.contains(&place.value.as_str()) {
                let why = format!("is not {kind} of the case");
                let known = known.iter().copied();
                return Err(place.place.unknown(why, &place.value, known));
            }
        }
        Ok(())
    }
}
