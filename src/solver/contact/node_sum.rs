//! What the facets around one carrier node add up to, and the row that becomes of it.

use super::gathered::Gathered;
use super::pair::Pair;
use super::piece::Piece;
use super::row::Row;
use crate::ground::geometry::{Vec3, add, cross, dot, planes_through, scale, tangents, unit};
use crate::ground::order::ascending;
use std::collections::BTreeMap;

/// A node is on a plane that is held, and its normal in it, to within this share: coordinates are rounded.
const ROUNDING: f64 = 1e-9;

/// The integrals over all facets around a carrier node.
#[derive(Default)]
pub(super) struct NodeSum {
    gathered: Gathered,
    /// w_A times the coefficients of the row.
    terms: BTreeMap<u32, Vec3>,
    /// Areas of the facets around the node, covered by the other side or not, and their number.
    facets: (f64, u32),
    /// Nodes whose integrals were taken over.
    absorbed: Vec<u32>,
}

impl NodeSum {
    /// Counts a facet around the node.
    pub fn add_facet(&mut self, area: f64) {
        self.facets.0 += area;
        self.facets.1 += 1;
    }

    /// The area of the other side before the node, w_A, over the mean area of a facet around it: 1 in the middle of
    /// an even mesh that is covered, less at a rim, next to nothing where a sliver covers it.
    pub fn covered(&self) -> f64 {
        let (areas, number) = self.facets;
        self.gathered.area * f64::from(number) / areas
    }

    /// Takes over all that `other`, the sum of `node`, has gathered.
    pub fn absorb(&mut self, node: u32, other: &Self) {
        self.take(node, other, 1.0);
    }

    /// Takes over a share of it.
    pub fn take(&mut self, node: u32, other: &Self, share: f64) {
        self.gathered.add(&other.gathered.times(share));
        for (n, value) in &other.terms {
            let term = self.terms.entry(*n).or_default();
            *term = add(*term, scale(*value, share));
        }
        self.absorbed.push(node);
        self.absorbed.extend(&other.absorbed);
    }

    /// Adds what corner `a` of a facet with the nodes `own` gathers.
    pub fn add(&mut self, piece: &Piece, a: usize, own: &[u32; 4]) {
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

    /// The row of `node`; `None` where it is beyond reach, or has no area or no normal.
    pub fn finish(self, node: u32, pair: &Pair) -> Option<Row> {
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
            normal[*axis].abs() < ROUNDING && (at[*axis] - c).abs() <= ROUNDING * size
        };
        let held = pair.held.iter().filter(holds).map(|(axis, _)| *axis);
        let across = ascending(mirrors.iter().copied().chain(held));
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

/// Tangents of a node that cannot slide along the axes `across`. A condition there would only repeat what
/// the plane already asks of the nodes.
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
