//! The mortar operator of a tie: what each node of one surface follows on the other.
//!
//! The sides of a tie are joined in the mean, as those of a contact pair are ([`super::mortar`]), but weighted with
//! *dual* functions Φ_A (Wohlmuth, SIAM J. Numer. Anal. 38 (2000) 989): on each facet those combinations of its hat
//! functions with
//!
//! ```text
//! ∫ Φ_A N_B dA = δ_AB ∫ N_B dA,    Φ_A = D_A Σ_B (M⁻¹)_AB N_B,    M_AB = ∫ N_A N_B dA,  D_A = ∫ N_A dA      (1)
//! ```
//!
//! over what the other side covers. Then the condition ∫ Φ_A (u − u_opposite) dA = 0 has one displacement of this side,
//!
//! ```text
//! u_A = Σ_B P_AB u_B,    P_AB = (1/D_A) ∫ Φ_A M_B dA                                                (2)
//! ```
//!
//! and node A follows the nodes B opposite. The Φ_A of a facet sum to one, so that a uniform stress is passed on
//! exactly, and (2) is exact for displacements that are linear along a plane.
//!
//! Where facets of round surfaces do not lie upon each other, node A stands off the mean of the nodes that it follows
//! by g = x_A − Σ P_AB x_B, and (2) alone would strain bodies that turn as one. The node is taken to hang on an arm g
//! that turns with the nodes opposite: u_A = Σ P_AB u_B + ω × g, ω being the turn that fits their displacements
//! best in the mean square. So all rigid motions are free of stress, whatever the meshes.

use super::pair::{Opposite, Pair};
use super::search::FacetTree;
use super::side::Side;
use super::{facet, projection};
use crate::ground::geometry::{Vec3, add, cross, dot, norm, scale, sub, times, unit};
use crate::solver::linear::small::SmallCholesky;
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// What a node of the side that follows is tied to.
pub struct TiedNode {
    pub node: u32,
    /// D_A.
    pub area: f64,
    /// D_A over the mean area of a facet around it: next to nothing where the other side covers a sliver.
    pub covered: f64,
    /// Outward unit normal of the side.
    pub normal: Vec3,
    /// Of each node opposite: the matrix that takes its displacement to that of this node.
    pub terms: Vec<(u32, Matrix3<f64>)>,
    /// Mean distance of the two true surfaces around the node.
    pub distance: f64,
}

/// A tie, integrated over the side that follows.
pub struct Seam {
    pub nodes: Vec<TiedNode>,
    /// Area of the side, as far as the other one covers it, and all of it.
    pub areas: [f64; 2],
}

/// A facet of which less is covered has no part in a tie: its dual functions would be rounding.
const LEAST_COVERED_FACET: f64 = 0.02;

/// An arm shorter than this share of the model is rounding.
const NO_ARM: f64 = 1e-12;

/// What a node gathers from the facets around it.
#[derive(Default)]
struct Sum {
    area: f64,
    facets: (f64, u32),
    gap: Vec3,
    normal: Vec3,
    /// By node opposite and the mirror planes behind which its image is: ∫ Φ_A M_B dA and ∫ N_A M_B dA.
    across: BTreeMap<(u32, [bool; 3]), [f64; 2]>,
}

/// Integrates a tie over the carrier of `pair`, whose nodes follow the other side.
pub fn seam(pair: &Pair) -> Seam {
    let carrier = Side::new(pair, pair.carrier);
    let mut areas = [0.0, carrier.corners.iter().map(facet::area).sum()];
    let Opposite::Surface(surface) = pair.opposite else {
        return Seam {
            nodes: Vec::new(),
            areas,
        };
    };
    let farthest = carrier.corners.iter().map(|facet| pair.farthest(facet));
    let opposite = Side::new(pair, surface).with_images(pair.mirrors, farthest.fold(0.0, f64::max));
    let tree = FacetTree::new(&opposite.corners);
    let pieces: Vec<_> = (0..carrier.nodes.len())
        .into_par_iter()
        .map(|index| projection::on_surface(pair, &carrier, index, &opposite, &tree))
        .collect();
    let mut sums: BTreeMap<u32, Sum> = BTreeMap::new();
    for (index, (piece, own)) in pieces.iter().zip(&carrier.nodes).enumerate() {
        let whole = facet::area(&carrier.corners[index]);
        for node in own {
            let sum = sums.entry(*node).or_default();
            sum.facets = (sum.facets.0 + whole, sum.facets.1 + 1);
        }
        let Some(piece) = piece else { continue };
        let covered: f64 = piece.corners.iter().map(|c| c.area).sum();
        areas[0] += covered;
        let Some(mass) = SmallCholesky::new(piece.products) else {
            continue;
        };
        if covered < LEAST_COVERED_FACET * whole {
            continue;
        }
        for (node, corner) in own.iter().zip(&piece.corners) {
            let sum = sums.entry(*node).or_default();
            sum.area += corner.area;
            sum.gap = add(sum.gap, corner.gap);
            sum.normal = add(sum.normal, corner.normals[0]);
        }
        for across in &piece.across {
            for (b, other) in across.nodes.iter().enumerate() {
                let plain = across.products.map(|row| row[b]);
                let mut dual = plain;
                mass.solve(&mut dual);
                for (a, node) in own.iter().enumerate() {
                    let sum = sums.entry(*node).or_default();
                    let key = (*other, across.signs.map(|s| s < 0.0));
                    let entry = sum.across.entry(key).or_default();
                    entry[0] += piece.corners[a].area * dual[a];
                    entry[1] += plain[a];
                }
            }
        }
    }
    let size = pair
        .mesh
        .points
        .iter()
        .map(|p| norm(*p))
        .fold(0.0, f64::max);
    let nodes = sums.into_iter();
    let nodes = nodes.filter_map(|(node, sum)| sum.finish(node, &pair.mesh.points, size));
    Seam {
        nodes: nodes.collect(),
        areas,
    }
}

