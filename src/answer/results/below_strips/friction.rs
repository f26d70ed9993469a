//! What friction does below a strip: the force of a row, and where tractions turn round.

use super::strips::{RING, SAME_SECTION, Strip, Strips};
use crate::ground::geometry::{Vec3, add, dot, norm, sub};
use crate::model::scene::Scene;
use crate::model::state::ContactField;

/// Share of the heaviest load per length that a row carries where the largest stress may lie.
const MUCH: f64 = 0.7;

impl Strips<'_> {
    /// The largest change of the traction along the strip from row to row, and of that across it from its mean, over the pressure,
    /// of rows that carry [`MUCH`] of the heaviest load.
    pub fn turns(&self, scene: &Scene, field: &ContactField) -> [f64; 2] {
        let line = &self.line.line;
        let rows = line.at.iter().zip(&line.load);
        let heavy = rows.filter(|(_, load)| **load >= MUCH * self.line.line_load);
        let shares: Vec<[f64; 2]> = heavy
            .filter_map(|(row, _)| self.shares(scene, field, *row))
            .collect();
        let along = (shares.windows(2)).map(|rows| (rows[1][0] - rows[0][0]).abs());
        let across = shares.iter().map(|[_, spread]| *spread);
        [along.fold(0.0, f64::max), across.fold(0.0, f64::max)]
    }

    /// Over the pressing force of a row, its force along the strip, and the forces across it of single nodes beyond their mean.
    fn shares(&self, scene: &Scene, field: &ContactField, row: f64) -> Option<[f64; 2]> {
        let own = self.places.first()?;
        let total = self.force(scene, field, row);
        let press = dot(own.normal, total);
        let across = &self.line.frame.across;
        let is_cut = own.loads.heaviest.mirrored;
        // Of the whole strip, what its halves do across it cancels.
        let mean = if is_cut {
            0.0
        } else {
            dot(*across, total) / press
        };
        let beyond = self
            .forces(scene, field, row)
            .map(|force| (dot(*across, force) - mean * dot(own.normal, force)).abs());
        let spread = beyond.sum::<f64>() / press.abs();
        let along = self.line.frame.along(&total) / press;
        (press != 0.0).then_some([along, spread])
    }

    /// Force on the lower body of the nodes of the heaviest strip in a row.
    pub fn force(&self, scene: &Scene, field: &ContactField, row: f64) -> Vec3 {
        self.forces(scene, field, row).fold([0.0; 3], add)
    }

    /// Those of single nodes.
    fn forces<'f>(
        &'f self,
        scene: &'f Scene,
        field: &'f ContactField,
        row: f64,
    ) -> impl Iterator<Item = Vec3> + 'f {
        let frame = &self.line.frame;
        let nodes = field.nodes.iter().zip(&field.force);
        let of_row = nodes.filter(move |(node, _)| {
            let at = scene.mesh.points[**node as usize];
            let is_near =
                |own: &Strip| norm(frame.square(sub(at, own.centre))) < RING[0] * self.half_width;
            (frame.along(&at) - row).abs() < SAME_SECTION * self.half_width
                && self.places.first().is_some_and(is_near)
        });
        of_row.map(|(_, force)| *force)
    }
}
