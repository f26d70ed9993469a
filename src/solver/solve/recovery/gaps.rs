//! The gaps of the two surfaces of a pair as they are, whatever rows exist.

use crate::ground::geometry::Vec3;
use crate::model::state::ContactField;
use crate::solver::contact::facing::Sight;
use crate::solver::solve::params::{OPENING_SHARE, RIM_OVERLAP};

/// What is seen of a pair without any contact row: the gaps of nodes that no row exists for, and the
/// deepest overlap of the two sides. `points` are those of the mesh, and `u` their displacements.
pub fn see_gaps(field: &mut ContactField, sights: &[Sight], (points, u): (&[Vec3], &[Vec3])) {
    let gaps: Vec<f64> = sights.iter().map(|sight| sight.gap_at(u)).collect();
    let place = |node: u32| field.nodes.binary_search(&node).ok();
    let mut seen = vec![None; field.nodes.len()];
    for (sight, gap) in sights.iter().zip(&gaps) {
        if let Some(at) = sight.node.and_then(place) {
            seen[at] = Some(*gap);
        }
    }
    // Where meshes do not match, flat facets on either side bend differently: by how much the middle of
    // a facet is off the mean of its corners.
    let mut bend = vec![0.0f64; field.nodes.len()];
    for (sight, gap) in sights.iter().zip(&gaps).filter(|(s, _)| s.is_middle()) {
        let corners = sight
            .carrier
            .0
            .map(|node| place(node).and_then(|at| seen[at]));
        if let [Some(a), Some(b), Some(c), Some(d)] = corners {
            let off = (gap - 0.25 * (a + b + c + d)).abs();
            let nodes = sight.carrier.0.into_iter().filter_map(place);
            nodes.for_each(|at| bend[at] = bend[at].max(off));
        }
    }
    // A row weighs the gaps of all facets about its node: what one of them bends, as over the beginning of a fillet, may
    // overlap in the next.
    let mut sagitta = vec![0.0f64; field.nodes.len()];
    for sight in sights {
        let nodes = sight.carrier.0.into_iter().filter_map(place);
        nodes.for_each(|at| sagitta[at] = sagitta[at].max(sight.sagitta));
    }
    let opening = openings(field, sights, &seen);
    for (sight, gap) in sights.iter().zip(&gaps) {
        let nodes = || sight.carrier.0.into_iter().filter_map(place);
        let of = |share: &[f64]| nodes().map(|at| share[at]).fold(0.0, f64::max);
        let facets = RIM_OVERLAP * (of(&sagitta) + of(&bend));
        let rim = (OPENING_SHARE * of(&opening) - facets).max(0.0);
        field.at_rim = field.at_rim.max((-gap - facets).min(rim));
        let explained = facets + rim;
        field.penetration = field.penetration.max(-gap);
        if -gap - explained > field.unexplained {
            field.unexplained = -gap - explained;
            field.unexplained_at = Some(sight.place(points));
        }
    }
    field.sagitta = sagitta;
    for (gap, seen) in field.gap.iter_mut().zip(seen) {
        if gap.is_infinite() {
            *gap = seen.unwrap_or(f64::INFINITY);
        }
    }
}

/// How far the facets about each node under pressure open at one of their other nodes: by what a weighted gap
/// balances the overlap at the node itself. Zero where nothing presses, for there no gap is weighted.
fn openings(field: &ContactField, sights: &[Sight], seen: &[Option<f64>]) -> Vec<f64> {
    let mut opening = vec![0.0f64; field.nodes.len()];
    for sight in sights.iter().filter(|sight| sight.is_middle()) {
        let corners = sight
            .carrier
            .0
            .map(|node| field.nodes.binary_search(&node).ok());
        let corners = || corners.iter().flatten().copied();
        let open = corners().filter_map(|at| seen[at]).fold(0.0, f64::max);
        let presses = corners().filter(|at| field.pressure[*at] > 0.0);
        presses.for_each(|at| opening[at] = opening[at].max(open));
    }
    opening
}
