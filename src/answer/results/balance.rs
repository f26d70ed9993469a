//! Where contact forces act, and whether bodies that nothing but contact holds are in balance.

use super::load::{self, cutting, cutting_pair, times, whole_of};
use crate::ground::geometry::{cross, dot};
use crate::model::mesh::Surface;
use crate::model::scene::{Partner, Scene, Side, joined};
use crate::model::state::State;

/// What contact does to a body that nothing else touches.
#[derive(Debug, Clone, PartialEq)]
pub struct Balance {
    /// Name of the body.
    pub body: String,
    /// Sum of the contact forces on it, of the whole.
    pub force: [f64; 3],
    /// Sum of their moments about its middle.
    pub moment: [f64; 3],
}

/// Centre of the force of contact pair `pair` along the applied load, on the undeformed carrier
/// surface: Σ f x / Σ f. Of the whole, so zero along mirrored axes. `None` where nothing presses.
pub fn centre_of_force(scene: &Scene, state: &State, pair: usize) -> Option<[f64; 3]> {
    let field = state.contacts.get(pair)?;
    let along = load::along(scene, state);
    let (mut sum, mut total) = ([0.0; 3], 0.0);
    for ([at, _], force) in field.acts_at.iter().zip(&field.force) {
        let force = dot(*force, along);
        total += force;
        (0..3).for_each(|i| sum[i] += force * at[i]);
    }
    let mirrors = cutting_pair(scene, pair);
    let centre = |axis: usize| match mirrors.contains(&axis) {
        true => 0.0,
        false => sum[axis] / total,
    };
    (total != 0.0).then(|| [0, 1, 2].map(centre))
}

/// The balance of every body without support, rigid plane or traction that is joined to no other, in the order of the mesh.
pub fn balances(scene: &Scene, state: &State) -> Vec<Balance> {
    let (held, joined) = (held_bodies(scene), joined(scene));
    let alone = |index: usize| {
        joined
            .iter()
            .filter(|group| **group == joined[index])
            .count()
            == 1
    };
    let bodies = scene.mesh.bodies.iter().enumerate();
    bodies
        .filter(|(index, _)| !held.contains(index) && alone(*index))
        .filter_map(|(index, body)| {
            let mirrors = cutting(scene, index);
            let about = middle(scene, index, &mirrors)?;
            let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
            for (pair, field) in state.contacts.iter().enumerate() {
                let Some((sign, carries)) = side(scene, pair, index) else {
                    continue;
                };
                for (at, f) in field.acts_at.iter().zip(&field.force) {
                    let at = if carries { at[0] } else { at[1] };
                    let f = f.map(|f| sign * f);
                    let arm = [0, 1, 2].map(|i| at[i] - about[i]);
                    let turn = cross(arm, f);
                    (0..3).for_each(|i| {
                        force[i] += f[i];
                        moment[i] += turn[i];
                    });
                }
            }
            Some(Balance {
                body: body.name.clone(),
                force: whole_of(&mirrors, force),
                moment: whole_moment(&mirrors, moment),
            })
        })
        .collect()
}

/// The moment on the whole: a mirror doubles the component along its axis and cancels the others,
/// for a moment is an axial vector.
pub fn whole_moment(mirrors: &[usize], modelled: [f64; 3]) -> [f64; 3] {
    let survives = |component: usize| mirrors.iter().all(|axis| *axis == component);
    [0, 1, 2].map(|i| match survives(i) {
        true => times(mirrors) * modelled[i],
        false => 0.0,
    })
}

/// Bodies that something other than contact acts on.
fn held_bodies(scene: &Scene) -> Vec<usize> {
    let supports = scene.supports.iter().map(|s| &s.surface);
    let planes = scene.rigid_planes.iter().map(|p| &p.surface);
    let tractions = scene.tractions.iter().map(|t| &t.surface);
    let surfaces = supports.chain(planes).chain(tractions);
    // A symmetry plane holds as a mirror does: what it takes, the other half gives.
    let mirror = |surface: &&Surface| {
        let nodes = surface.nodes();
        let on = |n: u32, axis: usize| {
            let at = &scene.mesh.points[n as usize];
            scene.mirrors_through(at).any(|through| through == axis)
        };
        let mut axes = scene.mirrors.iter();
        axes.any(|axis| nodes.iter().all(|n| on(*n, *axis)))
    };
    (surfaces.filter_map(|name| scene.mesh.surface(name)))
        .filter(|surface| !mirror(surface))
        .flat_map(|surface| surface.bodies(&scene.mesh))
        .collect()
}

/// The sign of the forces of a pair on body `index`, and whether it is the carrier; `None` where
/// the body has no part in the pair.
fn side(scene: &Scene, pair: usize, index: usize) -> Option<(f64, bool)> {
    let contact = &scene.contacts[pair];
    let is = |partner: &Partner| partner.body(&scene.mesh) == Some(index);
    match (is(&contact.lower), is(&contact.upper)) {
        (true, _) => Some((1.0, contact.carrier == Side::Lower)),
        (_, true) => Some((-1.0, contact.carrier == Side::Upper)),
        _ => None,
    }
}

/// Mean of the body's nodes, of the whole.
fn middle(scene: &Scene, body: usize, mirrors: &[usize]) -> Option<[f64; 3]> {
    let elements = scene.mesh.bodies.get(body)?.elements.clone();
    let count = 8.0 * elements.len() as f64;
    let corners = scene.mesh.hexes[elements].iter().flatten();
    let mut sum = [0.0; 3];
    for node in corners {
        let at = scene.mesh.points[*node as usize];
        (0..3).for_each(|i| sum[i] += at[i]);
    }
    let mean = |axis: usize| match mirrors.contains(&axis) {
        true => 0.0,
        false => sum[axis] / count,
    };
    (count > 0.0).then(|| [0, 1, 2].map(mean))
}
