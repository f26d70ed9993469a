//! One steel table of a case file, and the steel that it gives.

use super::hardening::{HARDENING_KEYS, Hardening};
use crate::case::assumption::Assumption;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::grades::{Grade, GradeError, Grades};
use crate::case::keys;
use crate::case::parse::{Field, Table};
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
    ultimate_strength: Option<Located<f64>>,
    hardness: Option<Located<f64>>,
    surface_hardened: Option<Located<bool>>,
    /// Per kelvin.
    expansion: Option<Located<f64>>,
    /// The grade that has what the keys above do not say.
    grade: Option<Located<Grade>>,
    /// Of the product as delivered; a grade is the weaker the thicker it is.
    thickness: Option<Located<f64>>,
}

/// What a steel has beside its law: what design rules go by.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SteelStrength {
    /// In uniaxial tension, also of steel that is taken as elastic where it is known.
    pub yield_stress: Option<f64>,
    /// Ultimate strength.
    pub ultimate_strength: Option<f64>,
    /// Brinell hardness of the surface.
    pub hardness: Option<f64>,
    /// Is the surface harder than the core?
    pub surface_hardened: bool,
}

impl SteelTable {
    /// A table, or the name of a grade alone.
    pub fn read_field(
        field: &Field,
        grades: &Grades,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<Self, CaseError> {
        if !field.is_text() {
            let table = field.table()?.only(&keys::STEEL)?;
            return Self::read(&table, grades, assumptions);
        }
        Ok(Self {
            place: field.place(),
            youngs_modulus: None,
            poissons_ratio: None,
            yield_stress: None,
            hardening: None,
            elastic: None,
            ultimate_strength: None,
            hardness: None,
            surface_hardened: None,
            expansion: None,
            grade: Some(graded(field, grades)?),
            thickness: None,
        })
    }

    pub fn read(
        table: &Table,
        grades: &Grades,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<Self, CaseError> {
        let positive =
            |key: &str, dimension| table.maybe(key, |field| field.quantity(dimension)?.positive());
        let stress = |key| positive(key, Dimension::STRESS);
        let poisson = |field: &Field| {
            let why = "Poisson's ratio must lie between -1 and 0.5";
            field.ratio()?.require(|nu| *nu > -1.0 && *nu < 0.5, why)
        };
        let flag = |key| table.maybe(key, Field::boolean);
        let poissons_ratio = table.maybe("poissons_ratio", poisson)?;
        let entry = Self {
            place: table.place(),
            youngs_modulus: stress("youngs_modulus")?,
            poissons_ratio,
            yield_stress: stress("yield_stress")?,
            hardening: Hardening::read(table, assumptions)?,
            elastic: flag("elastic")?,
            ultimate_strength: stress("ultimate_strength")?,
            hardness: positive("hardness", Dimension::RATIO)?,
            surface_hardened: flag("surface_hardened")?,
            expansion: table.maybe("expansion", |field| field.quantity(Dimension::EXPANSION))?,
            grade: table.maybe("grade", |field| graded(field, grades))?,
            thickness: positive("thickness", Dimension::LENGTH)?,
        };
        entry.contradiction(table)?;
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

    /// Notes what is taken for granted; `default` completes a body's own table.
    pub fn note(&self, default: Option<&Self>, assumptions: &mut Vec<Assumption>) {
        if let Some(Located { value: grade, .. }) = &self.grade {
            let key = format!("{}.grade", self.place.key);
            let note = grade.note.iter().map(|note| format!("; {note}"));
            let why = format!("least values, {}{}", grade.source, note.collect::<String>());
            assumptions.push(Assumption::new(&key, &grade.name, &why, true));
        }
        let elastic = self.elastic.as_ref().is_some_and(|elastic| elastic.value);
        let of_grade = (self.grade.as_ref()).is_some_and(|grade| grade.value.yields());
        let yields = self.yield_stress.is_some() || (of_grade && !elastic);
        let hardens = |table: &Self| table.hardening.is_some();
        if yields && !hardens(self) && !default.is_some_and(hardens) {
            let key = format!("{}.hardening_modulus", self.place.key);
            let why = "no hardening is given: the stress stays at yield";
            assumptions.push(Assumption::default(&key, "0 (perfectly plastic)", why));
        }
    }

    /// Of a product this thick where the table does not say, with what the grade has in place of keys that are not
    /// there.
    pub fn graded(self, size: Option<f64>, units: UnitSystem) -> Result<Self, CaseError> {
        let Some(Located {
            value: grade,
            place,
        }) = &self.grade
        else {
            return Ok(self);
        };
        let thickness = self.thickness.as_ref().map(|t| t.value).or(size);
        let steel = match grade.in_units(units, thickness) {
            Ok(steel) => steel,
            Err(error) => {
                let place = match (&error, &self.thickness) {
                    (GradeError::TooThick { .. }, Some(thickness)) => &thickness.place,
                    _ => place,
                };
                return Err(refused(place, &error));
            }
        };
        let own = |value: Option<f64>| {
            let place = place.clone();
            value.map(|value| Located { value, place })
        };
        Ok(Self {
            youngs_modulus: self.youngs_modulus.or(own(Some(steel.youngs_modulus))),
            poissons_ratio: self.poissons_ratio.or(own(Some(steel.poissons_ratio))),
            yield_stress: self.yield_stress.or(own(steel.yield_stress)),
            ultimate_strength: self.ultimate_strength.or(own(steel.ultimate_strength)),
            hardness: self.hardness.or(own(steel.hardness)),
            ..self
        })
    }

    /// These keys, and those of `default` that are not among them.
    pub fn over(self, default: &Self) -> Self {
        let plastic = self.yield_stress.is_some() || self.hardening.is_some();
        let default = default.clone();
        // Strengths belong together: those of another steel do not complete these.
        let same = self.yield_stress.is_none() && self.grade.is_none();
        Self {
            youngs_modulus: self.youngs_modulus.or(default.youngs_modulus),
            poissons_ratio: self.poissons_ratio.or(default.poissons_ratio),
            yield_stress: self.yield_stress.or(default.yield_stress),
            hardening: self.hardening.or(default.hardening),
            // A body with a yield stress of its own is plastic though the default is elastic.
            elastic: self.elastic.or(default.elastic.filter(|_| !plastic)),
            ultimate_strength: self
                .ultimate_strength
                .or(default.ultimate_strength.filter(|_| same)),
            hardness: self.hardness.or(default.hardness.filter(|_| same)),
            surface_hardened: self
                .surface_hardened
                .or(default.surface_hardened.filter(|_| same)),
            expansion: self.expansion.or(default.expansion),
            grade: self.grade.or(default.grade),
            thickness: self.thickness.or(default.thickness),
            place: self.place,
        }
    }

    /// What design rules go by.
    pub fn strength(&self) -> SteelStrength {
        let value = |located: &Option<Located<f64>>| located.as_ref().map(|l| l.value);
        SteelStrength {
            yield_stress: value(&self.yield_stress),
            ultimate_strength: value(&self.ultimate_strength),
            hardness: value(&self.hardness),
            surface_hardened: self.surface_hardened.as_ref().is_some_and(|h| h.value),
        }
    }

    /// Its coefficient of thermal expansion, where it says one.
    pub fn expansion(&self) -> Option<f64> {
        self.expansion.as_ref().map(|e| e.value)
    }

    /// Does it name a grade?
    pub fn has_grade(&self) -> bool {
        self.grade.is_some()
    }

    /// Does it say all that a steel needs?
    pub fn is_whole(&self) -> bool {
        let elastic = self.elastic.as_ref().is_some_and(|elastic| elastic.value);
        let constants = self.youngs_modulus.is_some() && self.poissons_ratio.is_some();
        constants && (elastic || self.yield_stress.is_some())
    }

    /// The thickness that it says.
    pub fn thickness(&self) -> Option<&Located<f64>> {
        self.thickness.as_ref()
    }

    /// Of that thickness.
    pub fn with_thickness(self, thickness: Option<Located<f64>>) -> Self {
        Self { thickness, ..self }
    }

    /// The grade, where its strength depends on a thickness that the table does not say.
    pub fn grade_without_thickness(&self) -> Option<&Grade> {
        let grade = &self.grade.as_ref()?.value;
        (grade.is_by_thickness() && self.thickness.is_none()).then_some(grade)
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
                let modulus =
                    hardening.map(|h| h.modulus(body, [youngs_modulus, stress.value], units));
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

/// The grade that `field` names.
fn graded(field: &Field, grades: &Grades) -> Result<Located<Grade>, CaseError> {
    let name = field.string()?;
    let grade = grades.find(&name.value).cloned();
    let grade = grade.map_err(|error| refused(&name.place, &error))?;
    Ok(name.map(|_| grade))
}

fn refused(place: &KeyPlace, error: &GradeError) -> CaseError {
    let kind = match error {
        GradeError::Unknown { .. } => ErrorKind::UnknownName,
        GradeError::NoThickness { .. } => ErrorKind::MissingKey,
        GradeError::TooThick { .. } | GradeError::Quantity { .. } => ErrorKind::Value,
    };
    let report = place.error(kind, error.to_string());
    match miette::Diagnostic::help(error) {
        Some(help) => report.help(help.to_string()),
        None => report,
    }
}
