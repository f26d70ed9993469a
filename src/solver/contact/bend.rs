//! How far flat facets overlap where the round surfaces that they stand for only touch.
//!
//! The chord of an arc with curvature κ over a length h lies κ h² / 8 below its crown, the *sagitta*. The curvature of a
//! surface is read from how its normal turns from node to node.

use super::side::Side;
use crate::ground::geometry::{Vec3, add, dot, norm, range, sub, unit};
use std::collections::BTreeMap;

/// The curvature of a surface over a facet.
#[derive(Clone, Copy, Default)]
pub(super) struct Bend {
    /// Unit vectors along its edges, one way and the other.
    along: [Vec3; 2],
    /// The larger of the two curvatures along opposite edges, 1 / length, positive where the body is convex.
    curvature: [f64; 2],
    /// Is the true shape not known, so that gaps are those of its flat facets?
    is_flat: bool,
}

impl Bend {
    /// Of every facet, from the normals at its nodes: of the true shape, or the mean of the facets that meet there.
    pub fn all(side: &Side) -> Vec<Self> {
        // An image has nodes of its own.
        let key = |index: usize, node: u32| (node, side.signs[index].map(|sign| sign < 0.0));
        let mut mean: BTreeMap<_, Vec3> = BTreeMap::new();
        let facets = side.nodes.iter().zip(&side.normals).enumerate();
        for (index, (nodes, normal)) in facets.filter(|_| side.is_flat()) {
            for node in nodes {
                let sum = mean.entry(key(index, *node)).or_default();
                *sum = add(*sum, *normal);
            }
        }
        let normal = |index: usize, k: usize| {
            if !side.is_flat() {
                return side.at(index, &at_corner(k)).1;
            }
            let mean = mean.get(&key(index, side.nodes[index][k])).copied();
            mean.and_then(unit).unwrap_or_default()
        };
        let edge = |index: usize, k: usize| {
            let corners = &side.corners[index];
            let next = (k + 1) % 4;
            let edge = sub(corners[next], corners[k]);
            let along = unit(edge)?;
            let turn = sub(normal(index, next), normal(index, k));
            Some((along, dot(turn, along) / norm(edge)))
        };
        let bend = |index| {
            let mut bend = Self {
                is_flat: side.is_flat(),
                ..Self::default()
            };
            for (k, way) in [0, 1, 0, 1].into_iter().enumerate() {
                let Some((along, curvature)) = edge(index, k) else {
                    continue;
                };
                if bend.along[way] == [0.0; 3] || curvature.abs() > bend.curvature[way].abs() {
                    (bend.along[way], bend.curvature[way]) = (along, curvature);
                }
            }
            bend
        };
        (0..side.nodes.len()).map(bend).collect()
    }

    /// Is the surface plane over the facet with these corners, but for rounding?
    pub fn is_plane(&self, corners: &[Vec3; 4]) -> bool {
        const ROUNDING: f64 = 1e-5;
        let ways = self.along.iter().zip(&self.curvature);
        ways.fold(0.0, |most: f64, (along, curvature)| {
            most.max(curvature.abs() * extent(corners, *along))
        }) <= ROUNDING
    }

    /// The curvature along a direction, or what of it lies in the facet, by Euler's theorem as if the edges followed the
    /// principal ones.
    fn curvature_along(&self, direction: Vec3) -> f64 {
        let shares = self.along.map(|along| dot(along, direction).powi(2));
        let ways = shares.iter().zip(&self.curvature);
        let sum: f64 = ways.map(|(share, curvature)| share * curvature).sum();
        let whole = shares[0] + shares[1];
        if whole > 0.0 { sum / whole } else { 0.0 }
    }
}

/// Weights of a facet's nodes at one of them.
pub(super) fn at_corner(k: usize) -> [f64; 4] {
    std::array::from_fn(|i| f64::from(u8::from(i == k)))
}

/// Longest extent of a facet along a direction.
fn extent(corners: &[Vec3; 4], along: Vec3) -> f64 {
    let [least, most] = range(corners.map(|c| dot(c, along)));
    most - least
}

/// What flat facets on both sides, of surfaces that touch, may overlap by, a length.
///
/// Pressed together, either side takes the shape of the other, so that the chords of both lie below the curvature of
/// both, the difference of the two where a pin lies in a hole: |κ₁ + κ₂| (h₁² + h₂²) / 8. Facets that stand for
/// themselves lie κ h² / 8 off the shape that they replace, and those of the other side need not do so at the same
/// place. Taken along that edge where it is most: a fillet curves along the roller, where elements are long.
pub(super) fn sagitta([a, b]: [Bend; 2], corners: [&[Vec3; 4]; 2]) -> f64 {
    let along = |direction: Vec3| {
        let curvatures = [a, b].map(|bend| bend.curvature_along(direction));
        let sizes = corners.map(|corners| extent(corners, direction).powi(2));
        let chord =
            |i: usize| curvatures[i].abs() * sizes[i] * f64::from(u8::from([a, b][i].is_flat));
        let both = (curvatures[0] + curvatures[1]).abs() * (sizes[0] + sizes[1]);
        0.125 * (both + chord(0).max(chord(1)))
    };
    let directions = a.along.into_iter().chain(b.along);
    directions.map(along).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A facet of 2 by 1 that curves along its longer side.
    fn bend(curvature: f64, is_flat: bool) -> Bend {
        Bend {
            along: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            curvature: [curvature, 0.0],
            is_flat,
        }
    }

    #[test]
    fn a_pin_in_a_hole_bends_by_the_difference() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(|[x, y]| [x, y, 0.0]);
        let of = |one: Bend, other: Bend| sagitta([one, other], [&corners; 2]);
        let (pin, hole) = (0.1, -0.09);
        assert!((of(bend(pin, false), bend(hole, false)) - 0.01).abs() < 1e-12);
        // Two rollers, and a roller on a plate.
        assert!((of(bend(pin, false), bend(pin, false)) - 0.2).abs() < 1e-12);
        assert!((of(bend(pin, false), bend(0.0, false)) - 0.1).abs() < 1e-12);
        // Facets that stand for themselves may lie a chord beside the others.
        assert!((of(bend(pin, true), bend(hole, true)) - 0.06).abs() < 1e-12);
    }
}
