//! The constant contact operator of a pair: one row a carrier node.
//!
//! At carrier node A with hat function N_A the pair sees the weighted mean of the relative
//! displacement, d_A = (1/w_A) ∫ N_A (u_carrier − u_opposite) dA, w_A = ∫ N_A dA, and likewise of
//! the initial gap. A contact traction z_A (the force that the carrier puts on the other side,
//! per area) acts on both sides with the same integrals, so that forces balance exactly and a
//! uniform pressure passes the patch test on meshes that do not match.

use super::piece::{self, Gathered, Piece};
use super::search::FacetTree;
use super::side::{self, Side};
use super::sliver;
use crate::ground::geometry::{
    Vec3, add, cross, dot, norm, planes_through, scale, sub, tangents, unit,
};
use crate::model::mesh::{Mesh, Surface};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Contact row of one carrier node.
#[derive(Debug, Clone)]
pub struct Row {
    /// The carrier node.
    pub node: u32,
    /// Carrier nodes beside it that it stands for, too: the other side covers but a sliver of theirs.
    pub absorbed: Vec<u32>,
    /// Area w_A that the node stands for, covered by the other side.
    pub area: f64,
    /// d_A = Σ coefficient · displacement over nodes of both sides (other side negative), axis by
    /// axis: across a mirror plane the images of nodes take part, which move the other way.
    pub terms: Vec<(u32, [f64; 3])>,
    /// Unit normal from the carrier to the other side.
    pub normal: Vec3,
    /// Two tangents; `None` without friction. On a mirror plane, and on one that both sides are held
    /// on, the one across it is zero: there they slide by nothing.
    pub tangents: Option<[Vec3; 2]>,
    /// Initial gap, open positive.
    pub gap: f64,
    /// Traction over the closure that it makes, in magnitude: the scale of the penalty. That of the material next to
    /// the contact, and more where the other side covers little, for so little area moves little.
    pub stiffness: f64,
}

impl Row {
    /// The nodes that the row is of.
    pub fn nodes(&self) -> impl Iterator<Item = u32> {
        [self.node].into_iter().chain(self.absorbed.iter().copied())
    }
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
    /// Planes, by axis and coordinate, across which neither side moves.
    pub held: &'a [(usize, f64)],
}

impl Pair<'_> {
    /// The largest gap at a point of a facet that counts: all of the facet does where a row on it
    /// is within reach, however coarse the mesh.
    pub fn farthest(&self, facet: &[Vec3; 4]) -> f64 {
        let diagonals = [sub(facet[2], facet[0]), sub(facet[3], facet[1])];
        4.0 * self.reach + diagonals.map(norm).into_iter().fold(0.0, f64::max)
    }
}

/// What the facets around a carrier node add up to.
#[derive(Default)]
pub(super) struct Sum {
    gathered: Gathered,
    terms: BTreeMap<u32, Vec3>,
    /// Areas of the facets around the node, covered by the other side or not, and their number.
    facets: (f64, u32),
    absorbed: Vec<u32>,
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
                piece::on_plane(pair, &carrier, index, *point, *normal)
            }
            (_, Some(opposite), Some(tree)) => {
                piece::on_surface(pair, &carrier, index, opposite, tree)
            }
            _ => None,
        })
        .collect();
    let mut nodes: BTreeMap<u32, Sum> = BTreeMap::new();
    for (index, (piece, own)) in pieces.iter().zip(&carrier.nodes).enumerate() {
        let area = side::area(&carrier.corners[index]);
        for (a, node) in own.iter().enumerate() {
            let sum = nodes.entry(*node).or_default();
            sum.facets.0 += area;
            sum.facets.1 += 1;
            if let Some(piece) = piece {
                sum.add(piece, a, own);
            }
        }
    }
    let covered = pieces.iter().zip(&carrier.nodes);
    let covered = covered.filter_map(|(piece, own)| piece.as_ref().map(|_| *own));
    sliver::absorb(&mut nodes, covered);
    nodes
        .into_iter()
        .filter_map(|(node, sum)| sum.finish(node, pair))
        .collect()
}

impl Sum {
    /// What the other side covers of the area that the node stands for, over that of a facet around it.
    pub fn covered(&self) -> f64 {
        let (areas, number) = self.facets;
        self.gathered.area * f64::from(number) / areas
    }

    /// Takes over all that `other`, the sum of `node`, has gathered.
    pub fn absorb(&mut self, node: u32, other: Self) {
        self.gathered.add(&other.gathered);
        for (n, value) in other.terms {
            let term = self.terms.entry(n).or_default();
            *term = add(*term, value);
        }
        self.absorbed.push(node);
        self.absorbed.extend(other.absorbed);
    }

    /// Adds what corner `a` of a facet with the nodes `own` gathers.
    fn add(&mut self, piece: &Piece, a: usize, own: &[u32; 4]) {
        self.gathered.add(&piece.corners[a]);
        let mut term = |node: u32, value: Vec3| {
            let term = self.terms.entry(node).or_default();
            *term = add(*term, value);
        };
        for (b, n) in own.iter().zip(piece.products[a]) {
            term(*b, [n; 3]);
        }
        for across in &piece.across {
            for (b, n) in across.nodes.iter().zip(across.products[a]) {
                term(*b, scale(across.signs, -n));
            }
        }
    }

    fn finish(self, node: u32, pair: &Pair) -> Option<Row> {
        let at = &pair.mesh.points[node as usize];
        let covered = self.covered();
        let mirrors: Vec<usize> = planes_through(pair.mirrors, at).collect();
        let Gathered {
            area,
            gap,
            stiffness,
            ..
        } = self.gathered;
        let mut normal = self.gathered.normal();
        // On a mirror plane the other half turns the mean normal into the plane.
        mirrors.iter().for_each(|axis| normal[*axis] = 0.0);
        let normal = unit(normal)?;
        if area <= 0.0 {
            return None;
        }
        let gap = dot(gap, normal) / area;
        let size = at.iter().fold(0.0f64, |size, c| size.max(c.abs()));
        let holds = |(axis, c): &&(usize, f64)| {
            normal[*axis].abs() < 1e-9 && (at[*axis] - c).abs() <= 1e-9 * size
        };
        let held = pair.held.iter().filter(holds).map(|(axis, _)| *axis);
        let mut across: Vec<usize> = mirrors.iter().copied().chain(held).collect();
        across.sort_unstable();
        across.dedup();
        (gap <= pair.reach).then(|| Row {
            node,
            absorbed: self.absorbed,
            area,
            terms: self
                .terms
                .into_iter()
                .map(|(n, c)| (n, c.map(|c| c / area)))
                .collect(),
            normal,
            tangents: pair.friction.then(|| free_tangents(normal, &across)),
            gap,
            stiffness: stiffness / (area * covered),
        })
    }
}

/// Tangents of a node that slides along no axis of `across`. A condition there would ask of the nodes
/// beside it what the plane already says.
fn free_tangents(normal: Vec3, across: &[usize]) -> [Vec3; 2] {
    match across {
        [] => tangents(normal),
        [axis] => {
            let mut unit = [0.0; 3];
            unit[*axis] = 1.0;
            [cross(unit, normal), [0.0; 3]]
        }
        _ => [[0.0; 3]; 2],
    }
}
