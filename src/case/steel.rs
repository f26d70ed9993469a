//! The steels of a case: a default for all bodies, and what single bodies have otherwise.

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::nearest::advice;
use super::parse::{Field, Table};
use super::source::{Located, Place};
use crate::ground::units::{Dimension, UnitSystem};
use crate::model::material::Steel;

/// Ways to give the hardening line, of which a steel has one.
const HARDENINGS: &[&str] = &["hardening", "hardening_modulus", "tangent_modulus"];

/// What the strain of the second point of the hardening line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrainIs {
    /// Elastic and plastic strain together.
    Total,
    /// Plastic strain alone.
    Plastic,
}

/// The straight line beyond yield, as it was given.
#[derive(Debug, Clone, PartialEq)]
enum Hardening {
    /// From yield through a second point of uniaxial tension.
    Point {
        stress: Located<f64>,
        strain: Located<f64>,
        strain_is: StrainIs,
    },
    /// H = dσ/dε_p.
    Modulus(Located<f64>),
    /// E_t = dσ/dε.
    Tangent(Located<f64>),
}

/// The keys of one steel table, not yet a whole steel: a body's own table adds to the default.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    place: Place,
    youngs_modulus: Option<Located<f64>>,
    poissons_ratio: Option<Located<f64>>,
    yield_stress: Option<Located<f64>>,
    hardening: Option<Hardening>,
    elastic: Option<Located<bool>>,
}

/// The steels of all bodies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Steels {
    default: Option<Entry>,
    bodies: Vec<(Located<String>, Entry)>,
    units: Option<UnitSystem>,
}

impl Steels {
    /// Reads `[steel]` and its tables `[steel.<body>]`.
    pub(super) fn read(root: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
        let mut steels = Self {
            units: Some(root.units()),
            ..Self::default()
        };
        let Some(field) = root.get("steel") else {
            return Ok(steels);
        };
        let table = field.table()?.only_or_tables(&keys::STEEL)?;
        let own = keys::STEEL.names();
        let is_body = |key: &&str| !own.contains(key);
        if table.keys().iter().any(|key| own.contains(key)) {
            steels.default = Some(Entry::read(&table, assumptions)?);
        }
        for body in table.keys().into_iter().filter(is_body) {
            let entry = Entry::read(&table.need(body)?.table()?.only(&keys::STEEL)?, assumptions)?;
            let place = table.place_of_key(body);
            steels.bodies.push((
                Located {
                    value: body.to_string(),
                    place,
                },
                entry,
            ));
        }
        Ok(steels)
    }

