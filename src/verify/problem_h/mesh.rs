//! The meshes of problem H, nested or of a given size.

use std::f64::consts::FRAC_PI_4;

use super::grading::Grading;
use super::{DEPTH, HALF_WIDTH, RADIUS};
use crate::mesh::Mesh;
use crate::mesh::block::{Block, uniform};
use crate::verify::VerifyError;

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
pub fn half(sizes: &Sizes) -> Result<Mesh, VerifyError> {
    let mut mesh = Mesh::join([block(sizes)?, cylinder(sizes)?])?;
    mark_symmetry(&mut mesh);
    Ok(mesh)
}

/// Two quarter discs, one the mirror image of the other, touching at the origin. Surfaces:
/// `cylinder_contact`, `lower_contact`, `symmetry`, `top`, `bottom`, `back` and `front`.
pub fn twins(sizes: &Sizes) -> Result<Mesh, VerifyError> {
    let mut lower = cylinder(sizes)?.mirrored(1);
    lower.bodies[0].name = "lower".into();
    for surface in &mut lower.surfaces {
        surface.name = match surface.name.as_str() {
            "cylinder_contact" => "lower_contact".into(),
            "top" => "bottom".into(),
            other => format!("lower_{other}"),
        };
    }
    let mut mesh = Mesh::join([lower, cylinder(sizes)?])?;
    mark_symmetry(&mut mesh);
    mark_sides(&mut mesh);
    Ok(mesh)
}

/// The whole problem, without symmetry: half disc on a block twice as wide. Surfaces as
/// [`half`], without `symmetry`.
pub fn full(sizes: &Sizes) -> Result<Mesh, VerifyError> {
    let both =
        |mesh: Mesh, name: &str| Mesh::weld(name, [mesh.clone().mirrored(0), mesh], TOLERANCE);
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
    let names: Vec<String> = mesh.bodies.iter().map(|b| b.name.clone()).collect();
    for body in names {
        mesh.mark("back", &body, |p| p[2].abs() < TOLERANCE);
        mesh.mark("front", &body, |p| (p[2] - end).abs() < TOLERANCE);
    }
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
fn block(sizes: &Sizes) -> Result<Mesh, VerifyError> {
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

/// The quarter disc: a sector over the contact, a sector beside it, and a core.
fn cylinder(sizes: &Sizes) -> Result<Mesh, VerifyError> {
    /// Distance of the core's corners from the centre, on the axes and on the diagonal.
    const CORE: f64 = 0.45 * RADIUS;
    const CORNER: f64 = 0.42 * RADIUS;
    /// Elements around the upper sector before splitting.
    const UPPER: usize = 5;
    let h = HALF_WIDTH / sizes.across as f64;
    let around = Grading::new(h, 1.5 * HALF_WIDTH, RADIUS * FRAC_PI_4, sizes.growth);
    let inward = Grading::new(h, 1.25 * HALF_WIDTH, RADIUS - CORE, sizes.growth);
    let last = inward.at(inward.cells() as f64);
    // Share of the way from the arc to the core, and of the way round each sector.
    let shares = |grading: &Grading, total: f64| -> Vec<f64> {
        let nodes = grading.nodes(sizes.parts);
        let end = nodes.len() - 1;
        let share = |(k, s): (usize, f64)| if k == end { 1.0 } else { s / total };
        nodes.into_iter().enumerate().map(share).collect()
    };
    let round = shares(&around, around.at(around.cells() as f64));
    let deep = shares(&inward, last);
    let upper = uniform(0.0, 1.0, UPPER * sizes.parts);
    // In the plane of the disc, v downward from the centre; y = R − v.
    let bottom = |f: f64| [CORNER * f, CORE + (CORNER - CORE) * f];
    let side = |g: f64| [CORNER + (CORE - CORNER) * g, CORNER * (1.0 - g)];
    let sector = |angle: f64, core: [f64; 2], t: f64| {
        let arc = [RADIUS * angle.sin(), RADIUS * angle.cos()];
        let x = arc[0] + (core[0] - arc[0]) * t;
        [x, RADIUS - (arc[1] + (core[1] - arc[1]) * t)]
    };
    let lower =
        Block::new("sector", round.clone(), deep.clone(), sizes.layer()).mapped(|[f, t, z]| {
            let [x, y] = sector(f * FRAC_PI_4, bottom(f), t);
            [x, y, z]
        });
    let beside = Block::new("beside", upper.clone(), deep, sizes.layer()).mapped(|[g, t, z]| {
        let [x, y] = sector((1.0 + g) * FRAC_PI_4, side(g), t);
        [x, y, z]
    });
    // Transfinite interpolation between the core's four sides.
    let core = Block::new("core", round, upper, sizes.layer()).mapped(|[f, g, z]| {
        let (low, right) = (bottom(f), side(g));
        let (top, left) = ([f * CORE, 0.0], [0.0, CORE * (1.0 - g)]);
        let corners = [[0.0, CORE], [CORNER, CORNER], [0.0, 0.0], [CORE, 0.0]];
        let [x, v] = [0, 1].map(|i| {
            (1.0 - g) * low[i] + g * top[i] + (1.0 - f) * left[i] + f * right[i]
                - (1.0 - f) * ((1.0 - g) * corners[0][i] + g * corners[2][i])
                - f * ((1.0 - g) * corners[1][i] + g * corners[3][i])
        });
        [x, RADIUS - v, z]
    });
    let parts = [lower.build()?, beside.build()?, core.build()?];
    let mut mesh = Mesh::weld("cylinder", parts, TOLERANCE)?;
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
        ] {
            for part in mesh.unwrap().quality() {
                assert!(part.min_scaled_jacobian > 0.05, "{part:?}");
            }
        }
    }
}
