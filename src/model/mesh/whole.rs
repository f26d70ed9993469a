//! Is a mesh whole? For meshes that are made or changed in code; files are asked when they are read.

use super::hexahedron::{Orientation, orientation};
use super::surface::{FaceFinder, FaceMatch, sorted};
use super::{Face, Mesh, Surface};
use std::collections::BTreeSet;

impl Mesh {
    /// What is wrong with it; `None` where every index leads somewhere, bodies cover the elements one after the other, every
    /// element is sound, and every face of a surface is one of its element that lies outside, once.
    pub fn fault(&self) -> Option<String> {
        let finite = |point: &[f64; 3]| point.iter().all(|x| x.is_finite());
        if let Some(node) = self.points.iter().position(|point| !finite(point)) {
            return Some(format!("node {node} is at {:?}", self.points[node]));
        }
        let lost = |nodes: &[u32]| nodes.iter().any(|node| *node as usize >= self.points.len());
        let count = self.points.len();
        if let Some(element) = self.hexes.iter().position(|hex| lost(hex)) {
            return Some(format!(
                "element {element} has a node that is none of the {count}"
            ));
        }
        let hangs = |hanging: &&super::Hanging| lost(&hanging.corners) || lost(&[hanging.node]);
        if let Some(hanging) = self.hanging.iter().find(hangs) {
            let node = hanging.node;
            return Some(format!(
                "hanging node {node}: it or a corner is none of the {count} nodes"
            ));
        }
        self.fault_of_bodies().or_else(|| self.fault_of_surfaces())
    }

    fn fault_of_bodies(&self) -> Option<String> {
        let mut next = 0;
        for body in &self.bodies {
            let (name, elements) = (&body.name, body.elements.clone());
            if elements.start != next || elements.end < next || elements.end > self.hexes.len() {
                return Some(format!(
                    "body `{name}` has the elements {elements:?} of {}: bodies stand one after the other",
                    self.hexes.len()
                ));
            }
            next = elements.end;
            let is_sound =
                |element: &usize| orientation(&self.corners(*element)) == Orientation::Sound;
            if let Some(element) = elements.into_iter().find(|element| !is_sound(element)) {
                return Some(format!(
                    "element {element} of body `{name}` is flat or inside out"
                ));
            }
        }
        (next < self.hexes.len()).then(|| format!("the elements from {next} on are of no body"))
    }

    fn fault_of_surfaces(&self) -> Option<String> {
        let finder = FaceFinder::new(&self.hexes, self.points.len());
        let of_surface = |surface: &Surface| {
            let name = &surface.name;
            let mut seen = BTreeSet::new();
            let wrong = |face: &&Face| {
                let is_there = face
                    .nodes
                    .iter()
                    .all(|node| (*node as usize) < self.points.len());
                let is_outer = is_there
                    && matches!(finder.find(face.nodes), FaceMatch::Outer(found) if found.element == face.element);
                !is_outer || !seen.insert(sorted(face.nodes))
            };
            let face = surface.faces.iter().find(wrong)?;
            Some(format!(
                "surface `{name}`: the face {:?} of element {} is none of its outer faces, or is there twice",
                face.nodes, face.element
            ))
        };
        self.surfaces.iter().find_map(of_surface)
    }
}

#[cfg(test)]
mod tests {
    use crate::model::mesh::Mesh;
    use crate::model::mesh::block::{Block, uniform};

    #[test]
    fn every_fault_is_told() {
        let side = || uniform(0.0, 1.0, 2);
        let mesh = Block::new("a", side(), side(), side()).build().unwrap();
        assert_eq!(mesh.fault(), None);
        let told = |change: fn(&mut Mesh), words: &str| {
            let mut mesh = mesh.clone();
            change(&mut mesh);
            let fault = mesh.fault().unwrap_or_default();
            assert!(fault.contains(words), "{words}: {fault}");
        };
        told(|m| m.points[3][1] = f64::NAN, "node 3 is at");
        told(|m| m.hexes[0][0] = 9999, "element 0 has a node");
        told(
            |m| m.bodies[0].elements = 0..99,
            "body `a` has the elements",
        );
        told(|m| m.bodies[0].elements = 0..4, "the elements from 4 on");
        told(|m| m.hexes[5].rotate_left(4), "element 5 of body `a`");
        told(|m| m.surfaces[0].faces[0].element = 7, "surface `z_min`");
        told(|m| m.surfaces[0].faces[0].element = 999, "surface `z_min`");
        told(
            |m| m.surfaces[0].faces[0].nodes[0] = 9999,
            "surface `z_min`",
        );
        told(
            |m| {
                let face = m.surfaces[0].faces[0];
                m.surfaces[0].faces.push(face);
            },
            "or is there twice",
        );
    }
}
