//! Meshes put together from parts.

use miette::Diagnostic;
use thiserror::Error;

use super::{Hanging, Mesh};

/// Why parts do not make one mesh.
#[derive(Debug, Error, Diagnostic, PartialEq, Eq)]
pub enum JoinError {
    /// Two bodies or surfaces have one name.
    #[error("two {what} are called `{name}`")]
    #[diagnostic(
        code(brinell::mesh::join_names),
        help("give the parts different names, for example with `Mesh::prefixed`")
    )]
    SameName {
        /// What is meant, in words.
        what: &'static str,
        /// Its name.
        name: String,
    },
    /// There are too many nodes or elements.
    #[error("{count} nodes or elements are too many for one mesh")]
    #[diagnostic(code(brinell::mesh::join_size), help("use coarser parts"))]
    TooLarge {
        /// How many.
        count: usize,
    },
}

impl Mesh {
    /// The same mesh with `prefix` before the names of its bodies and surfaces.
    pub fn prefixed(mut self, prefix: &str) -> Self {
        let bodies = self.bodies.iter_mut().map(|b| &mut b.name);
        for name in bodies.chain(self.surfaces.iter_mut().map(|s| &mut s.name)) {
            name.insert_str(0, prefix);
        }
        self
    }

    /// Several meshes as one, without merging nodes: the parts stay separate bodies. Names are
    /// kept, and must differ between the parts.
    pub fn join(parts: impl IntoIterator<Item = Mesh>) -> Result<Mesh, JoinError> {
        let mut whole = Mesh::default();
        for part in parts {
            let (nodes, elements) = (whole.points.len(), whole.hexes.len());
            let count = (nodes + part.points.len()).max(elements + part.hexes.len());
            if count > u32::MAX as usize {
                return Err(JoinError::TooLarge { count });
            }
            let shifted = |n: u32| n + nodes as u32;
            whole.points.extend(part.points);
            whole
                .hanging
                .extend(part.hanging.into_iter().map(|h| Hanging {
                    node: shifted(h.node),
                    corners: h.corners.into_iter().map(shifted).collect(),
                }));
            whole
                .hexes
                .extend(part.hexes.into_iter().map(|hex| hex.map(shifted)));
            for mut body in part.bodies {
                if whole.body(&body.name).is_some() {
                    return Err(JoinError::SameName {
                        what: "bodies",
                        name: body.name,
                    });
                }
                body.elements = body.elements.start + elements..body.elements.end + elements;
                whole.bodies.push(body);
            }
            for mut surface in part.surfaces {
                if whole.surface(&surface.name).is_some() {
                    return Err(JoinError::SameName {
                        what: "surfaces",
                        name: surface.name,
                    });
                }
                for face in &mut surface.faces {
                    face.nodes = face.nodes.map(shifted);
                    face.element += elements as u32;
                }
                whole.surfaces.push(surface);
            }
            if !whole.source.is_empty() {
                whole.source.push_str(" + ");
            }
            whole.source.push_str(&part.source);
            whole.fingerprint = whole.fingerprint.or(part.fingerprint);
        }
        Ok(whole)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, uniform};

    fn cube(name: &str) -> Mesh {
        let list = || uniform(0.0, 1.0, 2);
        Block::new(name, list(), list(), list()).build().unwrap()
    }

    #[test]
    fn joined_parts_keep_their_elements_and_surfaces() {
        let parts = || [cube("a").prefixed("lower_"), cube("b").prefixed("upper_")];
        let mesh = Mesh::join(parts()).unwrap();
        assert_eq!((mesh.points.len(), mesh.hexes.len()), (54, 16));
        assert_eq!(mesh.bodies[1].name, "upper_b");
        assert_eq!(mesh.bodies[1].elements, 8..16);
        let top = mesh.surface("upper_z_max").unwrap();
        assert!(
            top.faces
                .iter()
                .all(|f| f.element >= 8 && f.nodes.iter().all(|n| *n >= 27))
        );
        let twice = Mesh::join([cube("a"), cube("b")]);
        assert!(matches!(
            twice,
            Err(JoinError::SameName {
                what: "surfaces",
                ..
            })
        ));
    }
}
