//! `[controls]`: the tolerances and increments of the solver.

use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::{Field, Table};
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
        let within = |v: &f64| Controls::is_share(*v);
        let why = format!("must be {}", Controls::SHARE);
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
        let kinds = [
            ("bbar", ElementKind::Bbar),
            ("full", ElementKind::Full),
            ("enhanced", ElementKind::Enhanced),
        ];
        controls.element = word(&field, kinds)?;
    }
    if let Some(field) = table.get("solver") {
        let kinds = [
            ("auto", SolverKind::Auto),
            ("direct", SolverKind::Direct),
            ("divided", SolverKind::Divided),
        ];
        controls.solver = word(&field, kinds)?;
    }
    Ok(controls)
}

/// What one of three words stands for.
fn word<T: Copy>(field: &Field, words: [(&str, T); 3]) -> Result<T, CaseError> {
    let given = field.string()?;
    let found = words.iter().find(|(word, _)| *word == given.value);
    let [a, b, c] = words.map(|(word, _)| word);
    let why = format!("must be \"{a}\", \"{b}\" or \"{c}\"");
    let wrong = || given.place.error(ErrorKind::Value, why);
    found.map(|(_, value)| *value).ok_or_else(wrong)
}
