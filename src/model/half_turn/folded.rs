//! A scene that is its own image, and its half.

use crate::model::scene::Scene;

/// A scene that is its own image, folded.
#[derive(Debug, Clone)]
pub struct HalfTurn {
    /// The half that is solved. Its [`Scene::half_turn`] has the nodes of the cut.
    pub half: Scene,
    /// Number in the half of each node of the whole, or of its image, which comes with `true`.
    pub(super) nodes: Vec<(u32, bool)>,
    /// The same of each element; of an image the corner of the half's element that each of its corners is.
    pub(super) elements: Vec<(u32, Option<[u8; 8]>)>,
    /// Node of the whole of each node of the half.
    pub(super) whole_nodes: Vec<u32>,
    /// Element of the whole of each element of the half.
    pub(super) whole_elements: Vec<u32>,
    /// Contact pair of the half that each pair of the whole is or, with `true`, is the image of.
    pub(super) pairs: Vec<(usize, bool)>,
    /// Carrier nodes of each pair of the whole, ascending.
    pub(super) carriers: Vec<Vec<u32>>,
    /// Height of the mid-plane.
    pub(super) middle: f64,
}
