//! What a body bears on.

use crate::ground::geometry::{Vec3, add, scale, unit};
use crate::model::scene::Scene;
use crate::solver::solve::params::CONE_EDGES;
use crate::solver::solve::rigid::rigid_bodies::RigidBodies;
use crate::solver::solve::rows::contact_row::ContactRow;

/// What a body bears on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bears {
    pub pair: usize,
    /// Where the force acts.
    pub at: Vec3,
    /// Unit normal of the contact there.
    pub normal: Vec3,
}

/// The pair through which `body` is pressed most, and the middle of the forces there.
pub fn bears(
    scene: &Scene,
    rows: &[&ContactRow],
    frames: &RigidBodies,
    (forces, body): (&[(usize, f64)], usize),
) -> Option<Bears> {
    // Edges of cones are counted on from row to row.
    let count = |row: &ContactRow| row.row.tangents.map_or(1, |_| CONE_EDGES);
    let ends = rows.iter().scan(0, |end, row| {
        *end += count(row);
        Some(*end)
    });
    let ends: Vec<usize> = ends.collect();
    let mut pairs = vec![(0.0, [0.0; 3], [0.0; 3]); scene.contacts.len()];
    for (edge, force) in forces {
        let row = rows[ends.partition_point(|end| end <= edge)];
        let nodes = row.row.terms.iter().map(|(node, _)| *node as usize);
        if nodes
            .flat_map(|node| &frames.bodies[node])
            .any(|b| *b == body)
        {
            let (sum, moment, normal) = &mut pairs[row.pair];
            *sum += force;
            let at = scene.mesh.points[row.row.node as usize];
            *moment = add(*moment, scale(at, *force));
            *normal = add(*normal, scale(row.row.normal, *force));
        }
    }
    let most = pairs.iter().enumerate();
    let (pair, (sum, moment, normal)) = most.max_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    Some(Bears {
        pair,
        at: scale(*moment, 1.0 / sum),
        normal: unit(*normal).filter(|_| *sum > 0.0)?,
    })
}
