//! What the states at the ends of steps take, which a solution keeps to its end.

use crate::model::scene::Scene;
use crate::solver::solve::recovery::contact_fields::carrier_nodes;

/// Bytes of a node in a state,
const NODE: f64 = 24.0;
/// of an element,
const ELEMENT: f64 = 448.0;
/// and of a node in a contact field.
const CONTACT_NODE: f64 = 149.0;

/// Bytes of the ends of all steps but one, which what a model takes is reckoned with. Each pair has a field on all of its
/// carrier: many pairs on one surface and many steps come to more than the model.
pub fn memory_of_states(scene: &Scene) -> f64 {
    let pairs = scene.contacts.iter();
    let fields: usize = pairs.map(|pair| carrier_nodes(scene, pair).len()).sum();
    let state = NODE * scene.mesh.points.len() as f64
        + ELEMENT * scene.mesh.hexes.len() as f64
        + CONTACT_NODE * fields as f64;
    scene.steps.len().saturating_sub(1) as f64 * state
}
