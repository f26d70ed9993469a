//! Gives the rollers of a mesh their end shape.

use super::end_shape::RollerEnd;
use super::layout::{Layout, RollerPlace};
use crate::model::mesh::Mesh;

/// Moves the nodes of the rollers that are modelled from the square-ended cylinder of the mesh onto the profile
/// of their ends. The mesh must be in the unit of `geometry`.
///
/// Nodes move towards the axis: those on the outer surface by the drop of the profile at their
/// place along the roller, those at the bore (or the axis) not at all, linearly in between.
pub fn shape_roller_ends(mesh: &mut Mesh, geometry: &dyn Layout, full: bool) {
    if geometry.end() == RollerEnd::Square {
        return;
    }
    for roller in geometry.rollers(full) {
        for node in nodes_of(mesh, &roller.body) {
            move_node(&mut mesh.points[node], &roller, geometry);
        }
    }
}

fn move_node(point: &mut [f64; 3], place: &RollerPlace, geometry: &dyn Layout) {
    let (axis, across, centre) = (place.axis, 1 - place.axis, place.centre);
    let roller = geometry.roller();
    let (outer, inner) = (roller.radius(), roller.bore_radius());
    let aside = point[across] - centre[across];
    let up = point[2] - centre[2];
    let radius = aside.hypot(up);
    if radius <= inner || radius == 0.0 {
        return;
    }
    let along = point[axis] - centre[axis];
    let drop = roller.end.drop_at(along, roller.length, outer);
    let scale = 1.0 - drop * (radius - inner) / (outer - inner) / radius;
    point[across] = centre[across] + aside * scale;
    point[2] = centre[2] + up * scale;
}

/// The nodes of a body, each once.
pub(super) fn nodes_of(mesh: &Mesh, body: &str) -> Vec<usize> {
    let nodes = mesh.body(body).map(|body| mesh.nodes_of_body(body));
    let nodes = nodes.unwrap_or_default().into_iter();
    nodes.map(|node| node as usize).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::bearing::geometry::Roller;
    use crate::case::bearing::sample::initial;
    use crate::model::mesh::Body;

    #[test]
    fn outer_nodes_drop_bore_nodes_stay() {
        let mut bearing = initial();
        bearing.offset = 2.5;
        bearing.roller.end = RollerEnd::Crown(0.01);
        for roller in Roller::BOTH {
            let centre = bearing.roller_centre(roller);
            let at = |radius: f64, along: f64| {
                let mut point = centre;
                point[roller.across()] += 0.6 * radius;
                point[2] -= 0.8 * radius;
                point[roller.axis()] = along;
                point
            };
            // Only the points matter: one element with repeated nodes.
            let before = vec![at(1.5, 4.0), at(0.75, 4.0), at(1.125, 4.0), at(1.5, 0.0)];
            let mut mesh = Mesh {
                points: before.clone(),
                hexes: vec![[0, 1, 2, 3, 0, 1, 2, 3]],
                bodies: vec![Body {
                    name: roller.body().into(),
                    elements: 0..1,
                }],
                ..Mesh::default()
            };
            shape_roller_ends(&mut mesh, &bearing, false);
            let wanted = [at(1.49, 4.0), before[1], at(1.12, 4.0), before[3]];
            for (point, wanted) in mesh.points.iter().zip(wanted) {
                for (a, b) in point.iter().zip(wanted) {
                    assert!((a - b).abs() < 1e-14, "{point:?} {wanted:?}");
                }
            }
        }
    }
}
