//! Contact pairs: the faces that may touch, and the law between them.

use super::deck::Deck;
use super::format::number;
use super::mesh::face_number;
use super::settings::ContactType;
use std::io::{self, Write};

/// Shear per slip where the nodes stick, as a share of the pressure per overclosure.
const STICK_SHARE: f64 = 0.1;

impl Deck<'_> {
    pub(super) fn contact(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.pairs.is_empty() {
            return Ok(());
        }
        let [length, _, stress] = &self.settings.units;
        let mesh = &self.scene.mesh;
        let moduli = self.scene.materials.iter().map(|s| s.youngs_modulus);
        let young = moduli.fold(0.0, f64::max);
        writeln!(
            out,
            "** Contact: pressure = K times overclosure, K = {:.4e} {stress}/{length} = {:.4e} E per\n\
             ** {length}. Softer contact adds to the approach and spreads the pressure; stiffer\n\
             ** contact makes the pressure of coarse meshes oscillate.",
            self.stiffness,
            self.stiffness / young
        )?;
        for pair in &self.pairs {
            for (name, faces) in pair.sides.iter().zip(&pair.faces) {
                writeln!(out, "*SURFACE,NAME={name},TYPE=ELEMENT")?;
                for face in faces {
                    let number = face_number(mesh, face);
                    writeln!(out, "{},S{number}", face.element + 1)?;
                }
            }
            let name = &pair.name;
            writeln!(out, "*SURFACE INTERACTION,NAME={name}")?;
            writeln!(out, "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR")?;
            writeln!(out, "{}", number(self.stiffness))?;
            if pair.friction > 0.0 {
                let stick = STICK_SHARE * self.stiffness;
                writeln!(
                    out,
                    "*FRICTION\n{},{}",
                    number(pair.friction),
                    number(stick)
                )?;
            }
            let [carrier, other] = &pair.sides;
            let kind = match self.settings.contact {
                ContactType::SurfaceToSurface => "SURFACE TO SURFACE",
                ContactType::NodeToSurface => "NODE TO SURFACE",
                ContactType::Mortar => "MORTAR",
            };
            writeln!(out, "*CONTACT PAIR,INTERACTION={name},TYPE={kind}")?;
            writeln!(out, "{carrier},{other}")?;
        }
        Ok(())
    }
}
