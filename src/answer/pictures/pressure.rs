//! The pressure on the carrier surface of every interface, seen along the load.

use super::patch::Patch;
use crate::answer::results::line_direction::line_frame;
use crate::answer::results::line_frame::axis_of;
use crate::answer::results::load::upright;
use crate::model::scene::Scene;
use crate::model::state::State;

/// The pressure of one interface.
#[derive(Debug, Clone, PartialEq)]
pub struct PressureMap {
    pub interface: String,
    /// The axes along the page and up it.
    pub drawn: [usize; 2],
    /// The faces that see the other side, with their images in the mirror planes.
    pub patches: Vec<Patch>,
}

/// One map for each interface that presses and is not seen edge on.
pub fn pressure_maps(scene: &Scene, state: &State) -> Vec<PressureMap> {
    let up = upright(scene);
    let map = |pair: usize| {
        let line = line_frame(scene, pair).and_then(|frame| axis_of(&frame.along));
        let along = line.unwrap_or((up + 1) % 3);
        let drawn = (along != up).then(|| [along, 3 - along - up])?;
        Some(PressureMap {
            interface: scene.contacts[pair].name.clone(),
            drawn,
            patches: patches(scene, state, pair, drawn)?,
        })
    };
    (0..scene.contacts.len()).filter_map(map).collect()
}

/// `None` where nothing presses.
fn patches(scene: &Scene, state: &State, pair: usize, drawn: [usize; 2]) -> Option<Vec<Patch>> {
    let field = state.contacts.get(pair)?;
    let node = |n: u32| field.nodes.binary_search(&n).ok();
    let mut patches = Vec::new();
    for face in &scene.carrier(pair)?.faces {
        let nodes = face.nodes.map(node);
        let sees = |i: &Option<usize>| i.is_some_and(|i| field.gap[i].is_finite());
        if !nodes.iter().any(sees) {
            continue;
        }
        let corners = face.corners(&scene.mesh).map(|p| drawn.map(|k| p[k]));
        let values = nodes.map(|i| i.map_or(0.0, |i| field.pressure[i].max(0.0)));
        patches.push(Patch {
            corners: corners.to_vec(),
            values: values.to_vec(),
        });
    }
    for (k, axis) in drawn.iter().enumerate() {
        if scene.mirrors.contains(axis) {
            let images: Vec<Patch> = patches.iter().map(|p| p.image(k)).collect();
            patches.extend(images);
        }
    }
    let presses = |p: &Patch| p.values.iter().any(|v| *v > 0.0);
    patches.iter().any(presses).then_some(patches)
}
