//! Contacts that are no strips, and what they do to the stress below them.

use super::contact;
use super::figure::{Figure, Quantity};
use crate::answer::results::hex::distance;
use crate::answer::results::interface::Interface;
use crate::answer::results::peaks::{Peak, Place};
use crate::model::scene::Scene;
use crate::model::state::State;
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Radii of a patch up to which it decides the stress below.
const REACH: f64 = 3.0;

/// Where contacts press, and which of them the mesh is too coarse for.
#[derive(Default)]
pub(super) struct BelowPatches {
    /// Nodes of surfaces that press, or are pressed, where neither side curves from the other.
    nodes: BTreeSet<usize>,
    coarse: Vec<CoarsePatch>,
}

/// A patch whose largest pressure is not resolved, as nodes are too far apart.
struct CoarsePatch {
    bodies: [Option<usize>; 2],
    at: [f64; 3],
    radius: f64,
}

impl BelowPatches {
    /// Of all contacts of `state`, with what is claimed of them.
    /// `round` says which pairs have a side that curves from the other.
    pub fn new(
        (scene, state): (&Scene, &State),
        interfaces: &[Interface],
        round: &[bool],
        claims: &[Figure],
    ) -> Self {
        let mut nodes = BTreeSet::new();
        let mut coarse = Vec::new();
        let pairs = scene.contacts.iter().zip(&state.contacts);
        for ((pair, field), (interface, is_round)) in pairs.zip(interfaces.iter().zip(round)) {
            let pressing = (0..field.nodes.len()).filter(|node| field.is_active(*node));
            let Some(top) =
                (pressing.clone()).max_by(|a, b| field.pressure[*a].total_cmp(&field.pressure[*b]))
            else {
                continue;
            };
            if !is_round {
                nodes.extend(pressing.map(|node| field.nodes[node] as usize));
                let [_, other] = pair.carrier_first();
                let others = other.surface(&scene.mesh).map(|surface| surface.nodes());
                nodes.extend(others.into_iter().flatten().map(|node| node as usize));
            }
            let is_coarse = |claim: &Figure| {
                let what = [Quantity::PeakPressure, Quantity::PressureAway];
                what.contains(&claim.what) && claim.note == Some(contact::COARSE)
            };
            let mut own = claims.iter().filter(|claim| claim.place == interface.name);
            if own.any(is_coarse) {
                coarse.push(CoarsePatch {
                    bodies: pair.bodies(&scene.mesh),
                    at: scene.mesh.points[field.nodes[top] as usize],
                    radius: (interface.area / PI).sqrt(),
                });
            }
        }
        Self { nodes, coarse }
    }

    /// Is a peak on a flat surface of contact?
    pub fn press(&self, peak: &Peak) -> bool {
        matches!(peak.place, Place::Node(node) if self.nodes.contains(&node))
    }

    /// Is a place of a body below a patch that the mesh does not resolve?
    pub fn hide(&self, body: usize, at: &[f64; 3]) -> bool {
        (self.coarse.iter()).any(|patch| {
            patch.bodies.contains(&Some(body)) && distance(patch.at, *at) <= REACH * patch.radius
        })
    }
}
