//! The meshes of problem H, nested or of a given size.

use super::FamilyError;
use super::disc::{ARC, QuarterDisc, TO_CORE};
use super::grading::Grading;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};

/// Radius of the cylinder, in.
pub const RADIUS: f64 = 1.5;
/// Depth and half breadth of the block, in.
pub const DEPTH: f64 = 1.5;
/// Half-width of the contact by Hertz at 8.125 kip/in, in (Johnson 4.43).
pub const HALF_WIDTH: f64 = 0.030_942;

/// Which mesh of problem H.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Elements across the half-width a, before splitting.
    pub across: usize,
    /// Growth of one element to the next outside the fine region, before splitting.
    pub growth: f64,
    /// Each element is split into this many along each side (powers of two are nested).
    pub parts: usize,
}

impl Sizes {
    /// Level `level` of the nested family: 2 · 2^level elements across a, every element of the
    /// level before split into four.
    pub fn nested(level: u32) -> Self {
        Self {
            across: 2,
            growth: 1.6,
            parts: 1 << level,
        }
    }

    /// The family with a fixed growth of 1.2, `across` elements across a. Its coarse region is
    /// never refined, so that its error stagnates.
    pub fn with(across: usize) -> Self {
        Self {
            across,
            growth: 1.2,
            parts: 1,
        }
    }

    /// Element size in the contact over a.
    pub fn size(&self) -> f64 {
        1.0 / (self.across * self.parts) as f64
    }

    /// One layer, as thick as a contact element of the mesh that is not split.
    fn layer(&self) -> Vec<f64> {
        uniform(0.0, HALF_WIDTH / self.across as f64, 1)
    }
}

/// Contact surfaces reach this far from the middle.
const REACH: f64 = 20.0 * HALF_WIDTH;
const TOLERANCE: f64 = 1e-9 * RADIUS;

/// Half model x ≥ 0: quarter disc `cylinder` above the square `block`, touching at the origin.
///
/// Surfaces: `cylinder_contact`, `block_contact`, `symmetry` (x = 0), `base`, `top` (the cut
/// face), `back` and `front`.
pub fn half(sizes: &Sizes) -> Result<Mesh, FamilyError> {
    let mut mesh = Mesh::join([block(sizes)?, cylinder(sizes)?])?;
    mark_symmetry(&mut mesh);
    Ok(mesh)
}

/// Two quarter discs, one the mirror image of the other, touching at the origin. Surfaces:
/// `cylinder_contact`, `lower_contact`, `symmetry`, `top`, `bottom`, `back` and `front`.
pub fn twins(sizes: &Sizes) -> Result<Mesh, FamilyError> {
    let mut mesh = facing(cylinder(sizes)?)?;
    mark_symmetry(&mut mesh);
    Ok(mesh)
}

/// The twins without symmetry: two half discs. Surfaces as [`twins`], without `symmetry`.
pub fn full_twins(sizes: &Sizes) -> Result<Mesh, FamilyError> {
    let mut upper = both(cylinder(sizes)?, "cylinder")?;
    mark_cylinder(&mut upper);
    let mut mesh = facing(upper)?;
    mark_sides(&mut mesh);
    Ok(mesh)
}

/// `upper` with its mirror image below, called `lower`.
fn facing(upper: Mesh) -> Result<Mesh, FamilyError> {
    let mut lower = upper.clone().mirrored(1);
    lower.bodies[0].name = "lower".into();
    for surface in &mut lower.surfaces {
        surface.name = match surface.name.as_str() {
            "cylinder_contact" => "lower_contact".into(),
            "top" => "bottom".into(),
            other => format!("lower_{other}"),
        };
    }
    Ok(Mesh::join([lower, upper])?)
}

/// A half model with its mirror image, as one body without surfaces.
fn both(half: Mesh, name: &str) -> Result<Mesh, FamilyError> {
    let image = half.clone().mirrored(0);
    Ok(Mesh::weld(name, [image, half], TOLERANCE)?)
}

/// The whole problem, without symmetry: half disc on a block twice as wide. Surfaces as
/// [`half`], without `symmetry`.
pub fn full(sizes: &Sizes) -> Result<Mesh, FamilyError> {
    let mut block = both(block(sizes)?, "block")?;
    let mut cylinder = both(cylinder(sizes)?, "cylinder")?;
    mark_block(&mut block);
    mark_cylinder(&mut cylinder);
    let mut mesh = Mesh::join([block, cylinder])?;
    mark_sides(&mut mesh);
    Ok(mesh)
}

