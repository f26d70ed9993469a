//! What the points of one side see of the other: the search along normals.

use super::bend::{Bend, at_corner, sagitta};
use super::facet::{self, MOST_FACING};
use super::search::FacetTree;
use super::side::Side;
use super::sight::Sight;
use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub, unit};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// A side that looks.
pub(super) struct Viewer {
    side: Side,
    bends: Vec<Bend>,
}

/// A side that is looked at, the images behind mirror planes included.
pub(super) struct Scenery {
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
    /// The side as one that looks.
    pub fn new(side: Side) -> Self {
        let bends = Bend::all(&side);
        Self { side, bends }
    }

    /// The side as one that is looked at, from no farther than `distance`.
    pub fn scenery(&self, mirrors: &[usize], distance: f64) -> Scenery {
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
    pub fn look(&self, at: &Scenery, carries: bool) -> Vec<Sight> {
        let side = &self.side;
        let sight = |(index, corner): (usize, Option<usize>)| {
            let shape = shape_of(corner);
            let seen = at.nearest(self, index, side.at(index, &shape))?;
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
    pub fn onto_plane(&self, point: Vec3, normal: Vec3, distance: f64) -> Vec<Sight> {
        let sight = |(index, corner): (usize, Option<usize>)| {
            let shape = shape_of(corner);
            let (from, outward) = self.side.at(index, &shape);
            let gap = dot(sub(from, point), normal);
            (dot(outward, normal) <= MOST_FACING && gap.abs() <= distance).then(|| Sight {
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
    /// What the line along the `outward` normal meets next to `from`, a point of facet `index` of the viewer. The gap is
    /// that to the true surface along the normal of the side that is plane, where exactly one is, or the mean of both
    /// ([`facet::facing`]): with a plane side the mean would take a slide of s across a radius R, x from the line of touch, for a
    /// gap of s x/2R.
    fn nearest(
        &self,
        viewer: &Viewer,
        index: usize,
        (from, outward): (Vec3, Vec3),
    ) -> Option<Seen> {
        let side = &viewer.side;
        let ends = [
            scale(outward, self.distance),
            scale(outward, -self.distance),
        ]
        .map(|d| add(from, d));
        // A little to the side, for lines that run along edges of facets: by a millionth of the diagonal.
        let corners = &side.corners[index];
        let beside = 1e-6 * norm(sub(corners[2], corners[0]));
        let is_plane = viewer.bends[index].is_plane(corners);
        let mut best: Option<Seen> = None;
        // How far behind the other body begins.
        let mut behind = f64::INFINITY;
        for facet in self.tree.near(&[ends[0], ends[1], from, from], [beside; 3]) {
            let across = dot(outward, self.side.normals[facet]);
            if across > MOST_FACING && across < -MOST_FACING {
                continue;
            }
            let Some(shape) = facet::meets(&self.side.corners[facet], from, outward) else {
                continue;
            };
            let (there, inward) = self.side.at(facet, &shape);
            if across > 0.0 {
                let ahead = dot(sub(there, from), outward);
                behind = if ahead < 0.0 {
                    behind.min(-ahead)
                } else {
                    behind
                };
                continue;
            }
            let other_is_plane = self.bends[facet].is_plane(&self.side.corners[facet]);
            let normal = facet::facing([outward, inward], [is_plane, other_is_plane]);
            let normal = unit(normal).unwrap_or(outward);
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
        // What is behind the whole of the other body is outside of it, however deep the far side of that looks.
        best.filter(|seen| seen.gap > -behind)
    }
}

fn shape_of(corner: Option<usize>) -> [f64; 4] {
    match corner {
        Some(k) => at_corner(k),
        None => [0.25; 4],
    }
}
