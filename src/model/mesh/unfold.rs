//! A symmetric whole from its half.

use super::hexahedron::mirrored;
use super::{Body, Face, Hanging, Mesh, Surface};

impl Mesh {
    /// The mesh together with its mirror image across the coordinate plane of `axis`. Nodes within
    /// `tolerance` (a length) of the plane are shared, so that a body that reaches it grows
    /// together with its image; bodies and surfaces keep their names. Surfaces in the plane, which
    /// lie inside now, are dropped.
    pub fn unfolded(&self, axis: usize, tolerance: f64) -> Self {
        let mut points = self.points.clone();
        let mut images: Vec<u32> = Vec::with_capacity(points.len());
        for (node, at) in (0u32..).zip(&self.points) {
            if at[axis].abs() <= tolerance {
                images.push(node);
                continue;
            }
            images.push(points.len() as u32);
            let mut image = *at;
            image[axis] = -image[axis];
            points.push(image);
        }
        let image_of = |node: u32| images[node as usize];
        let mut whole = Self {
            source: format!("{} with its mirror image", self.source),
            points,
            ..Self::default()
        };
        let images = self.hanging.iter().map(|h| Hanging {
            node: image_of(h.node),
            corners: {
                let mut corners: Vec<u32> = h.corners.iter().map(|c| image_of(*c)).collect();
                corners.sort_unstable();
                corners
            },
        });
        whole
            .hanging
            .extend(self.hanging.iter().cloned().chain(images));
        whole.hanging.sort_by_key(|h| h.node);
        whole.hanging.dedup();
        // Where each element and its image come to stand: behind the others of their body.
        let mut numbers = vec![[0u32; 2]; self.hexes.len()];
        for body in &self.bodies {
            let start = whole.hexes.len();
            let count = body.elements.len();
            for (k, element) in body.elements.clone().enumerate() {
                numbers[element] = [(start + k) as u32, (start + count + k) as u32];
            }
            let hexes = &self.hexes[body.elements.clone()];
            whole.hexes.extend(hexes);
            let image = hexes.iter().map(|hex| mirrored(hex.map(image_of)));
            whole.hexes.extend(image);
            whole.bodies.push(Body {
                name: body.name.clone(),
                elements: start..whole.hexes.len(),
            });
        }
        let inside = |face: &Face| face.nodes.iter().all(|n| image_of(*n) == *n);
        for surface in &self.surfaces {
            let kept = || surface.faces.iter().filter(|face| !inside(face));
            let originals = kept().map(|face| Face {
                element: numbers[face.element as usize][0],
                ..*face
            });
            let images = kept().map(|face| {
                let mut nodes = face.nodes.map(image_of);
                nodes.reverse();
                let element = numbers[face.element as usize][1];
                Face { nodes, element }
            });
            let faces: Vec<Face> = originals.chain(images).collect();
            if !faces.is_empty() {
                let name = surface.name.clone();
                whole.surfaces.push(Surface { name, faces });
            }
        }
        whole
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, uniform};

    #[test]
    fn a_half_and_its_image_make_the_whole() {
        let list = |from, n| uniform(from, 1.0, n);
        let part = |name: &str| Block::new(name, list(0.0, 2), list(0.5, 1), list(0.0, 2));
        let half = Mesh::join(["a", "b"].map(|n| part(n).build().unwrap().prefixed(n))).unwrap();
        let whole = half.unfolded(0, 1e-9);
        assert_eq!((whole.points.len(), whole.hexes.len()), (60, 16));
        assert_eq!(whole.bodies[1].elements, 8..16);
        for body in whole.quality() {
            assert!(body.min_scaled_jacobian > 0.99);
        }
        assert!(whole.surface("ax_min").is_none());
        for surface in &whole.surfaces {
            for face in &surface.faces {
                let hex = &whole.hexes[face.element as usize];
                assert!(face.nodes.iter().all(|n| hex.contains(n)));
            }
        }
        let ends = whole.surface("bx_max").unwrap();
        let normals: Vec<f64> = (ends.faces.iter())
            .map(|face| face.area_vector(&whole)[0] * face.centre(&whole)[0])
            .collect();
        assert!(normals.iter().all(|n| *n > 0.0), "{normals:?}");
    }
}
