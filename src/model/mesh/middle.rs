//! Middles of surfaces and bodies.

use super::Mesh;
use crate::ground::geometry::{Vec3, bounds};

impl Mesh {
    /// Middle of the box around a surface, with its image across each coordinate plane of `mirrors` that it reaches; the
    /// origin where there is no such surface.
    pub fn middle_of(&self, surface: &str, mirrors: &[usize]) -> Vec3 {
        self.middle(self.nodes_of_surface(surface).into_iter(), mirrors)
    }

    /// The same of the body with the index `body`.
    pub fn middle_of_body(&self, body: usize, mirrors: &[usize]) -> Vec3 {
        let elements = self
            .bodies
            .get(body)
            .map(|b| &self.hexes[b.elements.clone()]);
        let nodes = elements.into_iter().flatten().flatten();
        self.middle(nodes.copied(), mirrors)
    }

    fn middle(&self, nodes: impl Iterator<Item = u32>, mirrors: &[usize]) -> Vec3 {
        let [low, high] = bounds(nodes.map(|node| self.points[node as usize]));
        // What does not reach a mirror plane has an image of its own.
        let reaches = |axis: usize| {
            let near = 1e-6 * (high[axis] - low[axis]);
            mirrors.contains(&axis) && low[axis] <= near && high[axis] >= -near
        };
        std::array::from_fn(|axis| match reaches(axis) || low[axis] > high[axis] {
            true => 0.0,
            false => 0.5 * (low[axis] + high[axis]),
        })
    }
}
