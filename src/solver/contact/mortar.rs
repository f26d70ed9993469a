//! The mortar operator of a contact pair: constant, with one row a carrier node.
//!
//! Nodes of two meshes in contact do not lie opposite each other. A mortar method compares the sides in the
//! mean instead (Puso and Laursen, CMAME 193 (2004) 601). At carrier node A with the hat function N_A (one
//! at A, zero at all other nodes, bilinear on each facet) the relative displacement is
//!
//! ```text
//! d_A = (1/w_A) ∫ N_A (u_carrier − u_opposite) dA,    w_A = ∫ N_A dA                          (1)
//! ```
//!
//! over the part of the carrier that the other side covers, and the initial gap is the same mean of the gap
//! between the true surfaces. As displacements are interpolated by hat functions too, (1) is a sum over nodes
//! with the constant coefficients
//!
//! ```text
//! (1/w_A) ∫ N_A N_B dA       node B of the carrier
//! −(1/w_A) ∫ N_A M_B dA      node B of the other side, M_B its hat function                     (2)
//! ```
//!
//! A traction z_A at the node (what the carrier does to the other side, force per area) does the work
//! w_A z_A · d_A. So the nodal forces are w_A z_A times the coefficients (2): by virtual work, with the same
//! integrals. As the coefficients of each side sum to one, the forces on both sides balance to the last digit,
//! and a uniform pressure is passed on exactly by meshes that do not match (patch test).
//!
//! The work is shared out so: `segment` finds the quadrature points where two facets overlap, `projection`
//! gathers all overlaps of one carrier facet in a `Piece`, `node_sum` adds up the pieces around a node and
//! makes the [`Row`] of it, `sliver` takes care of nodes that are hardly covered.

use super::node_sum::NodeSum;
pub use super::pair::{Opposite, Pair};
use super::projection;
pub use super::row::Row;
use super::search::FacetTree;
use super::side::Side;
use super::{facet, sliver};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The rows of a pair: of every carrier node that faces the other side within reach.
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
    // In parallel over carrier facets. They are summed in their order, so that the number of threads
    // changes no digit.
    let pieces: Vec<_> = (0..carrier.nodes.len())
        .into_par_iter()
        .map(|index| match (&pair.opposite, &opposite, &tree) {
            (Opposite::Plane { point, normal }, _, _) => {
                projection::on_plane(pair, &carrier, index, *point, *normal)
            }
            (_, Some(opposite), Some(tree)) => {
                projection::on_surface(pair, &carrier, index, opposite, tree)
            }
            _ => None,
        })
        .collect();
    let mut nodes: BTreeMap<u32, NodeSum> = BTreeMap::new();
    for (index, (piece, own)) in pieces.iter().zip(&carrier.nodes).enumerate() {
        let area = facet::area(&carrier.corners[index]);
        for (a, node) in own.iter().enumerate() {
            let sum = nodes.entry(*node).or_default();
            sum.add_facet(area);
            if let Some(piece) = piece {
                sum.add(piece, a, own);
            }
        }
    }
    share_hanging(&mut nodes, pair);
    let covered = pieces.iter().zip(&carrier.nodes);
    let covered = covered.filter_map(|(piece, own)| piece.as_ref().map(|_| *own));
    sliver::absorb(&mut nodes, pair.follow, covered);
    nodes
        .into_iter()
        .filter_map(|(node, sum)| sum.finish(node, pair))
        .collect()
}

/// A node that hangs has no multiplier of its own: its hat function is shared out to those of the nodes that it moves with,
/// so that tractions are continuous, as displacements are, where facets of two sizes meet.
fn share_hanging(nodes: &mut BTreeMap<u32, NodeSum>, pair: &Pair) {
    // What hangs on a hanging node comes after it.
    for hanging in pair.mesh.hanging.iter().rev() {
        let is_here = |node: &u32| nodes.contains_key(node);
        if !is_here(&hanging.node) || !hanging.corners.iter().all(is_here) {
            continue;
        }
        let Some(sum) = nodes.remove(&hanging.node) else {
            continue;
        };
        let share = 1.0 / hanging.corners.len() as f64;
        for corner in &hanging.corners {
            if let Some(master) = nodes.get_mut(corner) {
                master.take(hanging.node, &sum, share);
            }
        }
    }
}
