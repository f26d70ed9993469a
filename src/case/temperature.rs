//! `[[temperature]]`: differences of temperature of bodies.

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::Table;
use super::place::Located;
use super::steel::Steels;
use crate::ground::geometry::AXES;
use crate::ground::units::Dimension;
use crate::model::scene::Temperature;

/// What is taken where no steel says it, per kelvin.
const EXPANSION: f64 = 12e-6;

/// All temperatures of a case of these `steels`, marked at their bodies. `mirrors` are the axes of the symmetry planes;
/// `names` are those that steps know already, to which these are added.
pub(super) fn read(
    root: &Table,
    mirrors: &[usize],
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
        let gradient = gradient.transpose()?;
        if let Some(gradient) = &gradient
            && let Some(axis) = mirrors.iter().find(|axis| gradient.value[**axis] != 0.0)
        {
            let why = format!(
                "a gradient along {0} breaks the symmetry about {0} = 0",
                AXES[*axis]
            );
            return Err(gradient.place.error(ErrorKind::Conflict, why));
        }
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
            name: name.value,
            body,
            expansion,
            value,
            gradient,
        }));
    }
    Ok(temperatures)
}
