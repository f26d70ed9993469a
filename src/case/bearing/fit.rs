//! The mesh of a bearing: is it the right one, and brought to the case's units and roller ends.

use super::bearing_case::BearingCase;
use super::fingerprint::fingerprint;
use super::parameters::rescale;
use crate::case::error::{CaseError, ErrorKind};
use crate::model::mesh::Mesh;

impl BearingCase {
    /// The fingerprint that a mesh of this bearing carries.
    pub fn fingerprint(&self) -> String {
        fingerprint(self.layout(), &self.mesh)
    }

    /// The mesh in the units of the case, its rollers with the ends of the case.
    pub(in crate::case) fn fit(&self, mut mesh: Mesh) -> Result<Mesh, CaseError> {
        let wanted = self.fingerprint();
        let why = match mesh.fingerprint.as_deref() {
            Some(found) if found == wanted => {
                rescale(&mut mesh, self.layout());
                self.layout().shape(&mut mesh, self.mesh.full);
                return Ok(mesh);
            }
            Some(found) => format!("is of another bearing or preset: {found} is not {wanted}"),
            None => "carries no fingerprint, so it cannot be known to be of this bearing".into(),
        };
        let message = format!("the mesh {} {why}", mesh.source);
        let help = "have it made again: `brinell mesh` calls gmsh with the numbers of the case";
        Err(CaseError::new(ErrorKind::Mesh, message).help(help))
    }
}
