//! The constant contact operator of a pair: one row a carrier node.
//!
//! At carrier node A with hat function N_A the pair sees the weighted mean of the relative
//! displacement, d_A = (1/w_A) ∫ N_A (u_carrier − u_opposite) dA, w_A = ∫ N_A dA, and likewise of
//! the initial gap. A contact traction z_A (the force that the carrier puts on the other side,
//! per area) acts on both sides with the same integrals, so that forces balance exactly and a
//! uniform pressure passes the patch test on meshes that do not match.

use super::search::FacetTree;
use super::segment::{SegmentPoint, View};
use super::side::Side;
use crate::geometry::{Vec3, add, cross, dot, norm, planes_through, scale, sub, tangents, unit};
use crate::mesh::{Mesh, Surface};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Contact row of one carrier node.
#[derive(Debug, Clone)]
pub struct Row {
    /// The carrier node.
    pub node: u32,
    /// Area w_A that the node stands for, covered by the other side.
    pub area: f64,
    /// d_A = Σ coefficient · displacement over nodes of both sides (other side negative), axis by
    /// axis: across a mirror plane the images of nodes take part, which move the other way.
    pub terms: Vec<(u32, [f64; 3])>,
    /// Unit normal from the carrier to the other side.
    pub normal: Vec3,
    /// Two tangents; `None` without friction. On a mirror plane the one across it is zero: there
    /// the two halves slide apart by nothing.
    pub tangents: Option<[Vec3; 2]>,
    /// Initial gap, open positive.
    pub gap: f64,
    /// Stiffness per area of the material next to the contact: the scale of the penalty.
    pub stiffness: f64,
}

/// The other side of a pair.
pub enum Opposite<'a> {
    Surface(&'a Surface),
    /// A rigid half space; outward unit normal.
    Plane {
        point: Vec3,
        normal: Vec3,
    },
}

/// What the integration needs to know of a pair.
pub struct Pair<'a> {
    pub mesh: &'a Mesh,
    pub carrier: &'a Surface,
    pub opposite: Opposite<'a>,
    /// Replace facets by the cylinder, sphere or plane that they stand for.
    pub true_geometry: bool,
    /// Does it rub?
    pub friction: bool,
    /// Rows with a larger initial gap are left out.
    pub reach: f64,
    /// Young's modulus over 1 − ν² of each body.
    pub moduli: &'a [f64],
    /// Axes whose coordinate planes mirror the model.
    pub mirrors: &'a [usize],
}

impl Pair<'_> {
    /// The largest gap at a point of a facet that counts: all of the facet does where a row on it
    /// is within reach, however coarse the mesh.
    fn farthest(&self, facet: &[Vec3; 4]) -> f64 {
        let diagonals = [sub(facet[2], facet[0]), sub(facet[3], facet[1])];
        4.0 * self.reach + diagonals.map(norm).into_iter().fold(0.0, f64::max)
    }
}

/// What a facet pair adds to the row of a carrier node.
#[derive(Default)]
struct Accumulated {
    area: f64,
    terms: BTreeMap<u32, Vec3>,
    normal: Vec3,
    gap: Vec3,
    stiffness: f64,
}

/// Integrates a pair.
pub fn rows(pair: &Pair) -> Vec<Row> {
    let carrier = Side::new(pair, pair.carrier);
    let opposite = match pair.opposite {
        Opposite::Surface(surface) => {
            let farthest = carrier.corners.iter().map(|facet| pair.farthest(facet));
            let farthest = farthest.fold(0.0, f64::max);
            Some(Side::new(pair, surface).with_images(pair.mirrors, farthest))
        }
        Opposite::Plane { .. } => None,
    };
    let tree = opposite.as_ref().map(|side| FacetTree::new(&side.corners));
    // In parallel over carrier facets; summed below in their order, whatever the thread count.
    let pieces: Vec<_> = (0..carrier.nodes.len())
        .into_par_iter()
        .map(|index| match (&pair.opposite, &opposite, &tree) {
            (Opposite::Plane { point, normal }, _, _) => {
                facet_on_plane(pair, &carrier, index, *point, *normal)
            }
            (_, Some(opposite), Some(tree)) => {
                facet_on_surface(pair, &carrier, index, opposite, tree)
            }
            _ => Vec::new(),
        })
        .collect();
    let mut nodes: BTreeMap<u32, Accumulated> = BTreeMap::new();
    for point in pieces.iter().flatten() {
        point.add_to(&mut nodes);
    }
    nodes
        .into_iter()
        .filter_map(|(node, sum)| sum.finish(node, pair))
        .collect()
}

/// A quadrature point with everything that its carrier nodes gather.
struct Contribution {
    carrier_nodes: [u32; 4],
    /// Nodes of the opposite facet, and the signs of its image.
    opposite: Option<([u32; 4], Vec3)>,
    point: SegmentPoint,
    gap: Vec3,
    normal: Vec3,
    stiffness: f64,
}

