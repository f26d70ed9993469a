//! The steps: closing the contact by motion, then the loads of the scene; and what to put out.

use super::deck::{Deck, Driven, NodalForce, NodalTemperature};
use super::format::{number, one_line};
use super::mesh::face_number;
use super::settings::ContactType;
use crate::model::scene::{Step, TractionValue};
use std::io::{self, Write};

/// First increment of the closing step, as a share of it.
const CLOSING_INCREMENT: f64 = 0.25;
/// Smallest increment, as a share of a step.
const SMALLEST_INCREMENT: f64 = 1e-5;

impl Deck<'_> {
    pub(super) fn steps(&self, out: &mut dyn Write) -> io::Result<()> {
        let Some(first) = self.scene.steps.first() else {
            return Ok(());
        };
        let force = |plane: &Driven| plane.force * first.factor_of(&plane.plane);
        let pushed: Vec<&Driven> = self.driven.iter().filter(|p| force(p) != 0.0).collect();
        if !self.scene.contacts.is_empty() && !pushed.is_empty() {
            writeln!(
                out,
                "** Closing: no force finds a balance before there is contact, so what will be\n\
                 ** driven by force is moved a little way first."
            )?;
            self.begin(out, CLOSING_INCREMENT)?;
            self.boundary(out, |_| 0.0)?;
            self.hold_turning(out, |_| 0.0, true)?;
            for plane in pushed {
                let closing = self.settings.closing.unwrap_or(plane.closing);
                let (node, dof) = (plane.reference + 1, plane.axis + 1);
                let motion = closing.copysign(force(plane));
                writeln!(out, "{node},{dof},{dof},{}", number(motion))?;
            }
            writeln!(out, "*END STEP")?;
        }
        let increment = self.settings.increment;
        let increment = increment.unwrap_or(self.scene.controls.first_increment);
        for (index, (step, nodal_forces)) in
            (self.scene.steps.iter().zip(&self.nodal_forces)).enumerate()
        {
            writeln!(out, "** {}", one_line(&step.name))?;
            self.begin(out, increment.min(1.0))?;
            self.boundary(out, |name| step.factor_of(name))?;
            self.hold_turning(out, |name| step.factor_of(name), false)?;
            self.loads(out, step, nodal_forces)?;
            self.temperatures(out, index)?;
            self.requests(out)?;
            writeln!(out, "*END STEP")?;
        }
        Ok(())
    }

    fn begin(&self, out: &mut dyn Write, increment: f64) -> io::Result<()> {
        writeln!(out, "*STEP,INC=1000")?;
        match &self.settings.solver {
            Some(solver) => writeln!(out, "*STATIC,SOLVER={solver}")?,
            None => writeln!(out, "*STATIC")?,
        }
        writeln!(out, "{increment},1.,{SMALLEST_INCREMENT:e},1.")
    }

    fn loads(
        &self,
        out: &mut dyn Write,
        step: &Step,
        nodal_forces: &[Vec<NodalForce>],
    ) -> io::Result<()> {
        let mesh = &self.scene.mesh;
        for plane in &self.driven {
            let force = plane.force * step.factor_of(&plane.plane);
            let (node, dof) = (plane.reference + 1, plane.axis + 1);
            writeln!(out, "*CLOAD\n{node},{dof},{}", number(force))?;
        }
        self.moments(out, step)?;
        for (traction, nodal_forces) in self.scene.tractions.iter().zip(nodal_forces) {
            let Some(surface) = mesh.surface(&traction.surface) else {
                continue;
            };
            let factor = step.factor_of(&traction.name);
            match traction.value {
                TractionValue::Pressure(pressure) => {
                    writeln!(out, "*DLOAD")?;
                    for face in &surface.faces {
                        let side = face_number(mesh, face);
                        let pressure = number(pressure * factor);
                        writeln!(out, "{},P{side},{pressure}", face.element + 1)?;
                    }
                }
                TractionValue::Vector(_) => {
                    writeln!(out, "*CLOAD")?;
                    for NodalForce { node, axis, force } in nodal_forces {
                        writeln!(out, "{},{},{}", node + 1, axis + 1, number(*force))?;
                    }
                }
            }
        }
        Ok(())
    }

    fn temperatures(&self, out: &mut dyn Write, step: usize) -> io::Result<()> {
        let Some(temperatures) = self.heat.steps.get(step) else {
            return Ok(());
        };
        writeln!(out, "*TEMPERATURE")?;
        for NodalTemperature { node, value } in temperatures {
            writeln!(out, "{},{}", node + 1, number(*value))?;
        }
        Ok(())
    }

    /// At the end of the step: displacement, nodal stress, plastic strain, contact, reactions.
    fn requests(&self, out: &mut dyn Write) -> io::Result<()> {
        const LAST: &str = "FREQUENCY=9999";
        writeln!(out, "*NODE FILE,{LAST}\nU")?;
        let fields = if self.scene.may_yield() {
            "S,PEEQ"
        } else {
            "S"
        };
        writeln!(out, "*EL FILE,{LAST}\n{fields}")?;
        for set in self.held_sets() {
            writeln!(out, "*NODE PRINT,NSET={set},TOTALS=YES,{LAST}\nRF")?;
        }
        for turning in &self.turning {
            writeln!(out, "*NODE PRINT,NSET={},{LAST}\nU,RF", turning.set)?;
        }
        if self.pairs.is_empty() {
            return Ok(());
        }
        writeln!(out, "*CONTACT FILE,{LAST}\nCDIS,CSTR")?;
        if self.settings.contact == ContactType::SurfaceToSurface {
            for pair in &self.pairs {
                let [carrier, other] = &pair.sides;
                writeln!(
                    out,
                    "*CONTACT PRINT,SLAVE={carrier},MASTER={other},{LAST}\nCF"
                )?;
            }
        }
        Ok(())
    }
}
