//! Blocks with a round face: the part of a sphere or cylinder next to its contact.
//!
//! A Hertz contact feels the curvature of a surface and the stiffness of what lies within a few
//! widths, not the rest of the body, so a block with a round face stands for a sphere or a roller.

use crate::model::mesh::Mesh;
use crate::model::mesh::block::Block;
use crate::model::mesh::family::grading::Grading;
use crate::proof::verify::VerifyError;

/// The round face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Round {
    Sphere(f64),
    /// Cylinder of this radius, curved along this axis (0 or 1).
    Cylinder(f64, usize),
}

impl Round {
    /// Height of the face over its lowest point.
    pub fn rise(&self, x: f64, y: f64) -> f64 {
        let (radius, square) = match *self {
            Self::Sphere(radius) => (radius, x * x + y * y),
            Self::Cylinder(radius, 0) => (radius, x * x),
            Self::Cylinder(radius, _) => (radius, y * y),
        };
        // R − √(R² − s²) without cancellation.
        square / (radius + (radius * radius - square).sqrt())
    }
}

/// Quarter x, y ≥ 0 of a block with a round face at the bottom, touching z = 0 at the origin.
///
/// `size` are the element sizes along x, y and z at the contact, `fine` the lengths over which
/// they stay so, `extent` the edges of the block. Surfaces are those of a [`Block`]: the round
/// face is `z_min`, the flat one `z_max`, and `x_min` and `y_min` are planes of symmetry.
pub fn bump(
    name: &str,
    round: Round,
    size: [f64; 3],
    fine: [f64; 3],
    extent: [f64; 3],
    growth: f64,
) -> Result<Mesh, VerifyError> {
    let [x, y, z] = [0, 1, 2].map(|i| Grading::new(size[i], fine[i], extent[i], growth).nodes(1));
    let height = extent[2];
    let block = Block::new(name, x, y, z).mapped(|[x, y, z]| {
        let rise = round.rise(x, y);
        [x, y, z + rise * (1.0 - z / height).max(0.0)]
    });
    Ok(block.build()?)
}

/// The same body upside down: it reaches from z = 0 downwards.
pub fn upside_down(mesh: Mesh) -> Mesh {
    mesh.mirrored(2)
}