impl Contribution {
    fn add_to(&self, nodes: &mut BTreeMap<u32, Accumulated>) {
        for (a, shape) in self.carrier_nodes.iter().zip(self.point.carrier) {
            let weight = shape * self.point.area;
            let sum = nodes.entry(*a).or_default();
            sum.area += weight;
            sum.stiffness += weight * self.stiffness;
            sum.normal = add(sum.normal, scale(self.normal, weight));
            sum.gap = add(sum.gap, scale(self.gap, weight));
            let mut term = |node: &u32, value: Vec3| {
                let term = sum.terms.entry(*node).or_default();
                *term = add(*term, value);
            };
            for (b, n) in self.carrier_nodes.iter().zip(self.point.carrier) {
                term(b, [weight * n; 3]);
            }
            if let Some((nodes, signs)) = &self.opposite {
                for (b, n) in nodes.iter().zip(self.point.opposite) {
                    term(b, scale(*signs, -weight * n));
                }
            }
        }
    }
}

impl Accumulated {
    fn finish(self, node: u32, pair: &Pair) -> Option<Row> {
        let at = &pair.mesh.points[node as usize];
        let mirrors: Vec<usize> = planes_through(pair.mirrors, at).collect();
        let mut normal = self.normal;
        // On a mirror plane the other half turns the mean normal into the plane.
        mirrors.iter().for_each(|axis| normal[*axis] = 0.0);
        let normal = unit(normal)?;
        if self.area <= 0.0 {
            return None;
        }
        let gap = dot(self.gap, normal) / self.area;
        (gap <= pair.reach).then(|| Row {
            node,
            area: self.area,
            terms: self
                .terms
                .into_iter()
                .map(|(n, c)| (n, c.map(|c| c / self.area)))
                .collect(),
            normal,
            tangents: pair.friction.then(|| free_tangents(normal, &mirrors)),
            gap,
            stiffness: self.stiffness / self.area,
        })
    }
}

/// Tangents of a node on the planes of `mirrors`: it moves within them only.
fn free_tangents(normal: Vec3, mirrors: &[usize]) -> [Vec3; 2] {
    match mirrors {
        [] => tangents(normal),
        [axis] => {
            let mut across = [0.0; 3];
            across[*axis] = 1.0;
            [cross(across, normal), [0.0; 3]]
        }
        _ => [[0.0; 3]; 2],
    }
}

/// The facet is projected along the mean normal of both sides, found in a few passes: seen so, two
/// bodies that are mirror images face each other point by point.
fn facet_on_surface(
    pair: &Pair,
    carrier: &Side,
    index: usize,
    opposite: &Side,
    tree: &FacetTree,
) -> Vec<Contribution> {
    const PASSES: usize = 4;
    const SAME: f64 = 1e-10;
    let (corners, normal) = (&carrier.corners[index], carrier.normals[index]);
    let farthest = pair.farthest(corners);
    let facet = Facing {
        index,
        others: tree.near(
            corners,
            normal.map(|n| farthest * n.abs() + 0.1 * pair.reach),
        ),
        carrier,
        opposite,
    };
    let mut direction = normal;
    let mut out = facet.project(direction, farthest);
    for _ in 1..PASSES {
        let sum = out
            .iter()
            .fold([0.0; 3], |sum, c| add(sum, scale(c.normal, c.point.area)));
        let Some(mean) = unit(sum) else { break };
        if norm(sub(mean, direction)) < SAME {
            break;
        }
        direction = mean;
        out = facet.project(direction, farthest);
    }
    out
}

/// A carrier facet and what may lie opposite.
struct Facing<'a> {
    index: usize,
    others: Vec<usize>,
    carrier: &'a Side,
    opposite: &'a Side,
}

impl Facing<'_> {
    /// What the facet gathers when projected along `direction`.
    fn project(&self, direction: Vec3, farthest: f64) -> Vec<Contribution> {
        let (carrier, opposite, index) = (self.carrier, self.opposite, self.index);
        let normal = carrier.normals[index];
        let mut out = Vec::new();
        if dot(normal, direction) < 0.5 {
            return out;
        }
        let view = View::new(&carrier.corners[index], normal, direction);
        for &other in &self.others {
            if dot(normal, opposite.normals[other]) > -0.3 {
                continue;
            }
            for point in view.overlap(&opposite.corners[other]) {
                let (xs, ns) = carrier.at(index, &point.carrier);
                let (xm, nm) = opposite.at(other, &point.opposite);
                let gap = sub(xm, xs);
                if dot(gap, normal).abs() > farthest {
                    continue;
                }
                out.push(Contribution {
                    carrier_nodes: carrier.nodes[index],
                    opposite: Some((opposite.nodes[other], opposite.signs[other])),
                    point,
                    gap,
                    normal: sub(ns, nm),
                    stiffness: series(carrier.stiffness[index], opposite.stiffness[other]),
                });
            }
        }
        out
    }
}

fn facet_on_plane(
    pair: &Pair,
    carrier: &Side,
    index: usize,
    origin: Vec3,
    normal: Vec3,
) -> Vec<Contribution> {
    let facing = carrier.normals[index];
    let farthest = pair.farthest(&carrier.corners[index]);
    if dot(facing, normal) > -0.3 {
        return Vec::new();
    }
    let mut out = Vec::new();
    for point in View::new(&carrier.corners[index], facing, facing).whole() {
        let (x, _) = carrier.at(index, &point.carrier);
        let distance = dot(sub(x, origin), normal);
        if distance.abs() > farthest {
            continue;
        }
        out.push(Contribution {
            carrier_nodes: carrier.nodes[index],
            opposite: None,
            point,
            gap: scale(normal, -distance),
            normal: scale(normal, -1.0),
            stiffness: carrier.stiffness[index],
        });
    }
    out
}

/// Two layers in series.
fn series(a: f64, b: f64) -> f64 {
    a * b / (a + b)
}
