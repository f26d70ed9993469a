//! What holds a model in its planes of symmetry.

use std::collections::BTreeSet;

use super::{Scene, Support};
use crate::ground::geometry::AXES;
use crate::model::mesh::{Face, Mesh, Surface};

/// Share of the size of a mesh by which nodes may be off a plane of symmetry and yet lie in it: files have rounded coordinates.
pub const OFF_PLANE: f64 = 1e-6;

impl Scene {
    /// Puts the nodes that lie in the planes of symmetry there, and holds the outer faces in these square to them, where supports do
    /// not do so already: the image of a body goes on behind them.
    pub fn hold_mirrors(&mut self) {
        for axis in self.mirrors.clone() {
            let near = OFF_PLANE * self.mesh.extent(axis);
            let in_plane = (self.mesh.points.iter_mut()).filter(|at| at[axis].abs() <= near);
            in_plane.for_each(|at| at[axis] = 0.0);
            let faces = self.loose_faces(axis);
            if faces.is_empty() {
                continue;
            }
            let mut name = format!("{}_mirror", AXES[axis]);
            while self.mesh.surface(&name).is_some() {
                name.push('_');
            }
            let mut components = [None; 3];
            components[axis] = Some(0.0);
            self.supports.push(Support {
                name: name.clone(),
                surface: name.clone(),
                components,
                ..Support::default()
            });
            self.mesh.surfaces.push(Surface { name, faces });
        }
    }

    /// Outer faces in the plane of symmetry across `axis` with a node that no support holds along it.
    fn loose_faces(&self, axis: usize) -> Vec<Face> {
        let holds = |support: &&Support| support.components[axis].is_some();
        let held: BTreeSet<u32> = (self.supports.iter().filter(holds))
            .flat_map(|support| self.mesh.nodes_of_surface(&support.surface))
            .collect();
        let mut faces = faces_in_plane(&self.mesh, axis);
        faces.retain(|face| face.nodes.iter().any(|node| !held.contains(node)));
        faces
    }
}

/// The outer faces of all bodies in the coordinate plane across `axis`.
pub fn faces_in_plane(mesh: &Mesh, axis: usize) -> Vec<Face> {
    let in_plane = in_plane(mesh, axis);
    (0..mesh.bodies.len())
        .flat_map(|body| mesh.outer_faces(body))
        .filter(|face| in_plane(face))
        .collect()
}

/// Has a surface faces in the coordinate plane across `axis`? Of a model that is mirrored there they are inside the whole.
pub fn reaches_into_plane(mesh: &Mesh, surface: &str, axis: usize) -> bool {
    let mut faces = mesh.surface(surface).into_iter().flat_map(|s| &s.faces);
    faces.any(in_plane(mesh, axis))
}

/// Does a face lie in the coordinate plane across `axis`? How far off is still in it is asked of all of the mesh, once.
fn in_plane(mesh: &Mesh, axis: usize) -> impl Fn(&Face) -> bool {
    let near = OFF_PLANE * mesh.extent(axis);
    let off = move |node: &u32| mesh.points[*node as usize][axis].abs();
    move |face| face.nodes.iter().all(|node| off(node) <= near)
}
