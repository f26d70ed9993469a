//! The steels of a case: a default for all bodies, and what single bodies have otherwise.

mod hardening;
mod table;

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::nearest::advice;
use super::parse::{Field, Table};
use super::place::Located;
use crate::ground::units::UnitSystem;
use crate::model::material::Steel;
pub use hardening::StrainIs;
use table::SteelTable;

/// The steels of all bodies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Steels {
    default: Option<SteelTable>,
    bodies: Vec<(Located<String>, SteelTable)>,
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
            steels.default = Some(SteelTable::read(&table, assumptions)?);
        }
        for body in table.keys().into_iter().filter(is_body) {
            let entry =
                SteelTable::read(&table.need(body)?.table()?.only(&keys::STEEL)?, assumptions)?;
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
        let entry = SteelTable::read(&field.table()?.only(&keys::STEEL)?, assumptions)?;
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
