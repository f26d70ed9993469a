//! Sub-blocks welded into one body: nodes that coincide become one.

use std::collections::HashMap;

use super::join::JoinError;
use super::{Body, Mesh};

impl Mesh {
    /// The same mesh with nodes of one body that lie within `tolerance` (a length) of each other
    /// merged into the first of them. Nodes of different bodies stay apart. Nodes that no element
    /// uses afterwards are dropped.
    fn merge_nodes(mut self, tolerance: f64) -> Self {
        let mut target: Vec<u32> = (0..self.points.len() as u32).collect();
        for body in &self.bodies {
            let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
            let mut seen = vec![false; self.points.len()];
            for node in self.hexes[body.elements.clone()].iter().flatten() {
                if std::mem::replace(&mut seen[*node as usize], true) {
                    continue;
                }
                let at = self.points[*node as usize];
                // Cells twice as wide as the tolerance: a partner lies in one of 27.
                let cell = at.map(|c| (c / (2.0 * tolerance)).round() as i64);
                match partner(&self.points, &cells, cell, at, tolerance) {
                    Some(first) => target[*node as usize] = first,
                    None => cells.entry(cell).or_default().push(*node),
                }
            }
        }
        self.renumber(&target);
        self
    }

    /// Several parts as one body called `name`, coincident nodes merged. Surfaces of the parts
    /// are dropped: their faces may lie inside. [`Mesh::mark`] names new ones.
    ///
    /// # Errors
    /// [`JoinError::TooLarge`].
    pub fn weld(
        name: &str,
        parts: impl IntoIterator<Item = Mesh>,
        tolerance: f64,
    ) -> Result<Mesh, JoinError> {
        let parts = parts.into_iter().enumerate().map(|(k, mut part)| {
            part.surfaces.clear();
            part.prefixed(&format!("{k}_"))
        });
        let mut mesh = Mesh::join(parts)?;
        mesh.bodies = vec![Body {
            name: name.into(),
            elements: 0..mesh.hexes.len(),
        }];
        Ok(mesh.merge_nodes(tolerance))
    }

    /// Names the outer faces of body `body` whose four corners `here` accepts: surface `name`,
    /// extended where it exists.
    pub fn mark(&mut self, name: &str, body: &str, here: impl Fn([f64; 3]) -> bool) {
        let Some(body) = self.body(body) else { return };
        let mut faces = self.outer_faces(body);
        faces.retain(|face| face.corners(self).into_iter().all(&here));
        match self.surfaces.iter_mut().find(|s| s.name == name) {
            Some(surface) => surface.faces.extend(faces),
            None => self.surfaces.push(super::Surface {
                name: name.into(),
                faces,
            }),
        }
    }

    /// The same of all bodies.
    pub fn mark_all(&mut self, name: &str, here: impl Fn([f64; 3]) -> bool) {
        let bodies: Vec<String> = self.bodies.iter().map(|body| body.name.clone()).collect();
        bodies.iter().for_each(|body| self.mark(name, body, &here));
    }

    /// The mirror image along `axis`, elements numbered so that they stay sound.
    pub fn mirrored(mut self, axis: usize) -> Self {
        for point in &mut self.points {
            point[axis] = -point[axis];
        }
        for hex in &mut self.hexes {
            *hex = super::hexahedron::mirrored(*hex);
        }
        for face in self.surfaces.iter_mut().flat_map(|s| &mut s.faces) {
            face.nodes.reverse();
        }
        self
    }

    fn renumber(&mut self, target: &[u32]) {
        let mut used = vec![false; target.len()];
        for node in self.hexes.iter().flatten() {
            used[target[*node as usize] as usize] = true;
        }
        let mut number = vec![u32::MAX; target.len()];
        let mut points = Vec::new();
        for (node, used) in used.into_iter().enumerate() {
            if used {
                number[node] = points.len() as u32;
                points.push(self.points[node]);
            }
        }
        self.points = points;
        let new = |n: u32| number[target[n as usize] as usize];
        for hex in &mut self.hexes {
            *hex = hex.map(new);
        }
        for face in self.surfaces.iter_mut().flat_map(|s| &mut s.faces) {
            face.nodes = face.nodes.map(new);
        }
    }
}

/// A node kept so far within `tolerance` of `at`, the one with the lowest index.
fn partner(
    points: &[[f64; 3]],
    cells: &HashMap<[i64; 3], Vec<u32>>,
    [x, y, z]: [i64; 3],
    at: [f64; 3],
    tolerance: f64,
) -> Option<u32> {
    let near = |node: &&u32| {
        let p = points[**node as usize];
        (0..3).map(|i| (p[i] - at[i]).powi(2)).sum::<f64>() <= tolerance * tolerance
    };
    let around =
        (0..27).filter_map(|k| cells.get(&[x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]));
    around.flatten().filter(near).min().copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, uniform};

    fn cube(from: f64) -> Mesh {
        let list = || uniform(0.0, 1.0, 2);
        let x = uniform(from, from + 1.0, 2);
        Block::new("cube", x, list(), list()).build().unwrap()
    }

    #[test]
    fn welded_cubes_share_the_nodes_between_them() {
        let mut mesh = Mesh::weld("bar", [cube(0.0), cube(1.0 + 1e-12)], 1e-9).unwrap();
        assert_eq!((mesh.points.len(), mesh.hexes.len()), (45, 16));
        assert_eq!(mesh.outer_faces(0).len(), 40);
        mesh.mark("end", "bar", |p| p[0] > 1.99);
        assert_eq!(mesh.surface("end").map(|s| s.faces.len()), Some(4));
    }

    #[test]
    fn bodies_that_touch_stay_apart() {
        let parts = [cube(0.0).prefixed("a"), cube(1.0).prefixed("b")];
        let mesh = Mesh::join(parts).unwrap().merge_nodes(1e-9);
        assert_eq!(mesh.points.len(), 54);
    }

    #[test]
    fn a_mirror_image_is_sound_and_its_faces_point_outward() {
        let mesh = cube(1.0).mirrored(0);
        assert_eq!(mesh.quality()[0].elements, 8);
        assert!(mesh.quality()[0].min_scaled_jacobian > 0.99);
        let face = mesh.surface("x_max").unwrap().faces[0];
        assert!(face.area_vector(&mesh)[0] < 0.0);
    }
}
