//! The overlaps of one carrier facet with the other side.
//!
//! Which point of the carrier lies opposite which point of the other side is decided by projection along one
//! direction a carrier facet. That direction is the mean normal of both sides over the overlap, which is known
//! only after a projection: it is found by fixed-point iteration, from the facet's own normal. Seen along it,
//! two bodies that are mirror images of each other face each other point by point.

use super::facet::MOST_FACING;
use super::pair::Pair;
use super::piece::{Across, Piece, QuadraturePoint, add_products};
use super::search::FacetTree;
use super::segment::View;
use super::side::Side;
use crate::ground::geometry::{Vec3, dot, norm, scale, sub, unit};

/// What facet `index` of the carrier gathers from the facets of `opposite`; `None` where none overlaps it.
pub(super) fn on_surface(
    pair: &Pair,
    carrier: &Side,
    index: usize,
    opposite: &Side,
    tree: &FacetTree,
) -> Option<Piece> {
    /// Projections at most; the direction changes less from each to the next.
    const PROJECTIONS: usize = 4;
    /// The direction rests where it changes by less than this (the length of a difference of unit vectors).
    const AT_REST: f64 = 1e-10;
    let (corners, normal) = (&carrier.corners[index], carrier.normals[index]);
    let farthest = pair.farthest(corners);
    let facet = Facing {
        index,
        others: tree.near(
            corners,
            // Along the normal as far as counts, and a little to all sides, as the direction is not known yet.
            normal.map(|n| farthest * n.abs() + 0.1 * pair.reach),
        ),
        carrier,
        opposite,
        closely: pair.closely,
    };
    let mut direction = normal;
    let mut out = facet.project(direction, farthest);
    for _ in 1..PROJECTIONS {
        let Some(mean) = unit(out.facing) else { break };
        if norm(sub(mean, direction)) < AT_REST {
            break;
        }
        direction = mean;
        out = facet.project(direction, farthest);
    }
    out.some()
}

/// Cosine between a facet's normal and the direction of projection, at least: seen at a flatter angle than 60
/// degrees the facet is a line rather than an area.
const LEAST_SLANT: f64 = 0.5;

/// A carrier facet, and the facets that may lie opposite.
struct Facing<'a> {
    index: usize,
    others: Vec<usize>,
    carrier: &'a Side,
    opposite: &'a Side,
    closely: bool,
}

impl Facing<'_> {
    /// What the facet gathers when projected along `direction`.
    fn project(&self, direction: Vec3, farthest: f64) -> Piece {
        let (carrier, opposite, index) = (self.carrier, self.opposite, self.index);
        let normal = carrier.normals[index];
        let mut piece = Piece::default();
        if dot(normal, direction) < LEAST_SLANT {
            return piece;
        }
        let mut view = View::new(&carrier.corners[index], normal, direction);
        if self.closely {
            view = view.closely();
        }
        for &other in &self.others {
            if dot(normal, opposite.normals[other]) > MOST_FACING {
                continue;
            }
            let stiffness = series(carrier.stiffness[index], opposite.stiffness[other]);
            let mut products = [[0.0; 4]; 4];
            view.overlap(&opposite.corners[other], |point| {
                let (xs, ns) = carrier.at(index, &point.carrier);
                let (xm, nm) = opposite.at(other, &point.opposite);
                let gap = sub(xm, xs);
                if dot(gap, normal).abs() > farthest {
                    return;
                }
                add_products(&mut products, &point.carrier, &point.opposite, point.area);
                piece.add(&QuadraturePoint {
                    point,
                    gap,
                    normals: [ns, nm],
                    stiffness,
                });
            });
            if products != [[0.0; 4]; 4] {
                piece.across.push(Across {
                    nodes: opposite.nodes[other],
                    signs: opposite.signs[other],
                    products,
                });
            }
        }
        piece
    }
}

/// What facet `index` of the carrier gathers from a rigid half space: all of the facet, as far as it is near.
pub(super) fn on_plane(
    pair: &Pair,
    carrier: &Side,
    index: usize,
    origin: Vec3,
    normal: Vec3,
) -> Option<Piece> {
    let facing = carrier.normals[index];
    if dot(facing, normal) > MOST_FACING {
        return None;
    }
    let farthest = pair.farthest(&carrier.corners[index]);
    let mut piece = Piece::default();
    View::new(&carrier.corners[index], facing, facing).whole(|point| {
        let (x, _) = carrier.at(index, &point.carrier);
        let distance = dot(sub(x, origin), normal);
        if distance.abs() <= farthest {
            piece.add(&QuadraturePoint {
                point,
                gap: scale(normal, -distance),
                normals: [scale(normal, -1.0), normal],
                stiffness: carrier.stiffness[index],
            });
        }
    });
    piece.some()
}

/// Stiffness of two layers in series.
fn series(a: f64, b: f64) -> f64 {
    a * b / (a + b)
}
