//! What holds the bodies: supports, rigid planes, and soft springs until contact does.

use super::deck::Deck;
use super::format::{number, one_line};
use crate::ground::geometry::AXES;
use crate::model::scene::PlaneMotion;
use std::collections::BTreeSet;
use std::io::{self, Write};

impl Deck<'_> {
    /// Springs and the equations of rigid planes; boundary conditions stand in the steps.
    pub(super) fn hold(&self, out: &mut dyn Write) -> io::Result<()> {
        if !self.springs.is_empty() {
            writeln!(
                out,
                "** Soft springs where nothing but contact holds a body. All on one body along one\n\
                 ** axis carry {:e} of the load for a motion of a thousandth of the model.",
                self.spring_share
            )?;
        }
        let mut element = self.scene.mesh.hexes.len();
        for springs in &self.springs {
            let name = &springs.name;
            writeln!(out, "*ELEMENT,TYPE=SPRING1,ELSET={name}")?;
            for node in &springs.nodes {
                element += 1;
                writeln!(out, "{element},{}", node + 1)?;
            }
            writeln!(out, "*SPRING,ELSET={name}\n{}", springs.axis + 1)?;
            writeln!(out, "{}", number(springs.stiffness))?;
        }
        for plane in self.driven.iter().filter(|plane| !plane.others.is_empty()) {
            let (name, axis) = (one_line(&plane.plane), AXES[plane.axis]);
            writeln!(out, "** The nodes of {name} move along {axis} as one.")?;
            let (reference, dof) = (plane.reference + 1, plane.axis + 1);
            writeln!(out, "*EQUATION")?;
            for node in &plane.others {
                writeln!(out, "2\n{},{dof},1.,{reference},{dof},-1.", node + 1)?;
            }
        }
        self.turning_planes(out)
    }

    /// Node sets of the supports and rigid planes, in the order of the mesh.
    pub(super) fn held_sets(&self) -> impl Iterator<Item = &str> {
        let scene = self.scene;
        let supports = scene.supports.iter().map(|s| s.surface.as_str());
        let planes = scene.rigid_planes.iter().map(|p| p.surface.as_str());
        let held: BTreeSet<&str> = supports.chain(planes).collect();
        let surfaces = scene.mesh.surfaces.iter().enumerate();
        let held = surfaces.filter(move |(_, s)| held.contains(s.name.as_str()));
        held.map(|(index, _)| self.names.surface(index))
    }

    /// Everything that is prescribed, at the factors `factor` of supports and planes by name.
    pub(super) fn boundary(
        &self,
        out: &mut dyn Write,
        factor: impl Fn(&str) -> f64,
    ) -> io::Result<()> {
        let mesh = &self.scene.mesh;
        let index = |name: &str| mesh.surfaces.iter().position(|s| s.name == name);
        writeln!(out, "*BOUNDARY,OP=NEW")?;
        for support in &self.scene.supports {
            let Some(index) = index(&support.surface) else {
                continue;
            };
            let factor = factor(&support.name);
            for axis in 0..3 {
                let Some(value) = support.components[axis] else {
                    continue;
                };
                let dof = axis + 1;
                if support.gradient[axis] == [0.0; 3] {
                    let (set, value) = (self.names.surface(index), value * factor);
                    writeln!(out, "{set},{dof},{dof},{}", number(value))?;
                    continue;
                }
                for node in mesh.surfaces[index].nodes() {
                    let value = support.displacement(axis, &mesh.points[node as usize]);
                    let value = number(value.unwrap_or(0.0) * factor);
                    writeln!(out, "{},{dof},{dof},{value}", node + 1)?;
                }
            }
        }
        for plane in &self.scene.rigid_planes {
            let Some(index) = index(&plane.surface).filter(|_| !plane.turns()) else {
                continue;
            };
            for (axis, motion) in plane.motion.iter().enumerate() {
                if let PlaneMotion::Held(value) = motion {
                    let (set, dof) = (self.names.surface(index), axis + 1);
                    let value = number(value * factor(&plane.name));
                    writeln!(out, "{set},{dof},{dof},{value}")?;
                }
            }
        }
        Ok(())
    }
}
