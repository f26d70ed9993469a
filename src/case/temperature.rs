//! `[[temperature]]`: differences of temperature of bodies.

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::{Field, Table};
use super::place::Located;
use super::steel::Steels;
use crate::ground::geometry::AXES;
use crate::ground::units::Dimension;
use crate::model::scene::Temperature;

/// What is taken where no steel says it, per kelvin.
const EXPANSION: f64 = 12e-6;

/// All temperatures of a case of these `steels`, marked at their bodies; `names` are those that steps know already, to
/// which these are added.
pub(super) fn read(
    root: &Table,
    steels: &Steels,
    (names, assumptions): (&mut Vec<String>, &mut Vec<Assumption>),
) -> Result<Vec<Located<Temperature>>, CaseError> {
    let mut temperatures = Vec::new();
    for table in root.tables("temperature")? {
        let table = table.only(&keys::TEMPERATURE)?;
        let body = table.need("body")?.string()?;
        let name = name_of_its_own(&table, &body, names)?;
        let value = table.maybe("value", |field| field.quantity(Dimension::TEMPERATURE))?;
        let value = value.map_or(0.0, |value| value.value);
        let gradient = table.maybe("gradient", |field| {
            field.vector(Dimension::TEMPERATURE_GRADIENT)
        })?;
        let gradient = gradient.map_or([0.0; 3], |gradient| gradient.value);
        if value == 0.0 && gradient == [0.0; 3] {
            let why = format!("the temperature of `{}` does not differ", body.value);
            let help = "give a `value`, a `gradient` or both";
            return Err(table.error(ErrorKind::MissingKey, why).help(help));
        }
        let expansion = steels.expansion_of(&body.value).unwrap_or_else(|| {
            let key = format!("steel.{}.expansion", body.value);
            let why =
                "no coefficient of thermal expansion is given; this is usual for structural steel";
            assumptions.push(Assumption::default(&key, "12e-6 1/K", why));
            EXPANSION
        });
        temperatures.push(body.map(|body| Temperature {
            name,
            body,
            expansion,
            value,
            gradient,
        }));
    }
    Ok(temperatures)
}

/// The name of an entry, by default that of the surface or body it is `of`. Names are what steps speak of, so each is
/// given once.
pub(super) fn name_of_its_own(
    table: &Table,
    of: &Located<String>,
    names: &mut Vec<String>,
) -> Result<String, CaseError> {
    let name = table.maybe("name", Field::string)?;
    let Located { value, place } = name.unwrap_or_else(|| of.clone());
    if names.contains(&value) {
        let why = format!("there is already a support or load called `{value}`");
        let help = "give each a `name` of its own: steps speak of them by name";
        return Err(place.error(ErrorKind::Duplicate, why).help(help));
    }
    names.push(value.clone());
    Ok(value)
}

/// Refuses gradients across symmetry planes, whose axes are `mirrors`; `help` says what to do instead.
pub(super) fn check_symmetry(root: &Table, mirrors: &[usize], help: &str) -> Result<(), CaseError> {
    for table in root.tables("temperature")? {
        let Some(field) = table.get("gradient") else {
            continue;
        };
        let gradient = field.vector(Dimension::TEMPERATURE_GRADIENT)?;
        if let Some(axis) = mirrors.iter().find(|axis| gradient.value[**axis] != 0.0) {
            let axis = AXES[*axis];
            let why = format!("a gradient along {axis} breaks the symmetry about {axis} = 0");
            return Err(gradient.place.error(ErrorKind::Conflict, why).help(help));
        }
    }
    Ok(())
}

/// Refuses temperatures of bodies that do not exist.
pub(super) fn check_bodies(
    temperatures: &[Located<Temperature>],
    bodies: &[(String, f64)],
) -> Result<(), CaseError> {
    let bodies = || bodies.iter().map(|(body, _)| body.as_str());
    for temperature in temperatures {
        let body = &temperature.value.body;
        if !bodies().any(|known| known == body) {
            let why = format!("there is no body called `{body}`");
            return Err(temperature.place.unknown(why, body, bodies()));
        }
    }
    Ok(())
}
