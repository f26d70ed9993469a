//! Stress at nodes and in elements from the stress at integration points.

use crate::model::mesh::hexahedron::gauss_volumes;
use std::collections::BTreeMap;

use rayon::prelude::*;

use super::hex::GaussRule;
use super::tensor::{mean, mises};
use crate::model::mesh::Mesh;
use crate::model::scene::Scene;
use crate::model::state::State;

/// Components of the stress whose sign a mirror along each axis turns.
const SHEARS: [[usize; 2]; 3] = [[3, 5], [3, 4], [4, 5]];

/// No body: the owner of a node that no element uses.
const NOBODY: u32 = u32::MAX;

/// The points that carry nodal averages: every mesh node, then a twin of a node for each further
/// body that shares it, because stresses are never averaged across bodies.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct BodyPoints {
    /// Mesh node of each point; the first are the mesh nodes themselves, in their order.
    pub node: Vec<u32>,
    /// Points at the corners of each element.
    pub cells: Vec<[u32; 8]>,
    body: Vec<u32>,
}

impl BodyPoints {
    /// Numbers the points of `mesh`.
    pub fn new(mesh: &Mesh) -> Self {
        let mut node: Vec<u32> = (0..mesh.points.len() as u32).collect();
        let mut body = vec![NOBODY; node.len()];
        let mut cells = mesh.hexes.clone();
        for (b, part) in (0u32..).zip(&mesh.bodies) {
            let mut twins: BTreeMap<u32, u32> = BTreeMap::new();
            for cell in &mut cells[part.elements.clone()] {
                for corner in cell {
                    let owner = &mut body[*corner as usize];
                    if *owner == NOBODY {
                        *owner = b;
                    }
                    if *owner != b {
                        *corner = *twins.entry(*corner).or_insert_with(|| {
                            node.push(*corner);
                            body.push(b);
                            node.len() as u32 - 1
                        });
                    }
                }
            }
        }
        Self { node, cells, body }
    }

    /// The body whose elements are averaged at `point`; `None` where no element uses the node.
    pub fn body_of(&self, point: usize) -> Option<usize> {
        self.body
            .get(point)
            .filter(|b| **b != NOBODY)
            .map(|b| *b as usize)
    }
}

/// Fields for reading, recovered from integration points.
#[derive(Debug, Clone, Default)]
pub struct Recovered {
    /// What carries the nodal values.
    pub points: BodyPoints,
    /// Stress xx yy zz xy yz zx at each of [`BodyPoints`]: extrapolated in each element, averaged
    /// over the elements of one body; zero where no element uses the node.
    pub nodal_stress: Vec<[f64; 6]>,
    /// Mises stress of that average.
    pub mises_nodal: Vec<f64>,
    /// Per element: Mises stress of the mean of its integration-point stresses.
    pub mises_mean: Vec<f64>,
    /// Per element: largest Mises stress at an integration point.
    pub mises_max: Vec<f64>,
    /// Per element: largest equivalent plastic strain at an integration point.
    pub peeq: Vec<f64>,
    /// Volume that each integration point stands for, modelled part only.
    pub volumes: Vec<[f64; 8]>,
}

/// Recovers the fields of `state` on the mesh of `scene`; `state` has passed [`State::check`].
pub fn recover(scene: &Scene, state: &State) -> Recovered {
    let mesh = &scene.mesh;
    let rule = GaussRule::new();
    let points = BodyPoints::new(mesh);
    let nodal_stress = nodal_average(&rule, &points, scene, state);
    let stress = || state.stress.par_iter();
    let elements = || (0..mesh.hexes.len()).into_par_iter();
    Recovered {
        mises_nodal: nodal_stress.par_iter().map(mises).collect(),
        nodal_stress,
        mises_mean: stress().map(|s| mises(&mean(s))).collect(),
        mises_max: stress().map(|s| largest(s.iter().map(mises))).collect(),
        peeq: elements().map(|e| largest(state.peeq_of(e))).collect(),
        volumes: elements()
            .map(|e| gauss_volumes(&mesh.corners(e)))
            .collect(),
        points,
    }
}

/// Extrapolated in parallel, a batch at a time; summed in the order of the elements.
fn nodal_average(
    rule: &GaussRule,
    points: &BodyPoints,
    scene: &Scene,
    state: &State,
) -> Vec<[f64; 6]> {
    const BATCH: usize = 4096;
    let mut sum = vec![[0.0; 6]; points.node.len()];
    let mut count = vec![0u32; points.node.len()];
    for (cells, stress) in (points.cells.chunks(BATCH)).zip(state.stress.chunks(BATCH)) {
        let corners: Vec<_> = stress.par_iter().map(|s| rule.extrapolate(s)).collect();
        for (point, value) in cells.as_flattened().iter().zip(corners.as_flattened()) {
            count[*point as usize] += 1;
            for (s, v) in sum[*point as usize].iter_mut().zip(value) {
                *s += v;
            }
        }
    }
    for ((s, n), node) in sum.iter_mut().zip(count).zip(&points.node) {
        *s = symmetric(scene, *node, s.map(|v| v / f64::from(n.max(1))));
    }
    sum
}

/// An average of stresses at a node, with what the elements beyond mirror planes through it bring: the opposite shears.
pub fn symmetric(scene: &Scene, node: u32, mut average: [f64; 6]) -> [f64; 6] {
    for axis in scene.mirrors_through(&scene.mesh.points[node as usize]) {
        for shear in SHEARS[axis] {
            average[shear] = 0.0;
        }
    }
    average
}

/// A stress as the mirror plane across `axis` shows it.
pub(super) fn mirrored(mut stress: [f64; 6], axis: usize) -> [f64; 6] {
    for shear in SHEARS[axis] {
        stress[shear] = -stress[shear];
    }
    stress
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}
