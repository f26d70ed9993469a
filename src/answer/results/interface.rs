//! Scalars of each contact interface, for the whole bearing.

use super::balance::centre_of_force;
use super::hex::distance;
use super::load::{along, cutting_pair, times, whole_of};
use crate::ground::geometry::{dot, norm};
use crate::model::mesh::Face;
use crate::model::scene::Scene;
use crate::model::state::{ContactField, State};

/// How many nodes of the modelled part of a carrier surface are open, stick and slip.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize, schemars::JsonSchema)]
pub struct StatusCounts {
    /// Nodes that are open.
    pub open: usize,
    /// Nodes that stick.
    pub stick: usize,
    /// Nodes that slip.
    pub slip: usize,
}

/// What an interface carries. Forces, integrals and areas are those of the whole bearing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Interface {
    /// `<upper>-<lower>`.
    pub name: String,
    /// Resultant of pressure and friction on the lower body.
    pub force: [f64; 3],
    /// Component of `force` along the applied load, compression positive.
    pub normal_force: f64,
    /// Where the force along the load acts, see [`centre_of_force`].
    pub centre_of_force: Option<[f64; 3]>,
    /// Integral of the pressure over the area.
    pub pressure_integral: f64,
    /// Integral of the size of the shear over the area: of that `force` has what does not cancel.
    pub shear_integral: f64,
    /// Largest consistent nodal pressure and the undeformed position of its node.
    pub max_pressure: f64,
    /// Undeformed position of the node with the largest pressure.
    pub max_pressure_at: Option<[f64; 3]>,
    /// Deepest overlap of the two true surfaces, zero or positive, see [`ContactField::penetration`].
    pub max_penetration: f64,
    /// What of it a rim explains that opens steeply, see [`ContactField::at_rim`].
    pub rim_penetration: f64,
    /// What of it neither the facets nor the rim explain, see [`ContactField::unexplained`].
    pub unexplained_penetration: f64,
    /// Undeformed place of that on the carrier.
    pub unexplained_at: Option<[f64; 3]>,
    /// Largest weighted gap below zero of a node in contact: how far contact conditions are missed.
    pub contact_error: f64,
    /// Area of the nodes in contact.
    pub area: f64,
    /// Nodes of the modelled part by status.
    pub status_counts: StatusCounts,
    /// Largest tangential traction beyond μ p, relative to μ times the largest pressure; zero
    /// without friction.
    pub coulomb_violation: f64,
    /// Largest accumulated slip.
    pub max_slip: f64,
    /// Shortest side of a carrier face with a corner in contact; `None` without contact.
    pub face_side: Option<f64>,
}

/// The scalars of every contact pair, in the order of the scene.
pub fn interfaces(scene: &Scene, state: &State) -> Vec<Interface> {
    (0..scene.contacts.len().min(state.contacts.len()))
        .map(|i| interface(scene, state, i))
        .collect()
}

fn interface(scene: &Scene, state: &State, pair: usize) -> Interface {
    let (contact, field) = (&scene.contacts[pair], &state.contacts[pair]);
    let mirrors = cutting_pair(scene, pair);
    let copies = times(&mirrors);
    let mut result = Interface {
        name: contact.name.clone(),
        max_penetration: field.penetration,
        rim_penetration: field.at_rim,
        unexplained_penetration: field.unexplained,
        unexplained_at: field.unexplained_at,
        centre_of_force: centre_of_force(scene, state, pair),
        ..Interface::default()
    };
    let mut force = [0.0; 3];
    let mut excess = 0.0f64;
    for (i, node) in field.nodes.iter().enumerate() {
        let pressure = field.pressure[i];
        for (sum, f) in force.iter_mut().zip(field.force[i]) {
            *sum += f;
        }
        result.pressure_integral += copies * pressure * field.area[i];
        result.shear_integral += copies * norm(field.traction[i]) * field.area[i];
        if field.is_active(i) {
            result.area += copies * field.area[i];
        }
        if pressure > result.max_pressure {
            result.max_pressure = pressure;
            result.max_pressure_at = Some(scene.mesh.points[*node as usize]);
        }
        if field.is_active(i) {
            result.contact_error = result.contact_error.max(-field.gap[i]);
        }
        result.max_slip = result.max_slip.max(field.slip[i]);
        excess = excess.max(norm(field.traction[i]) - contact.friction * pressure.max(0.0));
        match field.status[i] {
            0 => result.status_counts.open += 1,
            1 => result.status_counts.stick += 1,
            _ => result.status_counts.slip += 1,
        }
    }
    result.face_side = face_side(scene, pair, field);
    result.force = whole_of(&mirrors, force);
    // Contact does not pull, and either side may be the one below.
    result.normal_force = dot(result.force, along(scene, state)).abs();
    let limit = contact.friction * result.max_pressure;
    if limit > 0.0 {
        result.coulomb_violation = excess.max(0.0) / limit;
    }
    result
}

/// Faces of the carrier of a pair that press; none where it is no surface.
pub fn pressed_faces<'s>(
    scene: &'s Scene,
    pair: usize,
    field: &'s ContactField,
) -> impl Iterator<Item = &'s Face> {
    let is_active = |node: &u32| {
        let at = field.nodes.binary_search(node);
        at.is_ok_and(|i| field.is_active(i))
    };
    let faces = scene
        .carrier(pair)
        .into_iter()
        .flat_map(|surface| &surface.faces);
    faces.filter(move |face| face.nodes.iter().any(is_active))
}

fn face_side(scene: &Scene, pair: usize, field: &ContactField) -> Option<f64> {
    let sides = pressed_faces(scene, pair, field).flat_map(|face| {
        let corners = face.nodes.map(|n| scene.mesh.points[n as usize]);
        [0, 1, 2, 3].map(|i| distance(corners[i], corners[(i + 1) % 4]))
    });
    sides.reduce(f64::min)
}
