//! Which of the states of a solution the figures are of, and which is the unloaded one.

use super::load::whole;
use crate::ground::geometry::{add, norm};
use crate::model::scene::{Scene, UNLOADED_SHARE};
use crate::model::state::State;

/// What a history of steps ends in.
#[derive(Debug, Clone, Copy)]
pub struct Ending<'s> {
    /// The end of the last step; where the last steps unload, the end of the step before them.
    pub reported: &'s State,
    /// The end of the last step where the load has been taken off.
    pub unloaded: Option<&'s State>,
}

/// The ending of `scene`, from the states at the ends of the steps that are done and the last state of
/// all, which is within a step where the solution was stopped.
pub fn ending<'s>(scene: &Scene, ended: &'s [State], last: &'s State) -> Ending<'s> {
    let loaded = scene.before_unloading();
    let Some((step, reported)) = loaded.and_then(|step| Some((step, ended.get(step)?))) else {
        return Ending {
            reported: last,
            unloaded: None,
        };
    };
    if ended.len() < scene.steps.len() {
        return Ending {
            reported,
            unloaded: None,
        };
    }
    // Forces are known to be off; what goes back a prescribed way may still press, and between supports alone nobody asked how much.
    let off = pressing(scene, last) < UNLOADED_SHARE * pressing(scene, reported);
    if scene.is_moved_in(step) && !off {
        return Ending {
            reported: last,
            unloaded: None,
        };
    }
    Ending {
        reported,
        unloaded: Some(last),
    }
}

/// Sum of the sizes of the forces at the interfaces; without any, of those on the rigid planes.
fn pressing(scene: &Scene, state: &State) -> f64 {
    let size = |force: [f64; 3]| norm(whole(scene, force));
    let pairs =
        (state.contacts.iter()).map(|field| field.force.iter().fold([0.0; 3], |s, f| add(s, *f)));
    match state.contacts.is_empty() {
        true => state.planes.iter().map(|plane| size(plane.force)).sum(),
        false => pairs.map(size).sum(),
    }
}
