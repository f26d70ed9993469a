//! A quarter of a disc in hexahedra, graded towards a contact on its lower rim.

use std::f64::consts::FRAC_PI_4;

use super::FamilyError;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};

/// Depth of the core below the rim at the bottom, as a share of the radius: depths end there.
pub const TO_CORE: f64 = 0.55;
/// Length of the graded arc, as a share of the radius: arcs end there.
pub const ARC: f64 = FRAC_PI_4;

/// Where the nodes of a quarter disc are.
#[derive(Debug, Clone, PartialEq)]
pub struct QuarterDisc {
    /// Radius of the disc.
    pub radius: f64,
    /// Arc lengths from the lowest point, ascending from 0 to [`ARC`] radii.
    pub arcs: Vec<f64>,
    /// Depths below the rim, ascending from 0 to [`TO_CORE`] radii.
    pub depths: Vec<f64>,
    /// Elements around the rest of the rim.
    pub rest: usize,
    /// Nodes along the axis of the disc, z.
    pub layers: Vec<f64>,
}

/// Ascending lengths as shares of the last.
fn shares(lengths: &[f64]) -> Vec<f64> {
    let total = lengths.last().copied().unwrap_or(1.0);
    lengths.iter().map(|s| s / total).collect()
}

impl QuarterDisc {
    /// The quarter x ≥ 0, y ≤ `radius` of the disc about (0, `radius`), which touches y = 0 at the
    /// origin: a sector over the graded arc, a sector beside it, and a core. One body without
    /// surfaces.
    pub fn build(&self, name: &str) -> Result<Mesh, FamilyError> {
        let radius = self.radius;
        let (core, corner) = ((1.0 - TO_CORE) * radius, 0.42 * radius);
        let (round, deep) = (shares(&self.arcs), shares(&self.depths));
        let upper = uniform(0.0, 1.0, self.rest);
        // In the plane of the disc, v downward from the centre; y = radius − v.
        let bottom = |f: f64| [corner * f, core + (corner - core) * f];
        let side = |g: f64| [corner + (core - corner) * g, corner * (1.0 - g)];
        let sector = |angle: f64, inner: [f64; 2], t: f64| {
            let arc = [radius * angle.sin(), radius * angle.cos()];
            let x = arc[0] + (inner[0] - arc[0]) * t;
            [x, radius - (arc[1] + (inner[1] - arc[1]) * t)]
        };
        let layers = || self.layers.clone();
        let lower =
            Block::new("sector", round.clone(), deep.clone(), layers()).mapped(|[f, t, z]| {
                let [x, y] = sector(f * ARC, bottom(f), t);
                [x, y, z]
            });
        let beside = Block::new("beside", upper.clone(), deep, layers()).mapped(|[g, t, z]| {
            let [x, y] = sector((1.0 + g) * ARC, side(g), t);
            [x, y, z]
        });
        // Transfinite interpolation between the core's four sides.
        let core = Block::new("core", round, upper, layers()).mapped(|[f, g, z]| {
            let (low, right) = (bottom(f), side(g));
            let (top, left) = ([f * core, 0.0], [0.0, core * (1.0 - g)]);
            let corners = [[0.0, core], [corner, corner], [0.0, 0.0], [core, 0.0]];
            let [x, v] = [0, 1].map(|i| {
                (1.0 - g) * low[i] + g * top[i] + (1.0 - f) * left[i] + f * right[i]
                    - (1.0 - f) * ((1.0 - g) * corners[0][i] + g * corners[2][i])
                    - f * ((1.0 - g) * corners[1][i] + g * corners[3][i])
            });
            [x, radius - v, z]
        });
        let parts = [lower.build()?, beside.build()?, core.build()?];
        Ok(Mesh::weld(name, parts, 1e-9 * radius)?)
    }
}