    /// Adds the steel that stands in the `[[body]]` entry of `body`.
    pub(super) fn add(
        &mut self,
        body: &Located<String>,
        field: &Field,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<(), CaseError> {
        if self.bodies.iter().any(|(name, _)| name.value == body.value) {
            let why = format!("two steels for the body `{}`", body.value);
            let help = format!(
                "keep either `[steel.{0}]` or the steel of its `[[body]]`",
                body.value
            );
            return Err(body.place.error(ErrorKind::Conflict, why).help(help));
        }
        let entry = Entry::read(&field.table()?.only(&keys::STEEL)?, assumptions)?;
        self.bodies.push((body.clone(), entry));
        Ok(())
    }

    /// Refuses steels of bodies that do not exist.
    pub fn check_names(&self, bodies: &[&str]) -> Result<(), CaseError> {
        match self
            .bodies
            .iter()
            .find(|(name, _)| !bodies.contains(&name.value.as_str()))
        {
            None => Ok(()),
            Some((name, _)) => {
                let why = format!("there is no body called `{}`", name.value);
                let help = advice(&name.value, bodies.iter().copied());
                Err(name.place.error(ErrorKind::UnknownName, why).help(help))
            }
        }
    }

    /// The steel of `body`, in the units of the case.
    pub fn of(&self, body: &str) -> Result<Steel, CaseError> {
        let own = self
            .bodies
            .iter()
            .find(|(name, _)| name.value == body)
            .map(|(_, entry)| entry);
        let nothing = || {
            let message = format!("the body `{body}` has no steel");
            let help = format!("give `[steel]` for all bodies, or `[steel.{body}]`");
            CaseError::new(ErrorKind::MissingKey, message).help(help)
        };
        let entry = match (own, &self.default) {
            (Some(own), Some(default)) => own.clone().over(default),
            (Some(only), None) | (None, Some(only)) => only.clone(),
            (None, None) => return Err(nothing()),
        };
        entry.steel(body, self.units.unwrap_or(UnitSystem::MNPa))
    }
}

impl Entry {
    fn read(table: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
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
            .chain(HARDENINGS)
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
    fn over(self, default: &Self) -> Self {
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

    fn steel(self, body: &str, units: UnitSystem) -> Result<Steel, CaseError> {
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

impl Hardening {
    fn read(table: &Table, assumptions: &mut Vec<Assumption>) -> Result<Option<Self>, CaseError> {
        let given: Vec<Field> = HARDENINGS.iter().filter_map(|key| table.get(key)).collect();
        if let [first, second, ..] = given.as_slice() {
            let why = format!("the hardening is given already by `{}`", first.place().key);
            let help = "keep one of hardening, hardening_modulus, tangent_modulus";
            return Err(second.place().error(ErrorKind::Conflict, why).help(help));
        }
        if let Some(field) = table.get("hardening_modulus") {
            let modulus = field.quantity(Dimension::STRESS)?.not_negative()?;
            return Ok(Some(Self::Modulus(modulus)));
        }
        if let Some(field) = table.get("tangent_modulus") {
            let modulus = field.quantity(Dimension::STRESS)?.not_negative()?;
            return Ok(Some(Self::Tangent(modulus)));
        }
        table
            .get("hardening")
            .map(|field| Self::point(&field.table()?, assumptions))
            .transpose()
    }

    fn point(table: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
        let table = table.clone().only(&keys::HARDENING)?;
        let stress = table
            .need("stress")?
            .quantity(Dimension::STRESS)?
            .positive()?;
        let strain = table.need("strain")?.ratio()?.positive()?;
        let choices = [("total", StrainIs::Total), ("plastic", StrainIs::Plastic)];
        let given = table
            .get("strain_is")
            .map(|field| field.choice(&choices))
            .transpose()?;
        let strain_is = given
            .as_ref()
            .map_or(StrainIs::Total, |located| located.value);
        let word = if strain_is == StrainIs::Total {
            "total"
        } else {
            "plastic"
        };
        let key = format!("{}.strain_is", table.place().key);
        let why = "the strain of the second hardening point is the total strain unless said \
                   otherwise; as plastic strain the hardening modulus differs";
        assumptions.push(Assumption::new(&key, word, why, given.is_some()));
        Ok(Self::Point {
            stress,
            strain,
            strain_is,
        })
    }

    /// H of a steel of Young's modulus `e` and yield stress `yields`.
    fn modulus(&self, e: f64, yields: f64, units: UnitSystem) -> Result<f64, CaseError> {
        let show = |stress: f64| units.show(stress, Dimension::STRESS);
        match self {
            Self::Modulus(modulus) => Ok(modulus.value),
            Self::Tangent(modulus) if modulus.value < e => Ok(series(e, modulus.value)),
            Self::Tangent(modulus) => {
                let why = format!("must be less than Young's modulus, {}", show(e));
                Err(modulus.place.error(ErrorKind::Value, why))
            }
            Self::Point {
                stress,
                strain,
                strain_is,
            } => {
                if stress.value <= yields {
                    let why = format!("lies below the yield stress, {}", show(yields));
                    let help = "the second point of the hardening line lies beyond yield";
                    return Err(stress.place.error(ErrorKind::Value, why).help(help));
                }
                let rise = stress.value - yields;
                let plastic = match strain_is {
                    StrainIs::Plastic => return Ok(rise / strain.value),
                    StrainIs::Total => strain.value - stress.value / e,
                };
                if plastic <= 0.0 {
                    let why = format!(
                        "is no more than the elastic strain at that stress, {:.6}",
                        stress.value / e
                    );
                    return Err(strain.place.error(ErrorKind::Value, why));
                }
                Ok(rise / plastic)
            }
        }
    }
}

/// H from the tangent modulus E_t: 1/E_t = 1/E + 1/H.
fn series(e: f64, tangent: f64) -> f64 {
    e * tangent / (e - tangent)
}
