//! Entries by axis: components that are held, moved, turned or loaded.

use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::Table;
use super::place::Located;
use crate::ground::geometry::AXES;
use crate::ground::units::Dimension;

/// The components under `fixed` and `displacement`.
pub(super) fn displacements(table: &Table) -> Result<[Option<f64>; 3], CaseError> {
    let mut components = [None; 3];
    for axis in letters(table, "fixed")? {
        components[axis] = Some(0.0);
    }
    for (axis, value) in by_axis(table, "displacement", Dimension::LENGTH)? {
        if components[axis].is_some() {
            let why = format!("{} is already fixed", AXES[axis]);
            return Err(value.place.error(ErrorKind::Conflict, why));
        }
        components[axis] = Some(value.value);
    }
    Ok(components)
}

/// The part of the whole that is modelled: a quarter with two symmetry planes.
pub(super) fn modelled_share(mirrors: &[usize]) -> f64 {
    mirrors.iter().fold(1.0, |share, _| share / 2.0)
}

/// The entries of a table such as `{ x = …, z = … }`.
pub(super) fn by_axis(
    table: &Table,
    key: &str,
    dimension: Dimension,
) -> Result<Vec<(usize, Located<f64>)>, CaseError> {
    let Some(field) = table.get(key) else {
        return Ok(Vec::new());
    };
    let table = field.table()?.only(&keys::AXES)?;
    let entry = |(axis, name): (usize, &&str)| {
        table
            .get(name)
            .map(|field| Ok((axis, field.quantity(dimension)?)))
    };
    AXES.iter().enumerate().filter_map(entry).collect()
}

/// The axes whose letters are the text of `key`, each once; none where it is not given.
pub(super) fn letters(table: &Table, key: &str) -> Result<Vec<usize>, CaseError> {
    let mut axes = Vec::new();
    let Some(field) = table.get(key) else {
        return Ok(axes);
    };
    let letters = field.string()?;
    for letter in letters.value.chars() {
        let axis = AXES.iter().position(|axis| axis.starts_with(letter));
        let Some(axis) = axis.filter(|axis| !axes.contains(axis)) else {
            let why = "must be some of the letters x, y, z, each once";
            return Err(letters.place.error(ErrorKind::Value, why));
        };
        axes.push(axis);
    }
    Ok(axes)
}
