//! A state without what follows from the rest of it.

use crate::model::scene::Scene;
use crate::model::state::State;
use crate::solver::solve::checkpoint::packed::Packed;
use crate::solver::solve::checkpoint::plastic::Plastic;
use serde::{Deserialize, Serialize};

/// A state without its stresses, plastic strains and contact fields, and what these follow from.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::solver::solve) struct Kept {
    pub state: State,
    /// One field a contact pair, in the order of the scene.
    pub contacts: Vec<Packed>,
    pub plastic: Plastic,
}

impl Kept {
    pub fn new(state: &State, plastic: Plastic) -> Self {
        Self {
            state: State {
                step: state.step,
                time: state.time,
                displacement: state.displacement.clone(),
                stress: Vec::new(),
                peeq: Vec::new(),
                contacts: Vec::new(),
                ties: state.ties.clone(),
                planes: state.planes.clone(),
                energy: state.energy,
            },
            contacts: state.contacts.iter().map(Packed::new).collect(),
            plastic,
        }
    }

    pub fn check(&self, scene: &Scene) -> Result<(), Stranger> {
        let state = &self.state;
        let element = |(e, _): &(u32, _)| (*e as usize) < scene.mesh.hexes.len();
        let fit = [
            (state.step < scene.steps.len(), "a step"),
            (
                state.displacement.len() == scene.mesh.points.len(),
                "a number of nodes",
            ),
            (
                self.contacts.len() == scene.contacts.len(),
                "a number of contact pairs",
            ),
            (
                state.planes.len() == scene.rigid_planes.len(),
                "a number of rigid planes",
            ),
            (self.plastic.iter().all(element), "elements"),
        ];
        match fit.into_iter().find(|(fits, _)| !fits) {
            Some((_, what)) => Err(Stranger { what }),
            None => Ok(()),
        }
    }
}

/// Why a restart does not belong to a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the increment to go on from has {what} that the scene does not have")]
pub struct Stranger {
    pub(in crate::solver::solve) what: &'static str,
}
