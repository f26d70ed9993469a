//! The ties of a deck.

use super::error::InpError;
use crate::model::scene::Scene;
use crate::render::inp::{DeckTie, Names};
use crate::solver::solve::joints;

/// The ties of the scene, the side that follows as slave.
pub fn ties(scene: &Scene, names: &mut Names) -> Result<Vec<DeckTie>, InpError> {
    let joints = joints(scene).map_err(|error| InpError::Tie {
        why: error.to_string(),
    })?;
    let both = scene.ties.iter().zip(joints);
    let of = both.map(|(tie, joint)| {
        let order = [joint.follows, 1 - joint.follows];
        let faces = order.map(|side| {
            let surface = scene.mesh.surface(&tie.surfaces[side]);
            surface.map(|s| s.faces.clone()).unwrap_or_default()
        });
        DeckTie {
            name: names.unused(&tie.name),
            sides: ["slave", "master"].map(|side| names.unused(&format!("{}_{side}", tie.name))),
            faces,
            tolerance: joint.tolerance,
        }
    });
    Ok(of.collect())
}
