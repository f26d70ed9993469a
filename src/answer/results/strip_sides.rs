//! The two sides of a strip of contact: how they curve there, and what Hertz makes of them.

use super::circle::FittedCircle;
use super::crease::Crease;
use super::line_frame::LineFrame;
use super::strip_row::StripRow;
use crate::analytic::hertz::LineContact;
use crate::ground::geometry::{Vec3, dot, norm, sub};
use crate::model::mesh::shape::fit;
use crate::model::mesh::{Face, Mesh, Surface};
use crate::model::scene::{ContactPair, Partner, Scene};

/// Half-width of a strip over the smallest radius of its surfaces from which on it is conformal. Hertz's theory takes that for
/// small (Johnson, Contact Mechanics, section 4.2); of pins in holes the largest pressure is 5 % above Hertz's with 0.3, and 15 % with 0.5.
const CONFORMAL: f64 = 0.25;

/// The sides of a strip at one of its rows, the upper one first.
pub struct StripSides {
    sides: [Side; 2],
}

struct Side {
    /// Curvature across the strip, convex positive; `None` where it is not known.
    curvature: Option<f64>,
    crease: Option<Crease>,
}

impl StripSides {
    /// Those of a contact pair, at a row of a strip along `frame`.
    pub fn of(scene: &Scene, pair: &ContactPair, (frame, row): (&LineFrame, &StripRow)) -> Self {
        let cut = Some(frame.across).filter(|_| row.mirrored);
        let of_surface = |surface| Side::of(&scene.mesh, surface, (frame, row), cut);
        let side = |side: &Partner| {
            side.surface(&scene.mesh)
                .map_or_else(Side::plane, of_surface)
        };
        Self {
            sides: [side(&pair.upper), side(&pair.lower)],
        }
    }

    /// Hertz's contact under a load per length; `None` where a curvature is not known, or the two do not curve apart.
    pub fn under(&self, scene: &Scene, pair: &ContactPair, load: f64) -> Option<LineContact> {
        /// Of the curvature of a side, below which a difference is rounding: a shaft fills its hub.
        const ROUNDING: f64 = 1e-9;
        let [upper, lower] = self.sides.each_ref().map(|side| side.curvature);
        let (upper, lower) = (upper?, lower?);
        let sum = upper + lower;
        let apart = sum > ROUNDING * upper.abs().max(lower.abs());
        let radius = apart.then(|| 1.0 / sum)?;
        LineContact::new(load, radius, scene.compliance(pair).ok()?).ok()
    }

    /// Is the strip wide beside the radii of its sides, as of a pin in a hole?
    pub fn are_conformal(&self, hertz: &LineContact) -> bool {
        let curvatures = self.sides.iter().filter_map(|side| side.curvature);
        let largest = curvatures.map(f64::abs).fold(0.0, f64::max);
        hertz.half_width * largest > CONFORMAL
    }

    /// Does a crease make two strips of it, which the mesh does not tell apart?
    pub fn are_split(&self, hertz: &LineContact) -> bool {
        let mut creases = self.sides.iter().filter_map(|side| side.crease);
        creases.any(|crease| crease.splits(hertz.half_width, hertz.radius))
    }
}

impl Side {
    fn plane() -> Self {
        Self {
            curvature: Some(0.0),
            crease: None,
        }
    }

    /// Its curvature is that of the shape that its nodes lie on, of that of its nodes about the strip, of the two planes
    /// that meet there, or of the circle through its row of nodes next to the row. A plane of symmetry may `cut` it across an axis.
    fn of(
        mesh: &Mesh,
        surface: &Surface,
        (frame, row): (&LineFrame, &StripRow),
        cut: Option<Vec3>,
    ) -> Self {
        const PARALLEL: f64 = 0.99;
        let mut shape = fit(mesh, surface);
        let mut curvature = shape.curvature(frame.along, PARALLEL);
        if curvature.is_none() {
            let about = about(mesh, surface, frame, row);
            if let Some(crease) = Crease::between(mesh, &about, &frame.along, row) {
                return Self {
                    crease: Some(crease),
                    ..Self::plane()
                };
            }
            shape = fit(mesh, &about);
            curvature = shape.curvature(frame.along, PARALLEL);
        }
        Self {
            curvature: curvature.or_else(|| row_curvature(mesh, surface, frame, row.at)),
            crease: cut.and_then(|across| Crease::with_image(&shape, &across)),
        }
    }
}

/// The faces of a surface that come as near to the line through the middle of a row along `frame` as three of its
/// half-widths.
fn about(mesh: &Mesh, surface: &Surface, frame: &LineFrame, row: &StripRow) -> Surface {
    let reach = 3.0 * row.half_width.max(row.middle_spacing());
    let from_line = |corner: [f64; 3]| norm(frame.square(sub(corner, row.centre)));
    let near = |face: &&Face| {
        face.corners(mesh)
            .into_iter()
            .any(|c| from_line(c) <= reach)
    };
    Surface {
        name: surface.name.clone(),
        faces: surface.faces.iter().filter(near).copied().collect(),
    }
}

fn row_curvature(mesh: &Mesh, surface: &Surface, frame: &LineFrame, at: f64) -> Option<f64> {
    let nodes = surface.nodes();
    let off = |n: &u32| (frame.along(&mesh.points[*n as usize]) - at).abs();
    let nearest = nodes.iter().map(off).fold(f64::INFINITY, f64::min);
    let plane = [frame.across, frame.up];
    let size = nodes.iter().map(off).fold(0.0, f64::max);
    let row = nodes.iter().filter(|n| off(n) <= nearest + 1e-6 * size);
    let points: Vec<[f64; 2]> = row
        .map(|n| plane.map(|d| dot(d, mesh.points[*n as usize])))
        .collect();
    let FittedCircle {
        centre: middle,
        radius,
    } = FittedCircle::through(&points)?;
    // Convex where facets face away from the middle.
    let outward = surface.faces.iter().map(|face| {
        let corners = face.corners(mesh);
        let normal = face.area_vector(mesh);
        let arm = [0, 1].map(|k| dot(plane[k], corners[0]) - middle[k]);
        dot(normal, plane[0]) * arm[0] + dot(normal, plane[1]) * arm[1]
    });
    Some(outward.sum::<f64>().signum() / radius)
}
