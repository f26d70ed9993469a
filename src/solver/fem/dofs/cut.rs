//! The cut of a scene that is folded by a half turn.

use super::fixed::FIXED;
use super::owner::Owner;
use crate::model::scene::Scene;

/// What the half turn does to the components of the nodes of its cut.
pub(super) struct Cut {
    /// Image of each node of the cut that has equations of its own; [`FIXED`] of all other nodes.
    image: Vec<u32>,
    /// Is the node such an image?
    pub turned: Vec<bool>,
    /// Components of the nodes of the cut that supports hold, on either side.
    held: Vec<[bool; 3]>,
}

impl Cut {
    pub fn new(scene: &Scene, owner: &[[Option<Owner>; 3]]) -> Self {
        let nodes = if scene.half_turn.is_empty() {
            0
        } else {
            owner.len()
        };
        let mut cut = Self {
            image: vec![FIXED; nodes],
            turned: vec![false; nodes],
            held: vec![[false; 3]; nodes],
        };
        for [node, image] in scene.half_turn.iter().map(|pair| pair.map(|n| n as usize)) {
            cut.image[node] = image as u32;
            cut.turned[image] = node != image;
            let [own, other] = [node, image].map(|n| owner[n].map(|o| o.is_some()));
            cut.held[node] = [own[0] || other[1], own[1] || other[0], own[2] || other[2]];
        }
        cut
    }

    pub fn on_axis(&self, node: usize) -> bool {
        self.image
            .get(node)
            .is_some_and(|image| *image as usize == node)
    }

    /// Has the component no equation of its own, as the half turn holds it or its image has one?
    pub fn decides(&self, node: usize, axis: usize) -> bool {
        match self.turned.get(node) {
            Some(true) => true,
            Some(false) => self.held[node][axis] || (self.on_axis(node) && axis > 0),
            None => false,
        }
    }
}
