//! Nodes, elements, node sets, and faces by the number that decks give them.

use super::deck::Deck;
use super::format::{list, number};
use crate::model::mesh::surface::faces_of;
use crate::model::mesh::{Face, Mesh};
use std::io::{self, Write};

impl Deck<'_> {
    pub(super) fn mesh(&self, out: &mut dyn Write) -> io::Result<()> {
        let mesh = &self.scene.mesh;
        writeln!(out, "*NODE,NSET=NALL")?;
        for (node, point) in mesh.points.iter().enumerate() {
            let [x, y, z] = point.map(number);
            writeln!(out, "{},{x},{y},{z}", node + 1)?;
        }
        for (index, body) in mesh.bodies.iter().enumerate() {
            let name = self.names.body(index);
            writeln!(out, "*ELEMENT,TYPE={},ELSET={name}", self.element())?;
            for element in body.elements.clone() {
                let nodes = mesh.hexes[element].map(|n| (n + 1).to_string());
                writeln!(out, "{},{}", element + 1, nodes.join(","))?;
            }
        }
        writeln!(out, "*ELSET,ELSET=EALL")?;
        for body in 0..mesh.bodies.len() {
            writeln!(out, "{}", self.names.body(body))?;
        }
        for (index, surface) in mesh.surfaces.iter().enumerate() {
            writeln!(out, "*NSET,NSET={}", self.names.surface(index))?;
            list(out, surface.nodes().iter().map(|n| *n as usize + 1))?;
        }
        Ok(())
    }
}

/// Number of a face of its element, from 1: corners 1-2-3-4, 5-8-7-6, 1-2-6-5, 2-3-7-6, 3-4-8-7,
/// 4-1-5-8.
pub(super) fn face_number(mesh: &Mesh, face: &Face) -> usize {
    let sorted = |mut nodes: [u32; 4]| {
        nodes.sort_unstable();
        nodes
    };
    let wanted = sorted(face.nodes);
    let faces = faces_of(&mesh.hexes[face.element as usize]);
    // A surface of a mesh is made of faces of its elements.
    faces
        .iter()
        .position(|f| sorted(*f) == wanted)
        .map_or(0, |i| i + 1)
}
