//! Ties: the faces that are joined.

use super::deck::Deck;
use super::format::number;
use super::mesh::face_number;
use std::io::{self, Write};

impl Deck<'_> {
    pub(super) fn ties(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.ties.is_empty() {
            return Ok(());
        }
        writeln!(
            out,
            "** Ties: slave, master. Brinell joins them in the mean, by mortar integrals; here each node\n\
             ** of the slave follows the face opposite. Boundary conditions on slave nodes come first."
        )?;
        for tie in &self.ties {
            for (name, faces) in tie.sides.iter().zip(&tie.faces) {
                writeln!(out, "*SURFACE,NAME={name},TYPE=ELEMENT")?;
                for face in faces {
                    let number = face_number(&self.scene.mesh, face);
                    writeln!(out, "{},S{number}", face.element + 1)?;
                }
            }
            let [slave, master] = &tie.sides;
            let tolerance = number(tie.tolerance);
            writeln!(out, "*TIE,NAME={},POSITION TOLERANCE={tolerance}", tie.name)?;
            writeln!(out, "{slave},{master}")?;
        }
        Ok(())
    }
}
