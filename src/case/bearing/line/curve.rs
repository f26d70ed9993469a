//! Gives a plate of a mesh its curved face.

use super::geometry::LineGeometry;
use crate::case::bearing::roller_end::nodes_of;
use crate::model::mesh::Mesh;

/// Moves the nodes of a curved plate from the flat plate of the mesh, those of its face onto the cylinder, those of the
/// outer face not at all, linearly in between.
pub fn curve_plate(mesh: &mut Mesh, geometry: &LineGeometry) {
    let Some(curve) = geometry.curve else { return };
    let (body, plate, up) = match curve.upper {
        true => ("upper_plate", geometry.upper, 1.0),
        false => ("lower_plate", geometry.lower, -1.0),
    };
    for node in nodes_of(mesh, body) {
        let point = &mut mesh.points[node];
        let from_face = up * point[2] - geometry.roller.radius();
        let share = 1.0 - from_face / plate.thickness;
        point[2] += up * share * curve.recedes(point[0]);
    }
}
