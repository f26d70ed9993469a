//! Physical surfaces matched to the outer faces of hexahedra.

use super::error::MeshError;
use super::file::File;
use crate::model::mesh::surface::{FaceFinder, FaceMatch};
use crate::model::mesh::{Face, Mesh, Surface};

impl File<'_> {
    /// Fills `surface` with the faces that its quadrilaterals (element of the file, nodes) are.
    pub fn match_faces(
        &self,
        mesh: &Mesh,
        finder: &FaceFinder<'_>,
        mut surface: Surface,
        quads: impl Iterator<Item = (usize, [u32; 4])>,
    ) -> Result<Surface, MeshError> {
        let mut origin: Vec<usize> = Vec::new();
        let refused = |element: usize, surface: &Surface, why: String| {
            let (place, element) = self.element(element);
            MeshError::SurfaceFace {
                place,
                element,
                surface: surface.name.clone(),
                why,
            }
        };
        for (element, nodes) in quads {
            let why = match finder.find(nodes) {
                FaceMatch::Outer(face) => {
                    surface.faces.push(face);
                    origin.push(element);
                    continue;
                }
                FaceMatch::None => {
                    let tags = nodes.map(|node| self.node_tag(node).to_string());
                    format!("is the face of no hexahedron (nodes {})", tags.join(", "))
                }
                FaceMatch::Between(one, other) => {
                    let [one, other] =
                        [one, other].map(|k| &mesh.bodies[mesh.body_of(k as usize)].name);
                    if one == other {
                        format!("lies inside physical volume `{one}`, between two hexahedra")
                    } else {
                        format!(
                            "lies between physical volumes `{one}` and `{other}`, which share its nodes"
                        )
                    }
                }
            };
            return Err(refused(element, &surface, why));
        }
        let mut order: Vec<usize> = (0..surface.faces.len()).collect();
        let key = |k: &usize| {
            let Face { nodes, element } = surface.faces[*k];
            (element, nodes, *k)
        };
        order.sort_unstable_by_key(key);
        for pair in order.windows(2) {
            if surface.faces[pair[0]] == surface.faces[pair[1]] {
                let (_, first) = self.element(origin[pair[0]]);
                let why = format!("is the same face as element {first}");
                return Err(refused(origin[pair[1]], &surface, why));
            }
        }
        Ok(surface)
    }
}
