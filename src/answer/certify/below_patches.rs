//! Contacts that are no strips, and what they do to the stress below them.

use super::contact::Touch;
use super::figure::{Figure, Quantity};
use super::notes;
use crate::answer::results::hex::distance;
use crate::answer::results::interface::Interface;
use crate::answer::results::peaks::{Peak, Place};
use crate::model::scene::{Scene, joined_to};
use crate::model::state::State;
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Radii of a patch up to which it decides the stress below.
const REACH: f64 = 3.0;

/// Relative error of the largest pressure of a point of contact from which on the mesh below it is coarse: about two and a half
/// elements in its radius. (Of 452 peaks below points that have one and a half or more, 6 are outside, and 10 of 462 were.)
const COARSE_FROM: f64 = 0.04;

/// Of the largest pressure of a patch, what the Mises stress below it is at least: 0.56 below a strip, 0.62 below a sphere,
/// and less below an even pressure or where shear of friction is small beside an edge.
const BELOW: f64 = 0.5;

/// Where contacts press, and how well the mesh resolves them.
#[derive(Default)]
pub(super) struct BelowPatches {
    /// Nodes of surfaces that press, or are pressed, where neither side curves from the other.
    nodes: BTreeSet<usize>,
    patches: Vec<Patch>,
}

/// A point of contact, or what the mesh is too coarse for.
struct Patch {
    /// Those of the pair, and what is joined to them.
    bodies: Vec<usize>,
    at: [f64; 3],
    radius: f64,
    /// Relative error of its largest pressure; `None` where nodes are too far apart, or facets too long for a fillet.
    error: Option<f64>,
    /// Its largest pressure, as read.
    pressure: f64,
}

impl BelowPatches {
    /// Of all contacts of `state`, with what is claimed of them.
    /// `touches` says from where they spread.
    pub fn new(
        (scene, state): (&Scene, &State),
        interfaces: &[Interface],
        touches: &[Touch],
        claims: &[Figure],
    ) -> Self {
        let mut nodes = BTreeSet::new();
        let mut patches = Vec::new();
        let pairs = scene.contacts.iter().zip(&state.contacts);
        for ((pair, field), (interface, touch)) in pairs.zip(interfaces.iter().zip(touches)) {
            let pressing = (0..field.nodes.len()).filter(|node| field.is_active(*node));
            let Some(top) =
                (pressing.clone()).max_by(|a, b| field.pressure[*a].total_cmp(&field.pressure[*b]))
            else {
                continue;
            };
            if *touch == Touch::Flat {
                nodes.extend(pressing.map(|node| field.nodes[node] as usize));
                let [_, other] = pair.carrier_first();
                let others = other.surface(&scene.mesh).map(|surface| surface.nodes());
                nodes.extend(others.into_iter().flatten().map(|node| node as usize));
            }
            let own = || {
                let what = [Quantity::PeakPressure, Quantity::PressureAway];
                (claims.iter()).filter(move |c| what.contains(&c.what) && c.place == interface.name)
            };
            let is_unknown = |claim: &Figure| match claim.note {
                Some(notes::FILLET) => *touch != Touch::Line,
                note => note == Some(notes::COARSE),
            };
            let is_coarse = own().any(is_unknown);
            let is_point = *touch == Touch::Point;
            let error = (own().filter(|_| !is_coarse)).find_map(Figure::relative_bar);
            if is_coarse || is_point && error.is_some() {
                patches.push(Patch {
                    bodies: joined_to(scene, pair),
                    at: scene.mesh.points[field.nodes[top] as usize],
                    radius: (interface.area / PI).sqrt(),
                    error,
                    pressure: interface.max_pressure,
                });
            }
        }
        Self { nodes, patches }
    }

    /// Is a peak on a flat surface of contact?
    pub fn press(&self, peak: &Peak) -> bool {
        matches!(peak.place, Place::Node(node) if self.nodes.contains(&node))
    }

    /// Is a place of a body below a point of contact, or what the mesh is too coarse for?
    pub fn is_above(&self, body: usize, at: &[f64; 3]) -> bool {
        self.above(body, at).next().is_some()
    }

    /// Is a place of a body below a patch that the mesh does not resolve?
    pub fn hide(&self, body: usize, at: &[f64; 3]) -> bool {
        self.above(body, at).any(|patch| patch.error.is_none())
    }

    /// Is there more below such a patch, wherever it is on a body, than a peak elsewhere has at `most`?
    pub fn hide_more(&self, body: usize, most: f64) -> bool {
        let unresolved = |patch: &&Patch| patch.error.is_none() && patch.bodies.contains(&body);
        let mut hidden = self.patches.iter().filter(unresolved);
        hidden.any(|patch| BELOW * patch.pressure > most)
    }

    /// Share that counts of what a node has more than the centres of elements at a place of a body. Below a point of contact
    /// that is of the first order of the spacing, while the error is of the second, as that of the pressure.
    pub fn share(&self, body: usize, at: &[f64; 3]) -> f64 {
        let largest = self.of_pressure(body, at);
        largest.map_or(1.0, |error| (error / COARSE_FROM).min(1.0))
    }

    /// Relative error of the largest pressure above a place of a body: the stress below a point is not known better.
    pub fn of_pressure(&self, body: usize, at: &[f64; 3]) -> Option<f64> {
        let errors = self.above(body, at).filter_map(|patch| patch.error);
        errors.reduce(f64::max)
    }

    fn above(&self, body: usize, at: &[f64; 3]) -> impl Iterator<Item = &Patch> {
        let at = *at;
        (self.patches.iter()).filter(move |patch| {
            patch.bodies.contains(&body) && distance(patch.at, at) <= REACH * patch.radius
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_is_well_resolved_needs_less_of_what_nodes_have_more_than_centres() {
        let patch = |x: f64, error| Patch {
            bodies: vec![0, 1],
            at: [x, 0.0, 0.0],
            radius: 1.0,
            error,
            pressure: 100.0,
        };
        let below = BelowPatches {
            patches: vec![
                patch(0.0, Some(0.25 * COARSE_FROM)),
                patch(4.0, Some(2.0 * COARSE_FROM)),
                patch(20.0, None),
            ],
            ..BelowPatches::default()
        };
        assert_eq!(below.share(1, &[0.0, 0.0, -0.5]), 0.25);
        assert_eq!(below.share(1, &[2.0, 0.0, -0.5]), 1.0);
        assert_eq!(below.share(1, &[10.0, 0.0, -0.5]), 1.0);
        assert_eq!(below.share(2, &[0.0, 0.0, -0.5]), 1.0);
        assert!(below.hide(0, &[20.0, 0.0, -0.5]));
        assert!(!below.hide(0, &[4.0, 0.0, -0.5]) && !below.hide(2, &[20.0, 0.0, -0.5]));
        assert!(below.hide_more(1, 40.0) && !below.hide_more(1, 60.0) && !below.hide_more(2, 40.0));
    }
}
