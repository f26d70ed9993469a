//! The steels of a case: a default for all bodies, and what single bodies have otherwise.

mod hardening;
mod table;

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::grades::Grades;
use super::keys;
use super::parse::{Field, Table};
use super::place::Located;
use crate::ground::units::Dimension;
use crate::ground::units::UnitSystem;
use crate::model::material::Steel;
pub use hardening::StrainIs;
use std::path::Path;
pub use table::SteelStrength;
use table::SteelTable;

/// The steels of all bodies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Steels {
    default: Option<SteelTable>,
    bodies: Vec<(Located<String>, SteelTable)>,
    units: Option<UnitSystem>,
    /// Thickness or diameter of bodies, for grades whose tables do not say it.
    sizes: Vec<(String, f64)>,
}

impl Steels {
    /// Reads `[steel]` and its tables `[steel.<body>]`.
    pub(super) fn read(root: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
        let mut steels = Self {
            units: Some(root.units()),
            ..Self::default()
        };
        let grades = known_grades(root)?;
        let Some(field) = root.get("steel") else {
            return Ok(steels);
        };
        if field.is_text() {
            let entry = SteelTable::read_field(&field, &grades, assumptions)?;
            entry.note(None, assumptions);
            steels.default = Some(entry);
            return Ok(steels);
        }
        let table = field.table()?.only_or_tables(&keys::STEEL)?;
        let own = keys::STEEL.names();
        let is_body = |key: &&str| !own.contains(key);
        if table.keys().iter().any(|key| own.contains(key)) {
            let entry = SteelTable::read(&table, &grades, assumptions)?;
            entry.note(None, assumptions);
            steels.default = Some(entry);
        }
        for body in table.keys().into_iter().filter(is_body) {
            let own = table.need(body)?.table()?.only(&keys::STEEL)?;
            let entry = SteelTable::read(&own, &grades, assumptions)?;
            entry.note(steels.default.as_ref(), assumptions);
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
        (root, field): (&Table, &Field),
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
        let entry = SteelTable::read_field(field, &known_grades(root)?, assumptions)?;
        entry.note(self.default.as_ref(), assumptions);
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
                Err((name.place).unknown(why, &name.value, bodies.iter().copied()))
            }
        }
    }

    /// Tells the thickness or diameter of the bodies, for grades whose tables do not say it, and notes where that
    /// decides.
    pub(super) fn set_sizes(&mut self, sizes: &[(&str, f64)], assumptions: &mut Vec<Assumption>) {
        self.sizes = (sizes.iter())
            .map(|(body, size)| (body.to_string(), *size))
            .collect();
        let units = self.units.unwrap_or(UnitSystem::MNPa);
        let mut told: Vec<(String, Vec<String>)> = Vec::new();
        for (body, size) in sizes {
            let tables = self.tables(body);
            let graded = tables.iter().flatten().find(|table| table.has_grade());
            let Some(grade) = graded.and_then(SteelTable::grade_without_thickness) else {
                continue;
            };
            let taken = format!("{body} {}", units.show(*size, Dimension::LENGTH));
            match told.iter_mut().find(|(name, _)| *name == grade.name) {
                Some((_, bodies)) => bodies.push(taken),
                None => told.push((grade.name.clone(), vec![taken])),
            }
        }
        for (grade, bodies) in told {
            let why = format!("the strength of {grade} goes by the thickness as delivered");
            let bodies = bodies.join(", ");
            assumptions.push(Assumption::default("steel.thickness", bodies, &why));
        }
    }

    /// The steel of `body`, in the units of the case.
    pub fn of(&self, body: &str) -> Result<Steel, CaseError> {
        let units = self.units.unwrap_or(UnitSystem::MNPa);
        self.entry(body)?.steel(body, units)
    }

    /// What design rules go by, of `body`, in the units of the case.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn strength_of(&self, body: &str) -> Result<SteelStrength, CaseError> {
        Ok(self.entry(body)?.strength())
    }

    /// Coefficient of thermal expansion of `body`, per kelvin; `None` where no table says it.
    pub(super) fn expansion_of(&self, body: &str) -> Option<f64> {
        self.tables(body)
            .iter()
            .flatten()
            .find_map(SteelTable::expansion)
    }

    /// The tables of a body itself and of all bodies, each with the thickness that either of them says.
    fn tables(&self, body: &str) -> [Option<SteelTable>; 2] {
        let own = self.bodies.iter().find(|(name, _)| name.value == body);
        let tables = [own.map(|(_, entry)| entry), self.default.as_ref()];
        let thickness = tables.iter().flatten().find_map(|table| table.thickness());
        tables.map(|table| table.map(|table| table.clone().with_thickness(thickness.cloned())))
    }

    /// All that is said of the steel of `body`.
    fn entry(&self, body: &str) -> Result<SteelTable, CaseError> {
        let size = self.sizes.iter().find(|(name, _)| name == body);
        let size = size.map(|(_, size)| *size);
        let units = self.units.unwrap_or(UnitSystem::MNPa);
        let graded = |entry: SteelTable| entry.graded(size, units);
        match self.tables(body) {
            // A body with a grade or all numbers of its own needs no grade of the default.
            [Some(own), Some(default)] if own.has_grade() => Ok(graded(own)?.over(&default)),
            [Some(own), Some(default)] if own.is_whole() => Ok(own.over(&default)),
            [Some(own), Some(default)] => Ok(own.over(&graded(default)?)),
            [Some(only), None] | [None, Some(only)] => graded(only),
            [None, None] => {
                let message = format!("the body `{body}` has no steel");
                let help = format!("give `[steel]` for all bodies, or `[steel.{body}]`");
                Err(CaseError::new(ErrorKind::MissingKey, message).help(help))
            }
        }
    }
}

/// The grades that come with the program, and those of the file that the case names.
fn known_grades(root: &Table) -> Result<Grades, CaseError> {
    let shipped = Grades::shipped()?;
    let Some(field) = root.get("grades") else {
        return Ok(shipped);
    };
    let file = field.string()?;
    let folder = Path::new(root.source().name()).parent();
    let path = folder.unwrap_or(Path::new("")).join(&file.value);
    shipped
        .with_file(&path)
        .map_err(|error| match error.kind() {
            ErrorKind::Read => file.place.error(ErrorKind::Read, error.to_string()),
            _ => error,
        })
}