fn mark_symmetry(mesh: &mut Mesh) {
    for body in ["block", "cylinder", "lower"] {
        mesh.mark("symmetry", body, |p| p[0].abs() < TOLERANCE);
    }
    mark_sides(mesh);
}

fn mark_sides(mesh: &mut Mesh) {
    mesh.surfaces
        .retain(|s| s.name != "back" && s.name != "front");
    let end = mesh.points.iter().map(|p| p[2]).fold(0.0, f64::max);
    mesh.mark_all("back", |p| p[2].abs() < TOLERANCE);
    mesh.mark_all("front", |p| (p[2] - end).abs() < TOLERANCE);
}

fn mark_block(mesh: &mut Mesh) {
    mesh.mark("block_contact", "block", |p| {
        p[1].abs() < TOLERANCE && p[0].abs() < REACH
    });
    mesh.mark("base", "block", |p| (p[1] + DEPTH).abs() < TOLERANCE);
}

fn mark_cylinder(mesh: &mut Mesh) {
    mesh.mark("cylinder_contact", "cylinder", |p| {
        (p[0].hypot(RADIUS - p[1]) - RADIUS).abs() < TOLERANCE && p[0].abs() < REACH
    });
    mesh.mark("top", "cylinder", |p| (p[1] - RADIUS).abs() < TOLERANCE);
}

/// The block, its elements 1.1 times as long as the cylinder's: the meshes do not match.
fn block(sizes: &Sizes) -> Result<Mesh, FamilyError> {
    let h = 1.1 * HALF_WIDTH / sizes.across as f64;
    let across = Grading::new(h, 1.5 * HALF_WIDTH, DEPTH, sizes.growth);
    let down = Grading::new(h, 1.25 * HALF_WIDTH, DEPTH, sizes.growth);
    let depths: Vec<f64> = down
        .nodes(sizes.parts)
        .into_iter()
        .rev()
        .map(|s| -s)
        .collect();
    let mut mesh = Block::new("block", across.nodes(sizes.parts), depths, sizes.layer()).build()?;
    mesh.surfaces.clear();
    mark_block(&mut mesh);
    Ok(mesh)
}

fn cylinder(sizes: &Sizes) -> Result<Mesh, FamilyError> {
    let h = HALF_WIDTH / sizes.across as f64;
    let around = Grading::new(h, 1.5 * HALF_WIDTH, RADIUS * ARC, sizes.growth);
    let inward = Grading::new(h, 1.25 * HALF_WIDTH, RADIUS * TO_CORE, sizes.growth);
    let disc = QuarterDisc {
        radius: RADIUS,
        arcs: around.nodes(sizes.parts),
        depths: inward.nodes(sizes.parts),
        rest: 5 * sizes.parts,
        layers: sizes.layer(),
    };
    let mut mesh = disc.build("cylinder")?;
    mark_cylinder(&mut mesh);
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_splits_every_element_of_the_one_before() {
        let (coarse, fine) = (
            half(&Sizes::nested(0)).unwrap(),
            half(&Sizes::nested(1)).unwrap(),
        );
        assert_eq!(4 * coarse.hexes.len(), fine.hexes.len());
        for p in &coarse.points {
            let near = |q: &&[f64; 3]| (0..3).all(|i| (p[i] - q[i]).abs() < 1e-12);
            assert!(fine.points.iter().any(|q| near(&q)), "{p:?}");
        }
        for name in [
            "cylinder_contact",
            "block_contact",
            "symmetry",
            "base",
            "top",
            "back",
            "front",
        ] {
            let faces = |mesh: &Mesh| mesh.surface(name).map_or(0, |s| s.faces.len());
            assert!(
                faces(&coarse) > 0 && faces(&fine) > faces(&coarse),
                "{name}"
            );
        }
    }

    #[test]
    fn the_meshes_are_sound() {
        for mesh in [
            half(&Sizes::with(8)),
            twins(&Sizes::with(4)),
            full(&Sizes::with(4)),
            full_twins(&Sizes::with(4)),
        ] {
            for part in mesh.unwrap().quality() {
                assert!(part.min_scaled_jacobian > 0.05, "{part:?}");
            }
        }
    }
}