impl Sum {
    fn finish(self, node: u32, points: &[Vec3], size: f64) -> Option<TiedNode> {
        if self.area <= 0.0 {
            return None;
        }
        let opposite = self
            .across
            .iter()
            .map(|((other, behind), [dual, plain])| Opposing {
                node: *other,
                at: times(points[*other as usize], signs(*behind)),
                signs: signs(*behind),
                share: dual / self.area,
                weight: plain / self.area,
            });
        let opposite: Vec<Opposing> = opposite.collect();
        let mean = opposite
            .iter()
            .fold([0.0; 3], |sum, o| add(sum, scale(o.at, o.share)));
        let arm = sub(points[node as usize], mean);
        let turns = (norm(arm) > NO_ARM * size)
            .then(|| turns(&opposite))
            .flatten();
        let mut terms: BTreeMap<u32, Matrix3<f64>> = BTreeMap::new();
        for (k, o) in opposite.iter().enumerate() {
            let mut matrix = Matrix3::identity() * o.share;
            if let Some(turns) = &turns {
                // ω × g = −g × ω
                matrix -= skew(arm) * turns[k];
            }
            let mirrored = matrix * Matrix3::from_diagonal(&Vector3::from(o.signs));
            *terms.entry(o.node).or_default() += mirrored;
        }
        let (areas, number) = self.facets;
        Some(TiedNode {
            node,
            area: self.area,
            covered: self.area * f64::from(number) / areas,
            normal: unit(self.normal)?,
            terms: terms.into_iter().collect(),
            distance: norm(self.gap) / self.area,
        })
    }
}

/// A node opposite, or its image.
struct Opposing {
    node: u32,
    at: Vec3,
    signs: Vec3,
    /// P_AB,
    share: f64,
    /// and the same of hat functions, which is not negative.
    weight: f64,
}

/// Of each node the matrix that takes its displacement to its part in the turn ω that fits all of them best:
/// ω = J⁻¹ Σ w r × u, J = Σ w (r² 1 − r rᵀ), with r from the weighted mean of the nodes. `None` where they lie on a
/// line.
fn turns(nodes: &[Opposing]) -> Option<Vec<Matrix3<f64>>> {
    let whole: f64 = nodes.iter().map(|o| o.weight).sum();
    let mean = nodes
        .iter()
        .fold([0.0; 3], |sum, o| add(sum, scale(o.at, o.weight / whole)));
    let mut inertia = Matrix3::zeros();
    for o in nodes {
        let r = sub(o.at, mean);
        let outer = Vector3::from(r) * Vector3::from(r).transpose();
        inertia += (Matrix3::identity() * dot(r, r) - outer) * o.weight;
    }
    let inverse = inertia.try_inverse()?;
    let of = |o: &Opposing| inverse * skew(sub(o.at, mean)) * o.weight;
    Some(nodes.iter().map(of).collect())
}

/// The matrix of a ×.
fn skew(a: Vec3) -> Matrix3<f64> {
    let column = |axis: usize| {
        let mut unit = [0.0; 3];
        unit[axis] = 1.0;
        Vector3::from(cross(a, unit))
    };
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}

fn signs(behind: [bool; 3]) -> Vec3 {
    behind.map(|b| if b { -1.0 } else { 1.0 })
}
