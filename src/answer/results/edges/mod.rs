//! Singular edges, where elastic stresses have no bound: a peak beside one grows with every refinement until plasticity
//! bounds it. They are where a contact surface ends under pressure ([`LoadedEdges`]), and where a body has one by its
//! shape, by what holds it or by what it is joined to (`wedges`).

mod boundary;
mod loaded;
mod reach;
mod wedges;

pub use boundary::boundary;
pub use loaded::{EVEN, LoadedEdges};

use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use crate::model::state::State;
use reach::EdgeNodes;

/// How an edge decides the largest stress of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ByEdge {
    /// It is beside the edge, or at a fillet that the mesh does not resolve.
    Here,
    /// It is elsewhere, but a finer mesh may show a larger one at the edge.
    OnFinerMeshes,
}

/// The singular edges of a solved scene.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SingularEdges {
    /// Of contact surfaces.
    pub loaded: LoadedEdges,
    of_bodies: EdgeNodes,
}

impl SingularEdges {
    /// Finds them all.
    pub fn find(scene: &Scene, state: &State) -> Self {
        Self {
            loaded: LoadedEdges::find(scene, state),
            of_bodies: wedges::singular(scene),
        }
    }

    /// Is a point so near to one that its stress belongs to the edge?
    ///
    /// A loaded edge may be that of the other body: its end presses a singularity into this one too.
    pub fn are_near(&self, at: &[f64; 3]) -> bool {
        self.loaded.are_near(at) || self.of_bodies.are_near(at)
    }

    /// Does one cease to reach just there? Meshes of the templates have nodes at such places.
    pub fn end_at(&self, at: &[f64; 3]) -> bool {
        self.loaded.end_at(at) || self.of_bodies.end_at(at)
    }

    /// Is a point so near to one whose faces are longer than its stress reaches that it belongs to these?
    pub fn are_coarsely_near(&self, at: &[f64; 3]) -> bool {
        self.loaded.are_coarsely_near(at) || self.of_bodies.are_coarsely_near(at)
    }

    /// Does a nodal peak of the Mises stress of the body with that index, its value and its place, belong to an edge?
    pub fn decide(&self, scene: &Scene, body: usize, (mises, at): (f64, &Vec3)) -> Option<ByEdge> {
        if self.are_near(at) || self.loaded.unseen_mises(scene, body) > mises {
            return Some(ByEdge::Here);
        }
        self.loaded.press(body).then_some(ByEdge::OnFinerMeshes)
    }
}
