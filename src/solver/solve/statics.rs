//! Is there a balance of rigid bodies at all?
//!
//! Loads, supports that hold both ways, and contact that only pushes and rubs no more than Coulomb lets it: if
//! these can be in balance, some forces within the cones of friction add up to the loads on every motion that
//! supports leave to the bodies. The forces that come nearest are those of a least-squares problem with
//! unknowns that are not negative (Lawson and Hanson 1974, chapter 23). What they leave over is, when there is no
//! balance, a motion that the loads drive and that no contact resists (the lemma of Farkas): the body tips or
//! slides along it. Nothing here knows of stiffness, or of how the solution is found.

use super::holding::{FreeMotion, RigidBodies};
use super::rigid::{Touch, movable_modes};
use super::rows::ContactRow;
use super::start::extent;
use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub, unit};
use crate::model::scene::Scene;
use crate::solver::solve::params::{
    BALANCE_REMAINDER, CONE_EDGES, NONNEGATIVE_ROUNDING, NONNEGATIVE_ROUNDS, OPPOSITE_COSINE,
    RIDGE_OFFSET, ROCKING_ANGLE, ROUGHEST_FRICTION, TOUCHING_GAP,
};
use nalgebra::{DMatrix, DVector};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

/// There is no balance of rigid bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct Imbalance {
    /// How the bodies would move.
    pub motion: FreeMotion,
    /// The least coefficient of friction, between all bodies, with which there is a balance; `None` where
    /// no friction makes one.
    pub friction: Option<f64>,
    /// What the body bears on most.
    pub bears: Option<Bears>,
}

/// What a body bears on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bears {
    pub pair: usize,
    /// Where the force acts.
    pub at: Vec3,
    /// Unit normal of the contact there.
    pub normal: Vec3,
}

/// Why bodies that touch at `rows` cannot be in balance under loads of these `factors`, by name; `None` where they
/// can, or nothing drives them.
pub fn imbalance<'r>(
    scene: &Scene,
    rows: impl Iterator<Item = &'r ContactRow>,
    factors: &dyn Fn(&str) -> f64,
) -> Option<Imbalance> {
    let frames = RigidBodies::new(scene);
    let free = movable_modes(scene, &frames)?;
    let load = free.tr_mul(&DVector::from_vec(frames.load(scene, factors)));
    let whole = load.norm();
    if whole == 0.0 {
        return None;
    }
    let rows = ridges(scene, rows.collect());
    let points: Vec<Touch> = rows
        .iter()
        .map(|row| Touch::new(row, &frames, &free))
        .collect();
    let enclosing = 1.0 / (PI / CONE_EDGES as f64).cos();
    let found = nearest(&cones(&points, |friction| enclosing * friction), &load)?;
    if found.left.norm() <= BALANCE_REMAINDER * whole {
        return None;
    }
    // Advice is on the safe side: there the polygon lies within the circle.
    let stands = |rough: f64| {
        let found = nearest(&cones(&points, |friction| friction.max(rough)), &load);
        found.is_some_and(|f| f.left.norm() <= BALANCE_REMAINDER * whole)
    };
    let motion = frames.motion(scene, (&free * &found.left).as_slice(), true)?;
    let body = scene
        .mesh
        .bodies
        .iter()
        .position(|b| b.name == motion.body)?;
    // What touches nothing needs no statics.
    let touched = |row: &&&ContactRow| {
        let nodes = row.row.terms.iter().map(|(node, _)| *node as usize);
        nodes
            .flat_map(|node| &frames.bodies[node])
            .any(|b| *b == body)
    };
    rows.iter().find(touched)?;
    let bears = bears(scene, &rows, &frames, (&found.forces, body));
    Some(Imbalance {
        motion,
        friction: stands(ROUGHEST_FRICTION).then(|| least(&stands)),
        bears,
    })
}

/// The rows that can bear a rigid body: where the gap is least along the surface in one direction at least, and
/// small enough for the body to rock there. A roller bears along a line, a flat face wherever it is flat; beside
/// the line it bears only on what elasticity makes of it.
fn ridges<'r>(scene: &Scene, mut rows: Vec<&'r ContactRow>) -> Vec<&'r ContactRow> {
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

/// Edges of the cones of friction, a column each; `friction` says what becomes of a coefficient.
fn cones(points: &[Touch], friction: impl Fn(f64) -> f64) -> Vec<DVector<f64>> {
    let mut edges = Vec::new();
    for point in points {
        let Some([s, t]) = &point.tangents else {
            edges.push(point.normal.clone());
            continue;
        };
        let friction = friction(point.friction);
        edges.extend((0..CONE_EDGES).map(|k| {
            let angle = 2.0 * PI * k as f64 / CONE_EDGES as f64;
            let (sin, cos) = angle.sin_cos();
            &point.normal + friction * (cos * s + sin * t)
        }));
    }
    edges
}

