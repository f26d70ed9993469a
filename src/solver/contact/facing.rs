//! Where two surfaces face each other, and how far apart they are: a look that no contact row takes
//! part in.
//!
//! From each node and each facet's middle on either side the true surface of the other side is sought
//! along the normal. A displacement then changes the gap at such a [`Sight`] by the relative motion
//! of the two points that it joins. So overlap is found wherever bodies meet, whether or not the
//! contact operator was prepared for it there.

use super::mortar::{Opposite, Pair};
use super::search::FacetTree;
use super::segment::{self, interpolate};
use super::side::Side;
use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub, unit};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// A point of one side, and the point of the other side that it sees along its normal.
#[derive(Debug, Clone)]
pub struct Sight {
    /// The node of the carrier that looks; `None` for the middle of a facet and for the other side.
    pub node: Option<u32>,
    /// Nodes of the carrier facet at this end or that, with their shape functions.
    pub carrier: ([u32; 4], [f64; 4]),
    /// The same of the opposite facet with the signs of its image, see [`Side::signs`]; `None` for a
    /// rigid plane.
    opposite: Option<([u32; 4], [f64; 4], Vec3)>,
    /// Unit normal from the carrier to the other side.
    normal: Vec3,
    /// Undeformed gap, open positive.
    pub gap: f64,
    /// Overlap that flat facets make of round bodies.
    pub sagitta: f64,
}

impl Sight {
    /// From the middle of a facet of the carrier?
    pub fn is_middle(&self) -> bool {
        self.node.is_none() && self.carrier.1 == [0.25; 4]
    }

    /// The gap under the displacements `u`, open positive.
    pub fn gap_at(&self, u: &[[f64; 3]]) -> f64 {
        let at =
            |nodes: &[u32; 4], shape: &[f64; 4]| interpolate(&nodes.map(|n| u[n as usize]), shape);
        let mut moved = at(&self.carrier.0, &self.carrier.1);
        if let Some((nodes, shape, signs)) = &self.opposite {
            let other = at(nodes, shape);
            moved = [0, 1, 2].map(|i| moved[i] - signs[i] * other[i]);
        }
        self.gap - dot(moved, self.normal)
    }
}

/// All sights of a pair whose undeformed gap is at most `distance`, both ways.
pub fn sights(pair: &Pair, distance: f64) -> Vec<Sight> {
    let carrier = Viewer::new(Side::new(pair, pair.carrier));
    let surface = match pair.opposite {
        Opposite::Surface(surface) => surface,
        Opposite::Plane { point, normal } => return carrier.onto_plane(point, normal, distance),
    };
    let opposite = Viewer::new(Side::new(pair, surface));
    let mut all = carrier.look(&opposite.scenery(pair.mirrors, distance), true);
    all.extend(opposite.look(&carrier.scenery(pair.mirrors, distance), false));
    all
}

/// A side that looks.
struct Viewer {
    side: Side,
    bends: Vec<Bend>,
}

/// A side that is looked at, the images behind mirror planes included.
struct Scenery {
    side: Side,
    bends: Vec<Bend>,
    tree: FacetTree,
    distance: f64,
}

/// What is seen from a point.
struct Seen {
    facet: usize,
    shape: [f64; 4],
    gap: f64,
    /// Unit normal from the viewer.
    normal: Vec3,
}

impl Viewer {
    fn new(side: Side) -> Self {
        let bends = Bend::all(&side);
        Self { side, bends }
    }

    fn scenery(&self, mirrors: &[usize], distance: f64) -> Scenery {
        let side = self.side.clone().with_images(mirrors, distance);
        Scenery {
            tree: FacetTree::new(&side.corners),
            bends: Bend::all(&side),
            side,
            distance,
        }
    }

    /// Every facet's middle, and every node at the corner of one of its facets.
    fn points(&self) -> Vec<(usize, Option<usize>)> {
        let mut known = BTreeSet::new();
        let mut points = Vec::new();
        for (index, nodes) in self.side.nodes.iter().enumerate() {
            points.push((index, None));
            let corners = nodes.iter().enumerate();
            points.extend(
                corners
                    .filter(|(_, node)| known.insert(**node))
                    .map(|(k, _)| (index, Some(k))),
            );
        }
        points
    }

    /// What all points of the side see; is it the carrier?
    fn look(&self, at: &Scenery, carries: bool) -> Vec<Sight> {
        let side = &self.side;
        let sight = |(index, corner): (usize, Option<usize>)| {
            let shape = shape_of(corner);
            let seen = at.nearest(side, index, side.at(index, &shape))?;
            let own = (side.nodes[index], shape);
            let other = (at.side.nodes[seen.facet], seen.shape);
            let signs = at.side.signs[seen.facet];
            let normal = match carries {
                true => seen.normal,
                // Seen from the image of the carrier, mirrored: an image moves the other way.
                false => [0, 1, 2].map(|i| -seen.normal[i] * signs[i]),
            };
            let [carrier, opposite] = if carries { [own, other] } else { [other, own] };
            Some(Sight {
                node: corner.filter(|_| carries).map(|c| own.0[c]),
                carrier,
                opposite: Some((opposite.0, opposite.1, signs)),
                normal,
                gap: seen.gap,
                sagitta: sagitta(
                    [self.bends[index], at.bends[seen.facet]],
                    [&side.corners[index], &at.side.corners[seen.facet]],
                ),
            })
        };
        self.points().into_par_iter().filter_map(sight).collect()
    }

