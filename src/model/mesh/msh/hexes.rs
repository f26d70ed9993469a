//! Checks of the hexahedra: repeated, degenerate, inverted.

use rayon::prelude::*;

use super::error::MeshError;
use super::file::File;
use crate::model::mesh::Mesh;
use crate::model::mesh::hexahedron::{Orientation, mirrored, orientation, scaled_jacobians};
use crate::model::mesh::surface::sorted;

impl File<'_> {
    /// Refuses hexahedra with a node twice, and two hexahedra of the same nodes.
    pub fn check_repeated(&self, mesh: &Mesh, origin: &[usize]) -> Result<(), MeshError> {
        let twice = |hex: &[u32; 8]| sorted(*hex).windows(2).find(|w| w[0] == w[1]).map(|w| w[0]);
        if let Some((k, node)) = mesh
            .hexes
            .iter()
            .enumerate()
            .find_map(|(k, hex)| Some((k, twice(hex)?)))
        {
            let why = format!("it has node {} twice", self.node_tag(node));
            return Err(self.degenerate(mesh, origin, k, why));
        }
        let mut keys: Vec<([u32; 8], u32)> = mesh
            .hexes
            .par_iter()
            .map(|hex| sorted(*hex))
            .zip(0..mesh.hexes.len() as u32)
            .collect();
        keys.par_sort_unstable();
        let Some((first, second)) = keys
            .windows(2)
            .find(|w| w[0].0 == w[1].0)
            .map(|w| (w[0].1 as usize, w[1].1 as usize))
        else {
            return Ok(());
        };
        let (place, element) = self.element(origin[second]);
        let (_, first_tag) = self.element(origin[first]);
        let [one, other] = [first, second].map(|k| &mesh.bodies[mesh.body_of(k)].name);
        let bodies = format!("`{one}` and `{other}`");
        Err(MeshError::RepeatedElement {
            place,
            element,
            first: first_tag,
            bodies,
        })
    }

    fn degenerate(&self, mesh: &Mesh, origin: &[usize], k: usize, why: String) -> MeshError {
        let (place, element) = self.element(origin[k]);
        let body = mesh.bodies[mesh.body_of(k)].name.clone();
        MeshError::Degenerate {
            place,
            element,
            body,
            why,
        }
    }

    /// Checks the Jacobians. A body all of whose elements are numbered for the mirror image is
    /// renumbered and noted; any other element that is not sound is refused.
    pub fn orient(&self, mesh: &mut Mesh, origin: &[usize]) -> Result<Vec<String>, MeshError> {
        let mut notes = Vec::new();
        let found: Vec<Orientation> = (0..mesh.hexes.len())
            .into_par_iter()
            .map(|k| orientation(&mesh.corners(k)))
            .collect();
        for body in &mesh.bodies {
            let range = body.elements.clone();
            let here = &found[range.clone()];
            if here.iter().all(|o| *o == Orientation::Mirrored) {
                for hex in &mut mesh.hexes[range.clone()] {
                    *hex = mirrored(*hex);
                }
                notes.push(format!(
                    "{}: the {} hexahedra of physical volume `{}` are numbered for the mirror \
                     image; their nodes were reordered",
                    self.places.source,
                    range.len(),
                    body.name
                ));
                continue;
            }
            let wrong = |o: &&Orientation| !matches!(o, Orientation::Sound | Orientation::Mirrored);
            let worst = here
                .iter()
                .position(|o| wrong(&o))
                .or_else(|| here.iter().position(|o| *o == Orientation::Mirrored));
            if let Some(k) = worst {
                return Err(self.unsound(mesh, origin, range.start + k, here[k]));
            }
        }
        Ok(notes)
    }

    fn unsound(&self, mesh: &Mesh, origin: &[usize], k: usize, found: Orientation) -> MeshError {
        let node = |corner: usize| self.node_tag(mesh.hexes[k][corner]);
        let (corner, jacobian) = match found {
            Orientation::Flat { corner, jacobian } => {
                let node = node(corner);
                let why = format!("it is flat at node {node} (scaled Jacobian {jacobian:.1e})");
                return self.degenerate(mesh, origin, k, why);
            }
            Orientation::Inverted { corner, jacobian } => (corner, jacobian),
            Orientation::Sound | Orientation::Mirrored => {
                (0, scaled_jacobians(&mesh.corners(k))[0])
            }
        };
        let (place, element) = self.element(origin[k]);
        let body = mesh.bodies[mesh.body_of(k)].name.clone();
        MeshError::Inverted {
            place,
            element,
            body,
            node: node(corner),
            jacobian,
        }
    }
}
