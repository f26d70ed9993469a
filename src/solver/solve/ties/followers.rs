//! Which displacement components follow which others.
//!
//! *Which side follows.* The one that the other covers in full; of two that are covered alike the one with the smaller
//! facets, so that its nodes follow what is coarser, as hanging nodes do. Where facets are of one size, the first.
//!
//! *Where something else decides already.* A component that a support or a rigid plane holds does not follow, nor does
//! one that follows by an earlier tie, or that would follow itself in a circle: edges at which several ties meet are tied
//! once. Its dual function is added to that of a node beside it that follows, or else across a facet, so that these still sum to one and a uniform
//! stress is passed on exactly. (From a corner of a surface whose rim is held that is the node across the facet: were
//! the function of the corner left out, this would go unnoticed on parallelograms, where it is biorthogonal to what the
//! free nodes opposite do, but not on other facets.) Only across a mirror plane it is left out: shear is zero there. Where all of a facet is held nothing would tie what lies
//! opposite: then the other side follows, and where that is held as well surfaces cannot be tied. The same is done with nodes of which the
//! other side covers but a sliver.

use crate::model::mesh::Surface;
use crate::model::scene::{Scene, Tie};
use crate::solver::contact::tie::{Seam, TiedNode};
use crate::solver::fem::dofs::Owners;
use crate::solver::fem::tied::{Component, Follower, NodeArea, Tied, component};
use crate::solver::solve::ties::error::TieError;
use crate::solver::solve::ties::order::{Order, sorted};
use crate::solver::solve::ties::sides::Sides;
use crate::solver::solve::ties::touching::beside_contact;
use nalgebra::Matrix3;
use std::collections::{BTreeMap, BTreeSet};

/// Share of the area of a facet that the other side has to cover before a node for it to follow.
const LEAST_COVERED: f64 = 0.1;

/// Covered shares that differ by no more than this factor are even, so that rounding decides nothing.
const EVEN: f64 = 1.0 + 1e-9;

/// The followers of all ties of `scene`.
///
/// # Errors
/// [`TieError`] where surfaces cannot be tied.
pub fn followers(scene: &Scene, owners: &Owners) -> Result<Tied, TieError> {
    let mut tied = Tied::new(scene.mesh.points.len());
    let (mut order, mut all) = hanging(scene, owners);
    for (index, tie) in (0..).zip(&scene.ties) {
        let sides = Sides::of(scene, tie)?;
        let of = |follows: usize, order: &Order| {
            let joint = sides.joint(tie, follows)?;
            let own = one_tie(scene, (tie, &sides, follows), owners, order.clone())?;
            Ok((joint, own))
        };
        let first = of(sides.first, &order);
        let (joint, (own, after)) = match first {
            // What supports hold cannot follow: then the other side may.
            Err(held @ TieError::Held { .. }) => of(1 - sides.first, &order).map_err(|_| held)?,
            other => other?,
        };
        order = after;
        let seam = &sides.seams[joint.follows];
        tied.joints.push(joint);
        tied.areas.extend(seam.nodes.iter().map(|node| NodeArea {
            tie: index,
            node: node.node,
            area: node.area,
            normal: node.normal,
        }));
        for (axis, own) in own.into_iter().enumerate() {
            all.extend(own.into_iter().map(|(k, absorbed)| {
                let absorbed = absorbed.into_iter().map(|i| &seam.nodes[i]);
                follower(index, axis, &seam.nodes[k], absorbed)
            }));
        }
    }
    let tied = sorted(all, tied);
    beside_contact(scene, &tied)?;
    Ok(tied)
}

/// What hangs on edges and faces of larger elements. What a support holds does not: its corners are held alike.
fn hanging(scene: &Scene, owners: &Owners) -> (Order, Vec<Follower>) {
    let (mut order, mut all) = (Order::default(), Vec::new());
    for hanging in &scene.mesh.hanging {
        let share = 1.0 / hanging.corners.len().max(1) as f64;
        for axis in 0..3 {
            if owners[hanging.node as usize][axis].is_some() {
                continue;
            }
            let own = component(hanging.node, axis);
            let corners = hanging
                .corners
                .iter()
                .map(|corner| component(*corner, axis));
            order.insert(own, corners.clone());
            all.push(Follower {
                component: own,
                terms: corners.map(|corner| (corner, share)).collect(),
                tie: None,
            });
        }
    }
    (order, all)
}

/// By number of each node of a seam that follows: the numbers of those whose functions it takes over.
type Own = BTreeMap<usize, Vec<usize>>;

