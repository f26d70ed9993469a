//! Soft springs on bodies that nothing but contact holds.

use super::bounds::diagonal;
use crate::answer::results::load;
use crate::ground::geometry::{AXES, norm};
use crate::model::scene::joined;
use crate::model::scene::{Partner, PlaneMotion, Scene};
use crate::render::inp::{Names, Springs};
use std::collections::BTreeSet;

/// The springs of a body and axis together would carry this share of the load if the body moved by
/// a thousandth of the model.
pub const LOAD_SHARE: f64 = 1e-4;
/// Springs on a body along an axis, at most.
const MOST_SPRINGS: usize = 60;

/// Springs for every body and axis that nothing but contact holds.
pub fn springs(scene: &Scene, names: &mut Names) -> Vec<Springs> {
    let mesh = &scene.mesh;
    let mut free = vec![[true; 3]; mesh.bodies.len()];
    let mut taken: BTreeSet<u32> = BTreeSet::new();
    let supports = scene
        .supports
        .iter()
        .map(|s| (&s.surface, s.components.map(|c| c.is_some())));
    let planes = scene.rigid_planes.iter();
    let planes = planes.map(|p| (&p.surface, p.motion.map(|m| m != PlaneMotion::Free)));
    for (name, axes) in supports.chain(planes) {
        for face in mesh.surface(name).map_or(&[][..], |s| &s.faces) {
            taken.extend(face.nodes);
            let body = mesh.body_of(face.element as usize);
            for axis in (0..3).filter(|a| axes[*a]) {
                free[body][axis] = false;
            }
        }
    }
    // What holds one of several bodies that are joined holds all.
    let joined = joined(scene);
    for body in 0..free.len() {
        let group = (0..free.len()).filter(|other| joined[*other] == joined[body]);
        let all = group.map(|other| free[other]);
        free[body] = all.fold([true; 3], |all, one| [0, 1, 2].map(|a| all[a] && one[a]));
    }
    for partner in scene
        .contacts
        .iter()
        .flat_map(|pair| [&pair.upper, &pair.lower])
    {
        if let Partner::Surface(name) = partner {
            taken.extend(mesh.nodes_of_surface(name));
        }
    }
    for surfaces in scene.ties.iter().filter_map(|tie| tie.of(mesh)) {
        taken.extend(surfaces.into_iter().flat_map(|s| s.nodes()));
    }
    let total = total_stiffness(scene);
    let mut list = Vec::new();
    for (index, (body, free)) in mesh.bodies.iter().zip(free).enumerate() {
        let mut nodes = mesh.nodes_of_body(index);
        nodes.retain(|node| !taken.contains(node));
        if nodes.is_empty() {
            continue;
        }
        let stride = nodes.len().div_ceil(MOST_SPRINGS);
        for axis in (0..3).filter(|a| free[*a]) {
            let nodes: Vec<u32> = nodes.iter().step_by(stride).copied().collect();
            list.push(Springs {
                name: names.unused(&format!("{}_spring_{}", body.name, AXES[axis])),
                axis,
                stiffness: total / nodes.len() as f64,
                nodes,
            });
        }
    }
    list
}

/// Stiffness of all springs on one body along one axis.
fn total_stiffness(scene: &Scene) -> f64 {
    let force = norm(load::full(scene)) / load::copies(scene);
    let moduli = scene.materials.iter().map(|s| s.youngs_modulus);
    match force > 0.0 {
        true => LOAD_SHARE * force / (1e-3 * diagonal(scene)),
        // Nothing but prescribed motion.
        false => 1e-9 * moduli.fold(0.0, f64::max) * diagonal(scene),
    }
}
