//! Rollers askew: turned about the vertical through the middle of their axes.

use super::layout::{Layout, RollerPlace};
use super::roller_end::nodes_of;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::parse::{Field, Table};
use crate::case::rigid_plane::LARGEST_ANGLE;
use crate::ground::units::Dimension;
use crate::model::mesh::Mesh;

/// Turns the rollers of a mesh that are askew.
///
/// A surface becomes exactly the cylinder turned by the angle s; cuts across the roller stay where they are along the
/// plates, so that nodes stand in rows across both. Ends are thus cut as the plates are, and the length is measured along
/// the plates: both differ from those of a rigid turn by s²/2.
pub fn turn_rollers(mesh: &mut Mesh, geometry: &dyn Layout, full: bool) {
    for roller in geometry.rollers(full) {
        if roller.skew == 0.0 {
            continue;
        }
        let (axis, across) = (roller.axis, 1 - roller.axis);
        let (middle, lean) = (roller.centre, roller.lean());
        // A cut that is not square to a cylinder is an ellipse.
        let wider = 1.0 / roller.skew.cos();
        for node in nodes_of(mesh, &roller.body) {
            let point = &mut mesh.points[node];
            let aside = wider * (point[across] - middle[across]);
            point[across] = middle[across] + aside + lean * (point[axis] - middle[axis]);
        }
    }
}

impl RollerPlace {
    /// How far its axis goes aside, along the horizontal axis across, over the way along it.
    pub fn lean(&self) -> f64 {
        match self.axis {
            // By the right hand about z, x turns towards y, and y towards -x.
            0 => self.skew.tan(),
            _ => -self.skew.tan(),
        }
    }
}

/// Reads `skew` of so many rollers: one angle for all, or one for each; none where it is left out.
pub(super) fn read(table: &Table, rollers: usize) -> Result<Vec<f64>, CaseError> {
    let Some(field) = table.get("skew") else {
        return Ok(vec![0.0; rollers]);
    };
    if !field.is_list() {
        return Ok(vec![angle(&field)?; rollers]);
    }
    let items = field.list()?;
    if items.len() != rollers {
        let why = format!(
            "one angle for each of {rollers} rollers is wanted, these are {}",
            items.len()
        );
        let error = field.place().error(ErrorKind::Value, why);
        return Err(error.help("give one angle for all of them, or a list of one each"));
    }
    items.iter().map(angle).collect()
}

fn angle(field: &Field) -> Result<f64, CaseError> {
    let angle = field.quantity(Dimension::ANGLE)?.value;
    if angle.abs() > LARGEST_ANGLE {
        let why = format!("angles are small here: {LARGEST_ANGLE} rad at most");
        return Err(field.place().error(ErrorKind::Value, why));
    }
    Ok(angle)
}
