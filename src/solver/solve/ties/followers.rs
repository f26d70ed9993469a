//! Which displacement components follow which others.
//!
//! *Which side follows.* The one that the other covers in full; of two that are covered alike the one with the smaller
//! facets, so that its nodes follow what is coarser, as hanging nodes do. Where facets are of one size, the first.
//!
//! *Where something else decides already.* A component that a support or a rigid plane holds does not follow, nor does
//! one that follows by an earlier tie, or that would follow itself in a circle: edges at which several ties meet are tied
//! once. Its dual function is added to that of a node beside it, so that these still sum to one and a uniform stress is passed on
//! exactly. Only across a mirror plane it is left out: shear is zero there. The same is done with nodes of which the
//! other side covers but a sliver.

use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::{Scene, TOLERANCE_SHARE, Tie};
use crate::solver::contact::mortar::{Opposite, Pair};
use crate::solver::contact::tie::{Seam, TiedNode, seam};
use crate::solver::fem::loads::area;
use crate::solver::fem::dofs::Owners;
use crate::solver::fem::tied::{Component, Follower, Joint, NodeArea, Tied, component};
use crate::solver::solve::start::extent::extent;
use crate::solver::solve::ties::error::TieError;
use crate::solver::solve::ties::order::{Order, sorted};
use nalgebra::Matrix3;
use std::collections::{BTreeMap, BTreeSet};

/// Share of a surface that is covered in full, whatever its facets make of a round rim.
const COVERED: f64 = 0.99;

/// Share of both surfaces of which less lies upon the other: then they do not belong together.
const NOT_COVERED: f64 = 1e-3;

/// Ratio of the mean areas of facets up to which these count as equal.
const EQUAL_FACETS: f64 = 1.1;

/// Share of the area of a facet that the other side has to cover before a node for it to follow.
const LEAST_COVERED: f64 = 0.1;

/// The followers of all ties of `scene`.
///
/// # Errors
/// [`TieError`] where surfaces cannot be tied.
pub fn followers(scene: &Scene, owners: &Owners) -> Result<Tied, TieError> {
    let mut tied = Tied::new(scene.mesh.points.len());
    let (mut order, mut all) = (Order::default(), Vec::new());
    for (index, tie) in (0..).zip(&scene.ties) {
        let (joint, carrier, seam) = joint(scene, tie)?;
        tied.joints.push(joint);
        tied.areas.extend(seam.nodes.iter().map(|node| NodeArea {
            tie: index,
            node: node.node,
            area: node.area,
            normal: node.normal,
        }));
        let held = |node: u32, axis: usize| owners[node as usize][axis].is_some();
        for axis in 0..3 {
            let own = share_out(scene, (carrier, &seam), (axis, &held), &mut order);
            all.extend(own.into_iter().map(|(k, absorbed)| {
                let absorbed = absorbed.into_iter().map(|i| &seam.nodes[i]);
                follower(index, axis, &seam.nodes[k], absorbed)
            }));
        }
    }
    Ok(sorted(all, tied))
}

/// By number of each node of the seam that follows along `axis`: the numbers of those whose functions it takes over.
fn share_out(
    scene: &Scene,
    (carrier, seam): (&Surface, &Seam),
    (axis, held): (usize, &dyn Fn(u32, usize) -> bool),
    order: &mut Order,
) -> BTreeMap<usize, Vec<usize>> {
    let mut own: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (k, node) in seam.nodes.iter().enumerate() {
        let component = component(node.node, axis);
        let taken = held(node.node, axis) || order.has(component);
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
    let mut beside: BTreeMap<u32, BTreeSet<usize>> = BTreeMap::new();
    for face in &carrier.faces {
        for (k, node) in face.nodes.iter().enumerate() {
            for step in [1, 3] {
                let other = number.get(&face.nodes[(k + step) % 4]);
                beside.entry(*node).or_default().extend(other);
            }
        }
    }
    for (k, node) in seam.nodes.iter().enumerate() {
        let mirrored = || {
            let at = &scene.mesh.points[node.node as usize];
            scene.mirrors_through(at).any(|mirror| mirror == axis)
        };
        if own.contains_key(&k) || (held(node.node, axis) && mirrored()) {
            continue;
        }
        let absorbed = || opposite(node, axis).chain([component(node.node, axis)]);
        let able = |other: &&usize| {
            let target = component(seam.nodes[**other].node, axis);
            own.contains_key(other) && !order.reaches(absorbed(), target)
        };
        // The node beside it that is covered most; of equals the lowest.
        let sides = beside.get(&node.node).into_iter().flatten().filter(able);
        let best = sides.fold(None::<usize>, |best, other| match best {
            Some(b) if seam.nodes[*other].covered <= seam.nodes[b].covered * (1.0 + 1e-9) => best,
            _ => Some(*other),
        });
        if let Some(best) = best {
            order.insert(component(seam.nodes[best].node, axis), absorbed());
            own.entry(best).or_default().push(k);
        }
    }
    own
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
        tie,
    }
}

