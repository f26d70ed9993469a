//! The image of each body, node and element of a mesh under the half turn.

use super::reason::NoHalfTurn;
use super::turn::turned_point;
use crate::ground::geometry::{Vec3, bounds, norm, sub};
use crate::model::material::Steel;
use crate::model::mesh::surface::sorted;
use crate::model::mesh::{Body, Face, Mesh, Surface};
use rstar::RTree;
use rstar::primitives::GeomWithData;
use std::collections::HashMap;

/// How far a node may be from the image of another, of the size of the model: bodies are moved into touch to a hundredth
/// of it, and files have ten digits.
const SAME_PLACE: f64 = 1e-8;

/// Images under the half turn.
pub struct Images {
    /// Height of the axis.
    pub middle: f64,
    pub bodies: Vec<usize>,
    pub nodes: Vec<u32>,
    pub elements: Vec<u32>,
}

/// The height about which the nodes of `mesh` could be turned: the middle of their extent along z.
fn plane_of_the_turn(mesh: &Mesh) -> f64 {
    let [low, high] = mesh.range_along(2);
    0.5 * (low + high)
}

impl Images {
    /// Finds them.
    ///
    /// # Errors
    /// [`NoHalfTurn`] names the first body that has none.
    pub fn of(mesh: &Mesh, steels: &[Steel]) -> Result<Self, NoHalfTurn> {
        let middle = plane_of_the_turn(mesh);
        let box_of = |body: &Body| {
            let nodes = mesh.hexes[body.elements.clone()].iter().flatten();
            bounds(nodes.map(|node| mesh.points[*node as usize]))
        };
        let boxes: Vec<[Vec3; 2]> = mesh.bodies.iter().map(box_of).collect();
        let size = boxes.iter().map(|[low, high]| norm(sub(*high, *low)));
        let near = SAME_PLACE * size.fold(0.0, f64::max);
        let mut images = Self {
            middle,
            bodies: Vec::new(),
            nodes: vec![u32::MAX; mesh.points.len()],
            elements: vec![u32::MAX; mesh.hexes.len()],
        };
        for (index, body) in mesh.bodies.iter().enumerate() {
            let alike = |other: &usize| {
                let ends = boxes[*other].map(|p| turned_point(p, middle));
                let [low, high] = boxes[index];
                let ends = [
                    [ends[0][0], ends[0][1], ends[1][2]],
                    [ends[1][0], ends[1][1], ends[0][2]],
                ];
                norm(sub(low, ends[0])) < near
                    && norm(sub(high, ends[1])) < near
                    && steels.get(*other) == steels.get(index)
                    && mesh.bodies[*other].elements.len() == body.elements.len()
            };
            let found = (0..mesh.bodies.len()).find(alike);
            let image = found.ok_or_else(|| NoHalfTurn::Body {
                body: body.name.clone(),
            })?;
            images.bodies.push(image);
        }
        for (index, body) in mesh.bodies.iter().enumerate() {
            images
                .pair_nodes(mesh, (index, images.bodies[index]), near)
                .and_then(|()| images.pair_elements(mesh, (index, images.bodies[index])))
                .ok_or_else(|| NoHalfTurn::Mesh {
                    body: body.name.clone(),
                })?;
        }
        let back = |(n, image): (usize, &u32)| {
            *image == u32::MAX || images.nodes.get(*image as usize) == Some(&(n as u32))
        };
        let twice = images.nodes.iter().enumerate().all(back);
        let mutual = (0..)
            .zip(&images.bodies)
            .all(|(b, i)| images.bodies[*i] == b);
        match mesh.bodies.first().filter(|_| !(twice && mutual)) {
            Some(body) => Err(NoHalfTurn::Mesh {
                body: body.name.clone(),
            }),
            None => Ok(images),
        }
    }

    /// `None` where a node of the first body has no image in the second one.
    fn pair_nodes(&mut self, mesh: &Mesh, (body, image): (usize, usize), near: f64) -> Option<()> {
        let places = mesh.nodes_of_body(image).into_iter();
        let places = places.map(|node| GeomWithData::new(mesh.points[node as usize], node));
        let tree = RTree::bulk_load(places.collect());
        for node in mesh.nodes_of_body(body) {
            let at = turned_point(mesh.points[node as usize], self.middle);
            let found = tree.nearest_neighbor(at)?;
            let own = &mut self.nodes[node as usize];
            // A node of two bodies has one image.
            if norm(sub(*found.geom(), at)) > near || (*own != u32::MAX && *own != found.data) {
                return None;
            }
            *own = found.data;
        }
        Some(())
    }

    fn pair_elements(&mut self, mesh: &Mesh, (body, image): (usize, usize)) -> Option<()> {
        let elements = mesh.bodies[image].elements.clone();
        let known: HashMap<[u32; 8], u32> = elements
            .map(|e| (sorted(mesh.hexes[e]), e as u32))
            .collect();
        for element in mesh.bodies[body].elements.clone() {
            let nodes = mesh.hexes[element].map(|n| self.nodes[n as usize]);
            self.elements[element] = *known.get(&sorted(nodes))?;
        }
        Some(())
    }

    /// The faces of a surface, turned: element and ascending nodes of each, ascending.
    pub fn faces(&self, surface: &Surface) -> Vec<(u32, [u32; 4])> {
        in_order(surface.faces.iter().map(|face| Face {
            nodes: face.nodes.map(|n| self.nodes[n as usize]),
            element: self.elements[face.element as usize],
        }))
    }

    /// Is `other` the image of `surface`?
    pub fn are_images(&self, surface: &Surface, other: &Surface) -> bool {
        surface.faces.len() == other.faces.len()
            && self.faces(surface) == in_order(other.faces.iter().copied())
    }
}

fn in_order(faces: impl Iterator<Item = Face>) -> Vec<(u32, [u32; 4])> {
    let mut faces: Vec<_> = faces.map(|face| face.key()).collect();
    faces.sort_unstable();
    faces
}