/// The nearest to balance that contact can come.
struct Nearest {
    /// Contact forces, by edge of a cone.
    forces: Vec<(usize, f64)>,
    /// What is left of the load.
    left: DVector<f64>,
}

/// Forces on `edges`, none negative, whose sum is nearest to `load`; `None` where rounding hinders it.
fn nearest(edges: &[DVector<f64>], load: &DVector<f64>) -> Option<Nearest> {
    let mut forces: Vec<(usize, f64)> = Vec::new();
    let mut left = load.clone();
    let solve = |chosen: &[(usize, f64)]| {
        let columns: Vec<_> = chosen
            .iter()
            .map(|(edge, _)| edges[*edge].clone())
            .collect();
        let svd = DMatrix::from_columns(&columns).svd(true, true);
        svd.solve(load, NONNEGATIVE_ROUNDING).ok()
    };
    for _ in 0..NONNEGATIVE_ROUNDS {
        let gains = edges.iter().map(|edge| left.dot(edge) / edge.norm());
        let best = gains
            .enumerate()
            .filter(|(edge, gain)| gain.is_finite() && forces.iter().all(|(e, _)| e != edge))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((edge, _)) = best.filter(|(_, gain)| *gain > 1e-10 * load.norm()) else {
            return Some(Nearest { forces, left });
        };
        forces.push((edge, 0.0));
        // Back to where no force is negative.
        loop {
            let wanted = solve(&forces)?;
            let blocked = |((_, now), then): (&(usize, f64), &f64)| {
                (*then <= 0.0).then(|| now / (now - then).max(f64::MIN_POSITIVE))
            };
            let share = forces.iter().zip(wanted.iter()).filter_map(blocked);
            let share = share.fold(1.0, f64::min);
            for ((_, now), then) in forces.iter_mut().zip(wanted.iter()) {
                *now += share * (then - *now);
            }
            if share >= 1.0 {
                break;
            }
            let most = forces.iter().fold(0.0f64, |most, f| most.max(f.1));
            forces.retain(|(_, force)| *force > NONNEGATIVE_ROUNDING * most);
            if forces.is_empty() {
                break;
            }
        }
        let before = left.norm();
        left = load.clone();
        for (edge, force) in &forces {
            left -= *force * &edges[*edge];
        }
        // Rounding is all that is gained.
        if left.norm() >= (1.0 - NONNEGATIVE_ROUNDING) * before {
            return Some(Nearest { forces, left });
        }
    }
    None
}

/// The least coefficient of friction with which bodies `stand`, to a thousandth.
fn least(stands: &dyn Fn(f64) -> bool) -> f64 {
    let (mut no, mut yes) = (0.0, ROUGHEST_FRICTION);
    while yes - no > 5e-4 * yes {
        let middle = 0.5 * (no + yes);
        if stands(middle) {
            yes = middle;
        } else {
            no = middle;
        }
    }
    yes
}

/// The pair through which `body` is pressed most, and the middle of the forces there.
fn bears(
    scene: &Scene,
    rows: &[&ContactRow],
    frames: &RigidBodies,
    (forces, body): (&[(usize, f64)], usize),
) -> Option<Bears> {
    // Edges of cones are counted on from row to row.
    let count = |row: &ContactRow| row.row.tangents.map_or(1, |_| CONE_EDGES);
    let ends = rows.iter().scan(0, |end, row| {
        *end += count(row);
        Some(*end)
    });
    let ends: Vec<usize> = ends.collect();
    let mut pairs = vec![(0.0, [0.0; 3], [0.0; 3]); scene.contacts.len()];
    for (edge, force) in forces {
        let row = rows[ends.partition_point(|end| end <= edge)];
        let nodes = row.row.terms.iter().map(|(node, _)| *node as usize);
        if nodes
            .flat_map(|node| &frames.bodies[node])
            .any(|b| *b == body)
        {
            let (sum, moment, normal) = &mut pairs[row.pair];
            *sum += force;
            let at = scene.mesh.points[row.row.node as usize];
            *moment = add(*moment, scale(at, *force));
            *normal = add(*normal, scale(row.row.normal, *force));
        }
    }
    let most = pairs.iter().enumerate();
    let (pair, (sum, moment, normal)) = most.max_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    Some(Bears {
        pair,
        at: scale(*moment, 1.0 / sum),
        normal: unit(*normal).filter(|_| *sum > 0.0)?,
    })
}
