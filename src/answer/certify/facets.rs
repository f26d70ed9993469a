//! Sections that facets make smaller, or larger, than those of the round bodies that they stand for.

use super::contacts::Contacts;
use super::outside::Outside;
use crate::model::scene::Scene;

/// Error of a stress, and of an elastic travel, over the share of the volume that facets miss: one in tension, up to two where round bars bend.
const OF_VOLUME: f64 = 2.0;

/// By which share of themselves stresses of each body, and what it gives way by, are off as its round faces are chords. Of bodies that a long strip
/// presses zero: what is said of them is measured on rollers of facets.
pub(super) fn off(scene: &Scene, contacts: Contacts, outside: &Outside) -> Vec<f64> {
    let of_body = |body: usize| match contacts.is_below_strip(scene, body) {
        true => 0.0,
        false => OF_VOLUME * outside.beyond_facets(body).abs(),
    };
    (0..scene.mesh.bodies.len()).map(of_body).collect()
}
