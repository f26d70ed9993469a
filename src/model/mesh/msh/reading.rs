//! What comes of reading a mesh file.

use crate::model::mesh::Mesh;

/// A mesh, and what was changed in reading it.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The mesh.
    pub mesh: Mesh,
    /// Sentences for the user, such as that the elements of a body were numbered left-handed.
    pub notes: Vec<String>,
}