/// How a tie joins, the surface whose nodes follow, and its integrals.
fn joint<'s>(scene: &'s Scene, tie: &Tie) -> Result<(Joint, &'s Surface, Seam), TieError> {
    let mesh = &scene.mesh;
    let of = |index: usize| {
        let surface = mesh.surface(&tie.surfaces[index]);
        surface.ok_or_else(|| TieError::NoSurface {
            tie: tie.name.clone(),
            surface: tie.surfaces[index].clone(),
        })
    };
    let surfaces = [of(0)?, of(1)?];
    let second: BTreeSet<u32> = surfaces[1].nodes().into_iter().collect();
    if let Some(node) = surfaces[0].nodes().into_iter().find(|n| second.contains(n)) {
        return Err(TieError::SharedNodes {
            tie: tie.name.clone(),
            first: tie.surfaces[0].clone(),
            second: tie.surfaces[1].clone(),
            node,
        });
    }
    let facets = surfaces.map(|surface| mean_facet(mesh, surface));
    let tolerance = tie
        .tolerance
        .unwrap_or_else(|| TOLERANCE_SHARE * facets[0].max(facets[1]).sqrt());
    let seen = |reach: f64| [0, 1].map(|own| one_side(scene, surfaces, own, reach));
    let share = |seam: &Seam| seam.areas[0] / seam.areas[1];
    let mut seams = seen(tolerance);
    let shares = [share(&seams[0]), share(&seams[1])];
    let [first, second] = tie.surfaces.clone();
    if shares[0].max(shares[1]) < NOT_COVERED {
        // Do they face each other at all?
        let distance = farthest(&seen(extent(scene))[0]);
        let tie = tie.name.clone();
        return Err(match distance {
            d if d > tolerance => TieError::Apart {
                tie,
                first,
                second,
                distance: d,
                tolerance,
            },
            _ => TieError::NoOverlap { tie, first, second },
        });
    }
    let follows = match shares.map(|s| s >= COVERED) {
        [true, false] => 0,
        [false, true] => 1,
        [true, true] => usize::from(facets[0] > EQUAL_FACETS * facets[1]),
        [false, false] => usize::from(shares[1] > EQUAL_FACETS * shares[0]),
    };
    let seam = std::mem::replace(
        &mut seams[follows],
        Seam {
            nodes: Vec::new(),
            areas: [0.0; 2],
        },
    );
    let distance = farthest(&seam);
    if distance > tolerance {
        return Err(TieError::Apart {
            tie: tie.name.clone(),
            first,
            second,
            distance,
            tolerance,
        });
    }
    let joint = Joint {
        follows,
        distance,
        tolerance,
        covered: shares[follows],
    };
    Ok((joint, surfaces[follows], seam))
}

fn one_side(scene: &Scene, surfaces: [&Surface; 2], own: usize, reach: f64) -> Seam {
    let moduli = vec![1.0; scene.materials.len()];
    seam(&Pair {
        mesh: &scene.mesh,
        carrier: surfaces[own],
        opposite: Opposite::Surface(surfaces[1 - own]),
        true_geometry: true,
        friction: false,
        closely: true,
        follow: &[],
        reach,
        moduli: &moduli,
        mirrors: &scene.mirrors,
        held: &[],
    })
}

/// The largest distance of the two sides around a node.
fn farthest(seam: &Seam) -> f64 {
    let distances = seam.nodes.iter().map(|node| node.distance);
    distances.fold(0.0, f64::max)
}

/// Mean area of the facets of a surface.
fn mean_facet(mesh: &Mesh, surface: &Surface) -> f64 {
    area(mesh, surface) / surface.faces.len().max(1) as f64
}
