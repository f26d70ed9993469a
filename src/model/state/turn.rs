//! How far bodies have turned as a whole.

use crate::ground::geometry::{Vec3, add, cross, dot, norm, scale, sub};
use crate::model::mesh::Mesh;
use nalgebra::{Matrix3, Vector3};

/// Radians: a roller that rolls further bears a fiftieth of its radius beside where contact was sought, or more.
pub const FAR: f64 = 0.02;
/// What turns so far has its lengths wrong by half a percent, and a roller bears a tenth of its radius beside.
pub const TOO_FAR: f64 = 0.1;

/// The body that turns most and its angle in radians: of the rotation about the middle of its nodes that is nearest
/// to their displacements, in least squares. `None` for a mesh without bodies.
pub fn largest_turn<'m>(mesh: &'m Mesh, displacement: &[Vec3]) -> Option<(&'m str, f64)> {
    let turns = mesh.bodies.iter().enumerate().map(|(index, body)| {
        let nodes = mesh.nodes_of_body(index);
        (body.name.as_str(), turn(mesh, &nodes, displacement))
    });
    turns.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Σ r × (ω × r) = Σ r × u.
fn turn(mesh: &Mesh, nodes: &[u32], displacement: &[Vec3]) -> f64 {
    let at = |node: &u32| mesh.points[*node as usize];
    let sum = nodes.iter().fold([0.0; 3], |sum, node| add(sum, at(node)));
    let middle = scale(sum, 1.0 / nodes.len().max(1) as f64);
    let (mut inertia, mut moment) = (Matrix3::zeros(), Vector3::zeros());
    for node in nodes {
        let arm = sub(at(node), middle);
        let r = Vector3::from(arm);
        inertia += Matrix3::identity() * dot(arm, arm) - r * r.transpose();
        moment += Vector3::from(cross(arm, displacement[*node as usize]));
    }
    let turn = inertia.lu().solve(&moment);
    turn.map_or(0.0, |turn| norm(turn.into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, uniform};

    #[test]
    fn a_body_that_is_moved_and_turned_has_turned_by_so_much() {
        let line = || uniform(0.0, 1.0, 3);
        let block = |name| Block::new(name, line(), line(), line()).build().unwrap();
        let mut other = block("b");
        other.points.iter_mut().for_each(|p| p[0] += 5.0);
        let parts = [block("a"), other.prefixed("b_")];
        let mesh = Mesh::join(parts).unwrap();
        let turned = |p: &Vec3| match p[0] > 2.0 {
            true => add([0.3, 0.1, 0.0], cross([0.0, 0.01, 0.02], *p)),
            false => [0.7, 0.0, 0.0],
        };
        let displacement: Vec<Vec3> = mesh.points.iter().map(turned).collect();
        let (body, angle) = largest_turn(&mesh, &displacement).unwrap();
        assert_eq!(body, "b_b");
        assert!((angle - 5e-4f64.sqrt()).abs() < 1e-12, "{angle}");
    }
}
