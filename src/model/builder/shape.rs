//! What bodies of a scene can be made from.

use super::error::BuildError;
use crate::model::mesh::block::Block;
use crate::model::mesh::{Mesh, msh};
use std::path::PathBuf;

/// Something that becomes bodies of a scene.
///
/// A [`Block`] named `plate` gives the body `plate` with the surfaces `plate_x_min` to `plate_z_max` (or
/// `plate_<name>` for a face that was named), a [`Cylinder`](super::Cylinder) is described there. A [`Mesh`] and a
/// [`MeshFile`] give what they hold, under their own names.
pub trait Shape {
    /// The mesh of the bodies.
    ///
    /// # Errors
    /// Where the dimensions make none, or the file cannot be read.
    fn mesh(self) -> Result<Mesh, BuildError>;
}

impl Shape for Mesh {
    fn mesh(self) -> Result<Mesh, BuildError> {
        match self.fault() {
            Some(why) => Err(BuildError::Broken {
                mesh: self.source,
                why,
            }),
            None => Ok(self),
        }
    }
}

impl Shape for Block<'_> {
    fn mesh(self) -> Result<Mesh, BuildError> {
        let mut mesh = self.build()?;
        let body = mesh.bodies.first().map(|body| body.name.clone());
        for surface in &mut mesh.surfaces {
            surface.name = format!("{}_{}", body.as_deref().unwrap_or_default(), surface.name);
        }
        Ok(mesh)
    }
}

/// A mesh file of gmsh: MSH 4.1 or 2.2, hexahedra, with physical volumes for bodies and physical surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile(pub PathBuf);

impl MeshFile {
    /// The file at `path`.
    pub fn at(path: impl Into<PathBuf>) -> Self {
        Self(path.into())
    }
}

impl Shape for MeshFile {
    fn mesh(self) -> Result<Mesh, BuildError> {
        msh::read(&self.0).map_err(|error| BuildError::Mesh(Box::new(error)))
    }
}
