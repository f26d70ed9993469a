//! The outer faces of bodies, and what holds them.

use std::collections::{BTreeMap, BTreeSet};

use crate::ground::geometry::{Vec3, unit};
use crate::model::mesh::Face;
use crate::model::mesh::surface::sorted;
use crate::model::scene::{PlaneMotion, Scene};

/// What a face of a body may do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// What it wants.
    Free,
    /// Along itself it does not move, or as a rigid plane does.
    Held,
    /// It slides along itself, as on a mirror plane.
    Slides,
    /// The material of another body goes on behind it.
    Joined,
    /// On the cut of a half turn: the body goes on, turned.
    Cut,
}

/// The outer faces of all bodies, and what they may do.
pub struct OuterFaces<'s> {
    scene: &'s Scene,
    /// Of each body, in the order of its elements.
    pub by_body: Vec<Vec<Face>>,
    /// Axes along which faces are held, by their nodes, ascending.
    held: BTreeMap<[u32; 4], [bool; 3]>,
    joined: BTreeSet<[u32; 4]>,
    cut: BTreeSet<u32>,
}

impl<'s> OuterFaces<'s> {
    /// Those of a scene.
    pub fn of(scene: &'s Scene) -> Self {
        let mesh = &scene.mesh;
        let by_body: Vec<Vec<Face>> = (0..mesh.bodies.len())
            .map(|body| mesh.outer_faces(body))
            .collect();
        let mut held: BTreeMap<[u32; 4], [bool; 3]> = BTreeMap::new();
        let mut hold = |surface: &str, axes: [bool; 3]| {
            for face in mesh.surface(surface).iter().flat_map(|s| &s.faces) {
                let known = held.entry(sorted(face.nodes)).or_default();
                (0..3).for_each(|k| known[k] |= axes[k]);
            }
        };
        for support in &scene.supports {
            hold(&support.surface, support.components.map(|c| c.is_some()));
        }
        for plane in &scene.rigid_planes {
            hold(&plane.surface, plane.motion.map(|m| m != PlaneMotion::Free));
        }
        let mut joined = BTreeSet::new();
        for surface in scene.ties.iter().filter_map(|tie| tie.of(mesh)).flatten() {
            joined.extend(surface.faces.iter().map(|face| sorted(face.nodes)));
        }
        // Faces of two bodies that share their nodes.
        let mut seen = BTreeSet::new();
        for face in by_body.iter().flatten() {
            let nodes = sorted(face.nodes);
            if !seen.insert(nodes) {
                joined.insert(nodes);
            }
        }
        Self {
            scene,
            by_body,
            held,
            joined,
            cut: scene.half_turn.iter().map(|[node, _]| *node).collect(),
        }
    }

    /// What a face may do.
    pub fn bound(&self, face: &Face) -> Bound {
        let mesh = &self.scene.mesh;
        /// Sine of the angle by which a held direction may be off the normal of a face that slides.
        const OFF: f64 = 0.05;
        let nodes = sorted(face.nodes);
        if self.joined.contains(&nodes) {
            return Bound::Joined;
        }
        if nodes.iter().all(|node| self.cut.contains(node)) {
            return Bound::Cut;
        }
        let mut axes = self.held.get(&nodes).copied().unwrap_or_default();
        for axis in self.scene.mirrors.iter().copied().filter(|axis| *axis < 3) {
            let on = |at: &Vec3| self.scene.mirrors_through(at).any(|found| found == axis);
            axes[axis] |= face.corners(mesh).iter().all(on);
        }
        let Some(normal) = unit(face.area_vector(mesh)) else {
            return Bound::Free;
        };
        let along = |axis: usize| (1.0 - normal[axis] * normal[axis]).max(0.0).sqrt();
        match (0..3)
            .filter(|axis| axes[*axis])
            .map(along)
            .reduce(f64::max)
        {
            None => Bound::Free,
            Some(off) if off <= OFF => Bound::Slides,
            Some(_) => Bound::Held,
        }
    }
}