    /// What all points of the side see of a rigid half space.
    fn onto_plane(&self, point: Vec3, normal: Vec3, distance: f64) -> Vec<Sight> {
        let sight = |(index, corner): (usize, Option<usize>)| {
            let shape = shape_of(corner);
            let (from, outward) = self.side.at(index, &shape);
            let gap = dot(sub(from, point), normal);
            (dot(outward, normal) <= FACING && gap.abs() <= distance).then(|| Sight {
                node: corner.map(|c| self.side.nodes[index][c]),
                carrier: (self.side.nodes[index], shape),
                opposite: None,
                normal: scale(normal, -1.0),
                gap,
                sagitta: 0.5
                    * sagitta(
                        [self.bends[index], Bend::default()],
                        [&self.side.corners[index]; 2],
                    ),
            })
        };
        self.points().into_iter().filter_map(sight).collect()
    }
}

impl Scenery {
    /// What the line along the `outward` normal meets next to `from`, a point of facet `index` of
    /// `side`; the gap is that to the true surface along the mean of both normals.
    fn nearest(&self, side: &Side, index: usize, (from, outward): (Vec3, Vec3)) -> Option<Seen> {
        let ends = [
            scale(outward, self.distance),
            scale(outward, -self.distance),
        ]
        .map(|d| add(from, d));
        // A little to the side, for lines that run along edges of facets.
        let corners = &side.corners[index];
        let beside = 1e-6 * norm(sub(corners[2], corners[0]));
        let mut best: Option<Seen> = None;
        for facet in self.tree.near(&[ends[0], ends[1], from, from], [beside; 3]) {
            if dot(outward, self.side.normals[facet]) > FACING {
                continue;
            }
            let Some(shape) = segment::meets(&self.side.corners[facet], from, outward) else {
                continue;
            };
            let (there, inward) = self.side.at(facet, &shape);
            let normal = unit(sub(outward, inward)).unwrap_or(outward);
            let gap = dot(sub(there, from), normal);
            let nearer = best.as_ref().is_none_or(|b| gap.abs() < b.gap.abs());
            if gap.abs() <= self.distance && nearer {
                best = Some(Seen {
                    facet,
                    shape,
                    gap,
                    normal,
                });
            }
        }
        best
    }
}

/// Cosine between outward normals of surfaces that face each other, at most.
const FACING: f64 = -0.3;

fn shape_of(corner: Option<usize>) -> [f64; 4] {
    match corner {
        Some(corner) => std::array::from_fn(|i| f64::from(u8::from(i == corner))),
        None => [0.25; 4],
    }
}

/// How a surface turns over a facet, along its edges one way and the other: directions, and the angles by
/// which it turns over a length.
#[derive(Clone, Copy, Default)]
struct Bend {
    along: [Vec3; 2],
    curvature: [f64; 2],
}

impl Bend {
    /// Of every facet, from the mean normals at its nodes.
    fn all(side: &Side) -> Vec<Self> {
        // An image has nodes of its own.
        let key = |index: usize, node: u32| (node, side.signs[index].map(|sign| sign < 0.0));
        let mut mean: BTreeMap<_, Vec3> = BTreeMap::new();
        for (index, (nodes, normal)) in side.nodes.iter().zip(&side.normals).enumerate() {
            for node in nodes {
                let sum = mean.entry(key(index, *node)).or_default();
                *sum = add(*sum, *normal);
            }
        }
        let normal = |index: usize, node: u32| {
            let mean = mean.get(&key(index, node)).copied();
            mean.and_then(unit).unwrap_or_default()
        };
        let edge = |index: usize, k: usize| {
            let (nodes, corners) = (&side.nodes[index], &side.corners[index]);
            let next = (k + 1) % 4;
            let edge = sub(corners[next], corners[k]);
            let along = unit(edge)?;
            let turn = sub(normal(index, nodes[next]), normal(index, nodes[k]));
            Some((along, dot(turn, along).abs() / norm(edge)))
        };
        let bend = |index| {
            let mut bend = Self::default();
            for (k, way) in [0, 1, 0, 1].into_iter().enumerate() {
                let Some((along, curvature)) = edge(index, k) else {
                    continue;
                };
                if bend.along[way] == [0.0; 3] || curvature > bend.curvature[way] {
                    (bend.along[way], bend.curvature[way]) = (along, curvature);
                }
            }
            bend
        };
        (0..side.nodes.len()).map(bend).collect()
    }

    /// The curvature along a direction, by Euler's theorem as if the edges followed the principal ones.
    fn curvature_along(&self, direction: Vec3) -> f64 {
        let ways = self.along.iter().zip(&self.curvature);
        ways.map(|(along, curvature)| curvature * dot(*along, direction).powi(2))
            .sum()
    }
}

/// Longest extent of a facet along a direction.
fn extent(corners: &[Vec3; 4], along: Vec3) -> f64 {
    let at = corners.map(|c| dot(c, along));
    let most = at.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most - at.iter().copied().fold(f64::INFINITY, f64::min)
}

/// What flat facets on both sides, of surfaces that touch, may overlap by: either side takes the shape
/// of the other, so that the chords of both lie below the curvature of both, (κ₁ + κ₂) (h₁² + h₂²) / 8,
/// along that edge where it is most: a fillet curves along the roller, where elements are long.
fn sagitta([a, b]: [Bend; 2], corners: [&[Vec3; 4]; 2]) -> f64 {
    let along = |direction: Vec3| {
        let curvature = a.curvature_along(direction) + b.curvature_along(direction);
        let sizes = corners.map(|corners| extent(corners, direction).powi(2));
        0.125 * curvature * (sizes[0] + sizes[1])
    };
    let directions = a.along.into_iter().chain(b.along);
    directions.map(along).fold(0.0, f64::max)
}
