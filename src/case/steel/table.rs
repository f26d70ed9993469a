//! One steel table of a case file, and the steel that it gives.

use super::hardening::{HARDENING_KEYS, Hardening};
use crate::case::assumption::Assumption;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::parse::Table;
use crate::case::place::{KeyPlace, Located};
use crate::ground::units::{Dimension, UnitSystem};
use crate::model::material::Steel;

/// The keys of one steel table, not yet a whole steel: a body's own table adds to the default.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SteelTable {
    place: KeyPlace,
    youngs_modulus: Option<Located<f64>>,
    poissons_ratio: Option<Located<f64>>,
    yield_stress: Option<Located<f64>>,
    hardening: Option<Hardening>,
    elastic: Option<Located<bool>>,
}

impl SteelTable {
    pub fn read(table: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
        let stress = |key: &str| {
            table
                .get(key)
                .map(|field| field.quantity(Dimension::STRESS))
                .transpose()
        };
        let positive = |key: &str| stress(key)?.map(Located::positive).transpose();
        let poisson = |nu: Located<f64>| {
            nu.require(
                |nu| *nu > -1.0 && *nu < 0.5,
                "Poisson's ratio must lie between -1 and 0.5",
            )
        };
        let nu = table
            .get("poissons_ratio")
            .map(|field| field.ratio())
            .transpose()?;
        let entry = Self {
            place: table.place(),
            youngs_modulus: positive("youngs_modulus")?,
            poissons_ratio: nu.map(poisson).transpose()?,
            yield_stress: positive("yield_stress")?,
            hardening: Hardening::read(table, assumptions)?,
            elastic: table
                .get("elastic")
                .map(|field| field.boolean())
                .transpose()?,
        };
        entry.contradiction(table)?;
        entry.note_perfect_plasticity(assumptions);
        Ok(entry)
    }

    /// An elastic steel has no yield stress.
    fn contradiction(&self, table: &Table) -> Result<(), CaseError> {
        let plastic = ["yield_stress"]
            .iter()
            .chain(HARDENING_KEYS)
            .find_map(|key| table.get(key));
        match (&self.elastic, plastic) {
            (Some(elastic), Some(field)) if elastic.value => {
                let why = format!("contradicts `{} = true`", elastic.place.key);
                Err(field
                    .place()
                    .error(ErrorKind::Conflict, why)
                    .help("drop one of the two"))
            }
            _ => Ok(()),
        }
    }

    fn note_perfect_plasticity(&self, assumptions: &mut Vec<Assumption>) {
        if self.yield_stress.is_some() && self.hardening.is_none() {
            let key = format!("{}.hardening_modulus", self.place.key);
            let why = "no hardening is given: the stress stays at yield";
            assumptions.push(Assumption::default(&key, "0 (perfectly plastic)", why));
        }
    }

    /// These keys, and those of `default` that are not among them.
    pub fn over(self, default: &Self) -> Self {
        let plastic = self.yield_stress.is_some() || self.hardening.is_some();
        let default = default.clone();
        Self {
            youngs_modulus: self.youngs_modulus.or(default.youngs_modulus),
            poissons_ratio: self.poissons_ratio.or(default.poissons_ratio),
            yield_stress: self.yield_stress.or(default.yield_stress),
            hardening: self.hardening.or(default.hardening),
            // A body with a yield stress of its own is plastic though the default is elastic.
            elastic: self.elastic.or(default.elastic.filter(|_| !plastic)),
            place: self.place,
        }
    }

    pub fn steel(self, body: &str, units: UnitSystem) -> Result<Steel, CaseError> {
        let missing = |key: &str| {
            let why = format!("the steel of `{body}` needs `{key}`");
            self.place.error(ErrorKind::MissingKey, why)
        };
        let youngs_modulus = self
            .youngs_modulus
            .as_ref()
            .ok_or_else(|| missing("youngs_modulus"))?
            .value;
        let poissons_ratio = self
            .poissons_ratio
            .as_ref()
            .ok_or_else(|| missing("poissons_ratio"))?
            .value;
        let elastic = self.elastic.as_ref().is_some_and(|elastic| elastic.value);
        let (yield_stress, hardening_modulus) = match &self.yield_stress {
            _ if elastic => (f64::INFINITY, 0.0),
            None => return Err(missing("yield_stress` or `elastic = true")),
            Some(stress) => {
                let hardening = self.hardening.as_ref();
                let modulus = hardening.map(|h| h.modulus(youngs_modulus, stress.value, units));
                (stress.value, modulus.transpose()?.unwrap_or(0.0))
            }
        };
        Ok(Steel {
            youngs_modulus,
            poissons_ratio,
            yield_stress,
            hardening_modulus,
        })
    }
}
