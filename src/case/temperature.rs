//! `[[temperature]]`: differences of temperature of bodies.

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::nearest::advice;
use super::parse::Table;
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
        let name = table.get("name").map(|field| field.string()).transpose()?;
        let name = name.unwrap_or_else(|| body.clone());
        if names.contains(&name.value) {
            let why = format!("there is already a support or load called `{}`", name.value);
            let help = "give each a `name` of its own: steps speak of them by name";
            return Err(name.place.error(ErrorKind::Duplicate, why).help(help));
        }
        names.push(name.value.clone());
        let value = table.get("value");
        let value = value.map(|field| field.quantity(Dimension::TEMPERATURE));
        let value = value.transpose()?.map_or(0.0, |value| value.value);
        let gradient = table.get("gradient");
        let gradient = gradient.map(|field| field.vector(Dimension::TEMPERATURE_GRADIENT));
        let gradient = (gradient.transpose()?).map_or([0.0; 3], |gradient| gradient.value);
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
            name: name.value,
            body,
            expansion,
            value,
            gradient,
        }));
    }
    Ok(temperatures)
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
            let error = temperature.place.error(ErrorKind::UnknownName, why);
            return Err(error.help(advice(body, bodies())));
        }
    }
    Ok(())
}
