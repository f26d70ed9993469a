//! Contact rows that can bear a rigid body.

use crate::ground::geometry::{Vec3, dot, norm, sub, unit};
use crate::model::scene::Scene;
use crate::solver::solve::params::{OPPOSITE_COSINE, RIDGE_OFFSET, ROCKING_ANGLE, TOUCHING_GAP};
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::start::extent::extent;
use std::collections::{BTreeMap, BTreeSet};

/// The rows that can bear a rigid body: where the gap is least along the surface in one direction at least, and
/// small enough for the body to rock there. A roller bears along a line, a flat face wherever it is flat; beside
/// the line it bears only on what elasticity makes of it.
pub fn ridges<'r>(scene: &Scene, mut rows: Vec<&'r ContactRow>) -> Vec<&'r ContactRow> {
    let near = TOUCHING_GAP * extent(scene);
    let at = |node: u32| scene.mesh.points[node as usize];
    let mut bears = BTreeSet::new();
    for index in 0..scene.contacts.len() {
        let of_pair = || rows.iter().filter(|r| r.pair == index);
        let gaps: BTreeMap<u32, f64> = of_pair().map(|r| (r.row.node, r.row.gap)).collect();
        let least = gaps
            .values()
            .fold(f64::INFINITY, |least, gap| least.min(*gap));
        let touching = gaps.iter().filter(|(_, gap)| **gap <= least + near);
        let touching: Vec<Vec3> = touching.map(|(node, _)| at(*node)).collect();
        let beside = neighbours(scene, index);
        let gap = |node: &u32| gaps.get(node).copied().unwrap_or(f64::INFINITY);
        let low = |node: &u32| {
            let way = touching.iter().map(|t| norm(sub(*t, at(*node))));
            gap(node) <= least + near + ROCKING_ANGLE * way.fold(f64::INFINITY, f64::min)
        };
        for (node, own) in &gaps {
            let sides: Vec<u32> = beside.get(node).into_iter().flatten().copied().collect();
            let arm = |to: &u32| unit(sub(at(*to), at(*node))).unwrap_or_default();
            let opposite = |a: &u32| {
                let over = |b: &&u32| dot(arm(a), arm(b)) < OPPOSITE_COSINE;
                sides.iter().find(over).map_or(f64::INFINITY, gap)
            };
            for side in &sides {
                let [before, after] = [opposite(side), gap(side)];
                if *own > before.min(after) + near {
                    continue;
                }
                bears.insert((index, *node));
                // The bottom of the parabola through the three gaps, in shares of the way to the side.
                let bottom = 0.5 * (before - after) / (before + after - 2.0 * own);
                if bottom > RIDGE_OFFSET && after.is_finite() {
                    bears.insert((index, *side));
                }
            }
        }
        bears.retain(|(pair, node)| *pair != index || low(node));
    }
    rows.retain(|r| bears.contains(&(r.pair, r.row.node)));
    rows
}

/// Nodes of the carrier of a pair that share an edge of a face with each of its nodes.
fn neighbours(scene: &Scene, pair: usize) -> BTreeMap<u32, BTreeSet<u32>> {
    let mut beside: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    let [carrier, _] = scene.contacts[pair].carrier_first();
    let faces = (carrier.surface(&scene.mesh)).map_or(&[][..], |surface| &surface.faces);
    for face in faces {
        for k in 0..4 {
            let [a, b] = [face.nodes[k], face.nodes[(k + 1) % 4]];
            beside.entry(a).or_default().insert(b);
            beside.entry(b).or_default().insert(a);
        }
    }
    beside
}
