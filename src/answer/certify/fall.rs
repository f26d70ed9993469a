//! How pressures fall from a largest one to the nodes beside it.

use crate::ground::geometry::{Vec3, sub};
use crate::model::scene::Scene;
use crate::model::state::ContactField;
use std::collections::BTreeSet;

/// Where contact spreads from a point, share of the mean fall that is the error: the mean over a hat function takes a third
/// of it off a cap. This, the next and that of the square of the distance from the stress across the surface were chosen on 332
/// pressures of spheres, crossed cylinders and ellipses that are claimed with them; four are outside their bars.
const OF_CAP: f64 = 0.45;
/// Share of the variance of the falls over their mean: by half of that the top of a parabola is above a node beside it.
const OFF_NODE: f64 = 0.6;

/// By how much the pressures of the nodes beside a largest one differ from it, of itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fall {
    pub mean: f64,
    variance: f64,
}

impl Fall {
    /// Of falls, each with the number of nodes that it stands for.
    fn of(falls: &[(f64, f64)]) -> Self {
        let number: f64 = falls.iter().map(|(_, number)| number).sum();
        let mean_of = |what: &dyn Fn(f64) -> f64| {
            let sum: f64 = falls.iter().map(|(off, number)| number * what(*off)).sum();
            if number > 0.0 { sum / number } else { 0.0 }
        };
        let mean = mean_of(&|off| off);
        Self {
            mean,
            variance: mean_of(&|off| (off - mean).powi(2)),
        }
    }

    /// Relative error of the largest pressure of a point of contact. Whether a node stands at the top of the cap or the cap
    /// between nodes, the mean fall to the nodes beside is that of its curvature over the spacing; what is to one side more
    /// than to the other tells how far off the top is.
    pub(super) fn of_cap(self) -> f64 {
        let off_node = self.variance / self.mean.max(f64::MIN_POSITIVE);
        OF_CAP * self.mean + OFF_NODE * off_node
    }
}

/// From the node `top` to the nodes beside it.
pub(super) fn fall(scene: &Scene, field: &ContactField, pair: usize, top: usize) -> Fall {
    if scene.carrier(pair).is_none() {
        return Fall::of(&[(1.0, 1.0)]);
    }
    let off = |i: usize| (1.0 - field.pressure[i] / field.pressure[top]).abs();
    let beside = beside(scene, field, pair, top).into_iter();
    let places = |i: usize| from_peak(scene, field.nodes[top], field.nodes[i]).len() as f64;
    Fall::of(&beside.map(|i| (off(i), places(i))).collect::<Vec<_>>())
}

/// Where a node stands from the peak, and where its images do: a node off a mirror plane on which the peak lies stands for its image,
/// too.
pub(super) fn from_peak(scene: &Scene, peak: u32, node: u32) -> Vec<Vec3> {
    let at = |node: u32| &scene.mesh.points[node as usize];
    let own: Vec<usize> = scene.mirrors_through(at(node)).collect();
    let mut places = vec![sub(*at(node), *at(peak))];
    for axis in scene
        .mirrors_through(at(peak))
        .filter(|axis| !own.contains(axis))
    {
        let mirrored = places.clone().into_iter().map(|mut away| {
            away[axis] = -away[axis];
            away
        });
        places.extend(mirrored);
    }
    places
}

/// The nodes that an edge of a face joins to `node`.
pub(super) fn beside(scene: &Scene, field: &ContactField, pair: usize, node: usize) -> Vec<usize> {
    let node = field.nodes[node];
    let mut beside = BTreeSet::new();
    for face in scene
        .carrier(pair)
        .iter()
        .flat_map(|surface| &surface.faces)
    {
        for side in 0..4 {
            match face.edge(side) {
                [a, b] if a == node => beside.insert(b),
                [a, b] if b == node => beside.insert(a),
                _ => false,
            };
        }
    }
    let index = |n: &u32| field.nodes.binary_search(n).ok();
    beside.iter().filter_map(index).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Falls from the node of a square grid of spacing 1 that is nearest to the top of a cap 1 − r²/2a², the top being off
    /// it by `at`.
    fn of_cap(a: f64, at: [f64; 2]) -> Fall {
        let cap =
            |x: f64, y: f64| 1.0 - ((x - at[0]).powi(2) + (y - at[1]).powi(2)) / (2.0 * a * a);
        let beside = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)];
        Fall::of(&beside.map(|(x, y)| (1.0 - cap(x, y) / cap(0.0, 0.0), 1.0)))
    }

    #[test]
    fn the_falls_from_a_cap_tell_its_curvature_and_how_far_off_its_top_is() {
        let a = 5.0;
        let on = of_cap(a, [0.0, 0.0]);
        assert!((on.mean - 0.5 / (a * a)).abs() < 1e-12, "{on:?}");
        assert!(on.variance < 1e-12, "{on:?}");
        // What the node in the corner lacks of the top, r²/2a².
        let off = of_cap(a, [0.5, 0.5]);
        let value = 1.0 - 0.25 / (a * a);
        assert!((off.mean * value - on.mean).abs() < 1e-12, "{off:?}");
        let lacks = 0.5 * off.variance / off.mean;
        assert!((lacks * value - 0.25 / (a * a)).abs() < 1e-12, "{lacks}");
        assert!(off.of_cap() > 2.0 * on.of_cap());
    }

    #[test]
    fn images_count_and_an_even_pressure_has_no_error() {
        let whole = Fall::of(&[(0.1, 1.0), (0.1, 1.0), (0.3, 1.0)]);
        assert_eq!(whole, Fall::of(&[(0.1, 2.0), (0.3, 1.0)]));
        assert_eq!(Fall::of(&[(0.0, 4.0)]).of_cap(), 0.0);
        assert_eq!(Fall::of(&[]).mean, 0.0);
    }
}