/// What follows along each axis where one side of a tie does, and the `order` with it.
fn one_tie(
    scene: &Scene,
    (tie, sides, follows): (&Tie, &Sides, usize),
    owners: &Owners,
    mut order: Order,
) -> Result<([Own; 3], Order), TieError> {
    let (carrier, seam) = (sides.surfaces[follows], &sides.seams[follows]);
    let mut all = [Own::new(), Own::new(), Own::new()];
    for (axis, own) in all.iter_mut().enumerate() {
        *own = share_out(scene, (carrier, seam), (axis, owners), &mut order).map_err(|node| {
            let by = owners[node as usize][axis].map(|owner| owner.name(scene).to_owned());
            TieError::Held {
                tie: tie.name.clone(),
                surface: tie.surfaces[follows].clone(),
                by: by.unwrap_or_default(),
                axis: ['x', 'y', 'z'][axis],
            }
        })?;
    }
    Ok((all, order))
}

/// What follows along `axis`; a node that cannot where something has to.
fn share_out(
    scene: &Scene,
    (carrier, seam): (&Surface, &Seam),
    (axis, owners): (usize, &Owners),
    order: &mut Order,
) -> Result<Own, u32> {
    let held = |c: Component| owners[c as usize / 3][c as usize % 3].is_some();
    let mut own = Own::new();
    for (k, node) in seam.nodes.iter().enumerate() {
        let component = component(node.node, axis);
        let taken = held(component) || order.has(component);
        if node.covered >= LEAST_COVERED
            && !taken
            && !order.reaches(opposite(node, axis), component)
        {
            order.insert(component, opposite(node, axis));
            own.insert(k, Vec::new());
        }
    }
    let number: BTreeMap<u32, usize> = (seam.nodes.iter().enumerate())
        .map(|(k, node)| (node.node, k))
        .collect();
    // At the other ends of its edges, and across its facets.
    let mut beside: BTreeMap<u32, [BTreeSet<usize>; 2]> = BTreeMap::new();
    for face in &carrier.faces {
        for (k, node) in face.nodes.iter().enumerate() {
            for (step, way) in [(1, 0), (3, 0), (2, 1)] {
                let other = number.get(&face.nodes[(k + step) % 4]);
                beside.entry(*node).or_default()[way].extend(other);
            }
        }
    }
    for (k, node) in seam.nodes.iter().enumerate() {
        let this = component(node.node, axis);
        let mirrored = || {
            let at = &scene.mesh.points[node.node as usize];
            scene.mirrors_through(at).any(|mirror| mirror == axis)
        };
        if own.contains_key(&k) || (held(this) && mirrored()) {
            continue;
        }
        let absorbed = || opposite(node, axis).chain([this]);
        let able = |other: &&usize| {
            let target = component(seam.nodes[**other].node, axis);
            own.contains_key(other) && !order.reaches(absorbed(), target)
        };
        // That which is covered most; of equals the lowest.
        let best_of = |sides: &BTreeSet<usize>| {
            let sides = sides.iter().filter(able);
            sides.fold(None::<usize>, |best, other| match best {
                Some(b) if seam.nodes[*other].covered <= seam.nodes[b].covered * EVEN => best,
                _ => Some(*other),
            })
        };
        let near = beside.get(&node.node);
        if let Some(best) = near.and_then(|near| near.iter().find_map(best_of)) {
            order.insert(component(seam.nodes[best].node, axis), absorbed());
            own.entry(best).or_default().push(k);
        } else if held(this) {
            let mut along = opposite(node, axis).filter(|c| *c as usize % 3 == axis);
            if along.any(|c| !held(c) && !order.has(c)) {
                return Err(node.node);
            }
        }
    }
    Ok(own)
}

/// Components opposite that decide about that of `node` along `axis`.
fn opposite(node: &TiedNode, axis: usize) -> impl Iterator<Item = Component> {
    let of = move |(other, matrix): &(u32, Matrix3<f64>)| {
        let other = *other;
        let row = [0, 1, 2].map(|j| matrix[(axis, j)]);
        (0..3)
            .filter(move |j| row[*j] != 0.0)
            .map(move |j| component(other, j))
    };
    node.terms.iter().flat_map(of)
}

/// The component of `node` along `axis`, its condition added to those of the nodes that it takes over.
fn follower<'n>(
    tie: u32,
    axis: usize,
    node: &TiedNode,
    absorbed: impl Iterator<Item = &'n TiedNode>,
) -> Follower {
    let mut terms: BTreeMap<Component, f64> = BTreeMap::new();
    let mut add = |component: Component, value: f64| {
        if value != 0.0 {
            *terms.entry(component).or_insert(0.0) += value;
        }
    };
    let mut opposite = |from: &TiedNode| {
        let share = from.area / node.area;
        for (other, matrix) in &from.terms {
            (0..3).for_each(|j| add(component(*other, j), share * matrix[(axis, j)]));
        }
    };
    opposite(node);
    let absorbed: Vec<&TiedNode> = absorbed.collect();
    absorbed.iter().for_each(|from| opposite(from));
    for from in absorbed {
        add(component(from.node, axis), -from.area / node.area);
    }
    Follower {
        component: component(node.node, axis),
        terms: terms.into_iter().collect(),
        tie: Some(tie),
    }
}
