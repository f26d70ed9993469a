//! What the bodies below a contact are, and do.

use super::hex::{centre, diagonal, distance};
use crate::ground::geometry::Vec3;
use crate::model::scene::{ContactPair, Scene, joined_to};
use crate::model::state::State;

/// Half-widths, or radii, within which flow makes a contact other than Hertz's.
const OF_FLOW: f64 = 3.0;

/// Half-widths, or radii, within which another material does: a layer of the thickness t changes the width by (a/2t)² of itself
/// and less.
const OF_LAYER: f64 = 5.0;

/// Has what lies below the contact of a pair, at a place, yielded? `a` is its half-width or radius there.
pub fn flows_below(scene: &Scene, state: &State, pair: &ContactPair, (at, a): (Vec3, f64)) -> bool {
    let flows = |element: usize| state.peeq_of(element).iter().any(|p| *p > 0.0);
    joined_to(scene, pair)
        .into_iter()
        .any(|body| comes_near(scene, body, flows, (at, OF_FLOW * a)))
}

/// Is another material joined to a body of a pair just below its contact?
pub fn is_layered(scene: &Scene, pair: &ContactPair, (at, a): (Vec3, f64)) -> bool {
    let elastic = |body: usize| {
        let steel = &scene.materials[body];
        (steel.youngs_modulus, steel.poissons_ratio)
    };
    let own: Vec<_> = (pair.bodies(&scene.mesh).into_iter().flatten())
        .map(elastic)
        .collect();
    joined_to(scene, pair).into_iter().any(|body| {
        !own.contains(&elastic(body)) && comes_near(scene, body, |_| true, (at, OF_LAYER * a))
    })
}

/// Does an element of a body that is one of `those` come as near to a place?
fn comes_near(
    scene: &Scene,
    body: usize,
    those: impl Fn(usize) -> bool,
    (place, near): (Vec3, f64),
) -> bool {
    let mut elements = scene.mesh.bodies[body].elements.clone();
    elements.any(|element| {
        those(element) && {
            let corners = scene.mesh.corners(element);
            distance(centre(&corners), place) <= near + 0.5 * diagonal(&corners)
        }
    })
}
