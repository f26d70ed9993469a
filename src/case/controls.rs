//! `[controls]`: the tolerances and increments of the solver.

use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::Table;
use super::place::Located;
use crate::model::scene::{Controls, ElementKind, SolverKind};

/// The controls of the case, with the defaults of [`Controls`].
pub(super) fn read(root: &Table) -> Result<Controls, CaseError> {
    let mut controls = Controls::default();
    let Some(field) = root.get("controls") else {
        return Ok(controls);
    };
    let table = field.table()?.only(&keys::CONTROLS)?;
    let share = |key: &str| -> Result<Option<Located<f64>>, CaseError> {
        let within = |v: &f64| *v > 0.0 && *v <= 1.0;
        let why = "must be more than 0 and at most 1";
        table.maybe(key, |field| field.ratio()?.require(within, why))
    };
    let value = |share: Option<Located<f64>>, default| share.map_or(default, |s| s.value);
    controls.residual = value(share("residual")?, controls.residual);
    controls.penetration = value(share("penetration")?, controls.penetration);
    controls.first_increment = value(share("first_increment")?, controls.first_increment);
    let first = controls.first_increment;
    let why = format!("is more than first_increment, {first}");
    let smallest = share("smallest_increment")?.map(|s| s.require(|s| *s <= first, why));
    let smallest = smallest.transpose()?;
    controls.smallest_increment = value(smallest, controls.smallest_increment.min(first));
    if let Some(field) = table.get("iterations") {
        controls.iterations = field.count()?.value;
    }
    for (key, flag) in [
        ("increment_error", &mut controls.increment_error),
        ("plasticity", &mut controls.plasticity),
        ("half_turn", &mut controls.half_turn),
    ] {
        if let Some(field) = table.get(key) {
            *flag = field.boolean()?.value;
        }
    }
    if let Some(field) = table.get("element") {
        let name = field.string()?;
        controls.element = match name.value.as_str() {
            "bbar" => ElementKind::Bbar,
            "full" => ElementKind::Full,
            "enhanced" => ElementKind::Enhanced,
            _ => {
                let why = "must be \"bbar\", \"full\" or \"enhanced\"";
                return Err(name.place.error(ErrorKind::Value, why));
            }
        };
    }
    if let Some(field) = table.get("solver") {
        let name = field.string()?;
        controls.solver = match name.value.as_str() {
            "auto" => SolverKind::Auto,
            "direct" => SolverKind::Direct,
            "divided" => SolverKind::Divided,
            _ => {
                let why = "must be \"auto\", \"direct\" or \"divided\"";
                return Err(name.place.error(ErrorKind::Value, why));
            }
        };
    }
    Ok(controls)
}
