//! What ties carry.
//!
//! A node that follows has no equation of its own: what loads, inner forces and contact leave over there goes through the
//! tie, to the nodes that it follows.

use crate::ground::geometry::{Vec3, dot, scale, sub};
use crate::model::state::TieField;
use crate::solver::solve::model::system::Model;

/// The field of each tie, from what is `left` over at nodes; hands that on through the ties.
pub fn tie_fields(model: &Model, left: &mut [Vec3]) -> Vec<TieField> {
    let tied = &model.all.tied;
    let of_joint = tied.joints.iter().map(|joint| TieField {
        follows: joint.follows,
        distance: joint.distance,
        covered: joint.covered,
        ..TieField::default()
    });
    let mut fields: Vec<TieField> = of_joint.collect();
    let mut normals: Vec<Vec<Vec3>> = vec![Vec::new(); fields.len()];
    for node in &tied.areas {
        let field = &mut fields[node.tie as usize];
        field.nodes.push(node.node);
        field.area.push(node.area);
        field.force.push([0.0; 3]);
        normals[node.tie as usize].push(node.normal);
    }
    tied.fold(left, |follower, force| {
        let Some(tie) = follower.tie else { return };
        let field = &mut fields[tie as usize];
        let mut add_at = |component: u32, force: f64| {
            if let Ok(at) = field.nodes.binary_search(&(component / 3)) {
                field.force[at][component as usize % 3] += force;
            }
        };
        add_at(follower.component, force);
        // Functions of nodes that it stands for, too.
        (follower.terms.iter()).for_each(|(other, factor)| add_at(*other, -factor * force));
    });
    for (field, normals) in fields.iter_mut().zip(normals) {
        // On the side that is followed; told as it acts on the second one.
        let sign = if field.follows == 0 { 1.0 } else { -1.0 };
        for ((force, area), normal) in field.force.iter_mut().zip(&field.area).zip(normals) {
            let stress = scale(*force, 1.0 / area);
            let pressure = dot(stress, normal);
            field.pressure.push(pressure);
            let shear = sub(stress, scale(normal, pressure));
            field.shear.push(scale(shear, sign));
            *force = scale(*force, sign);
        }
    }
    fields
}
