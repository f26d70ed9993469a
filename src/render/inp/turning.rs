//! Rigid planes that turn. Each has two nodes of its own: one moves as its point does, and the three displacements of
//! the other are its angles in radians.

use super::deck::{Deck, DeckFollower, Turning};
use super::format::{number, one_line};
use crate::model::scene::{PlaneMotion, PlaneTurn, Step};
use std::io::{self, Write};

impl Turning {
    /// Number in the deck of the node that is the point.
    fn point(&self) -> u32 {
        self.reference + 1
    }

    /// Number in the deck of the node that has the angles.
    fn angles(&self) -> u32 {
        self.reference + 2
    }
}

impl Deck<'_> {
    /// The nodes of the planes, and the equations of what follows them; small angles.
    pub(super) fn turning_planes(&self, out: &mut dyn Write) -> io::Result<()> {
        for turning in &self.turning {
            let plane = &self.scene.rigid_planes[turning.plane];
            writeln!(
                out,
                "** {} turns: node {} moves as its point does, and the displacements of node {} are its\n\
                 ** angles in radians. Forces on them are the forces and moments of the plane.",
                one_line(&plane.name),
                turning.point(),
                turning.angles()
            )?;
            writeln!(out, "*NODE,NSET={}", turning.set)?;
            let [x, y, z] = turning.at.map(number);
            for node in [turning.point(), turning.angles()] {
                writeln!(out, "{node},{x},{y},{z}")?;
            }
            if !turning.followers.is_empty() {
                writeln!(out, "*EQUATION")?;
            }
            for DeckFollower { node, axis, levers } in &turning.followers {
                let (dof, point) = (axis + 1, turning.point());
                writeln!(out, "{}", 2 + levers.len())?;
                write!(out, "{},{dof},1.,{point},{dof},-1.", node + 1)?;
                for (about, lever) in levers {
                    let (angles, lever) = (turning.angles(), number(-lever));
                    write!(out, ",{angles},{},{lever}", about + 1)?;
                }
                writeln!(out)?;
            }
        }
        Ok(())
    }

    /// What is prescribed of the planes at the factors `factor` of planes by name; with `closing` every angle.
    pub(super) fn hold_turning(
        &self,
        out: &mut dyn Write,
        factor: impl Fn(&str) -> f64,
        closing: bool,
    ) -> io::Result<()> {
        for turning in &self.turning {
            let plane = &self.scene.rigid_planes[turning.plane];
            let factor = factor(&plane.name);
            for axis in 0..3 {
                let dof = axis + 1;
                let motion = match plane.motion[axis] {
                    PlaneMotion::Held(value) => Some(value * factor),
                    // Nothing follows it.
                    PlaneMotion::Free => Some(0.0),
                    PlaneMotion::Driven(_) => None,
                };
                let angle = match plane.turn[axis] {
                    PlaneTurn::Held(angle) => Some(angle * factor),
                    PlaneTurn::Driven(_) => closing.then_some(0.0),
                };
                for (node, value) in [(turning.point(), motion), (turning.angles(), angle)] {
                    if let Some(value) = value {
                        writeln!(out, "{node},{dof},{dof},{}", number(value))?;
                    }
                }
            }
        }
        Ok(())
    }

    /// The moments of planes that are free to turn.
    pub(super) fn moments(&self, out: &mut dyn Write, step: &Step) -> io::Result<()> {
        for turning in &self.turning {
            let plane = &self.scene.rigid_planes[turning.plane];
            for (about, turn) in plane.turn.iter().enumerate() {
                if let PlaneTurn::Driven(moment) = turn {
                    let moment = number(moment * step.factor_of(&plane.name));
                    writeln!(out, "*CLOAD\n{},{},{moment}", turning.angles(), about + 1)?;
                }
            }
        }
        Ok(())
    }
}
