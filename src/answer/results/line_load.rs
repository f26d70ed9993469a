//! The load per length along a roller.

use std::collections::BTreeMap;

use super::load::{self, cutting_pair, times};
use crate::ground::geometry::dot;
use crate::model::mesh::Surface;
use crate::model::mesh::shape::{Shape, fit};
use crate::model::scene::{Partner, Scene};
use crate::model::state::State;

/// Where a line load is cut into slices.
#[derive(Debug, Clone, PartialEq)]
pub struct Slices {
    /// The axis (0, 1, 2) along the carrier body.
    pub axis: usize,
    /// Coordinates of the slice ends, ascending; one more than there are slices.
    pub edges: Vec<f64>,
}

/// Load per length in slices along the carrier body.
#[derive(Debug, Clone, PartialEq)]
pub struct LineLoad {
    /// Where the load is summed.
    pub slices: Slices,
    /// Mean load per length of each slice, along the applied load, compression positive; both
    /// lines of a V together.
    pub q: Vec<f64>,
    /// The axis is mirrored: each slice stands for two, and twice the sum is the load.
    pub mirrored: bool,
    /// Force outside all slices, counted like the slices.
    pub outside: f64,
}

impl Slices {
    /// `count` equal slices over the extent of the carrier surface of pair `pair`, along the roller,
    /// or along the longer horizontal side of the more slender of the two surfaces where none of them
    /// is a cylinder along an axis. `None` without such a surface or without extent.
    pub fn equal(scene: &Scene, pair: usize, count: usize) -> Option<Self> {
        let surface = scene.carrier(pair)?;
        let axis = roller_axis(scene, pair).unwrap_or_else(|| longest_axis(scene, pair, surface));
        let [low, high] = extent(scene, surface, axis);
        let step = (high - low) / count.max(1) as f64;
        let whole = step.is_finite() && step > 0.0;
        whole.then(|| Self {
            axis,
            edges: (0..=count.max(1)).map(|i| low + step * i as f64).collect(),
        })
    }
}

/// Least and largest coordinate of a surface along an axis.
fn extent(scene: &Scene, surface: &Surface, axis: usize) -> [f64; 2] {
    let nodes = surface.faces.iter().flat_map(|f| f.nodes);
    let at = nodes.map(|n| scene.mesh.points[n as usize][axis]);
    let ends = at.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| {
        (low.min(p), high.max(p))
    });
    [ends.0, ends.1]
}

/// The longer horizontal side of the more slender surface of a pair; of the carrier, if both are alike.
fn longest_axis(scene: &Scene, pair: usize, carrier: &Surface) -> usize {
    // A mirrored side is twice as long as it looks.
    let length = |surface: &Surface, axis: usize| {
        let [low, high] = extent(scene, surface, axis);
        match scene.mirrors.contains(&axis) {
            true => 2.0 * (high - low),
            false => high - low,
        }
    };
    let slenderness = |surface: &Surface| {
        let [a, b] = [0, 1].map(|axis| length(surface, axis));
        a.max(b) / a.min(b).max(f64::MIN_POSITIVE)
    };
    let contact = &scene.contacts[pair];
    let sides = [&contact.upper, &contact.lower].into_iter();
    let other = sides.filter_map(|side| side.surface(&scene.mesh));
    let more = |most: &Surface, other: &Surface| slenderness(other) > 1.001 * slenderness(most);
    let slender = other.fold(carrier, |most, other| match more(most, other) {
        true => other,
        false => most,
    });
    usize::from(length(slender, 1) > length(slender, 0))
}

/// The axis along which, or nearly, one of the surfaces of a pair is a cylinder: rollers may be a tenth of a radian askew.
fn roller_axis(scene: &Scene, pair: usize) -> Option<usize> {
    let contact = &scene.contacts[pair];
    [&contact.upper, &contact.lower]
        .into_iter()
        .find_map(|side| {
            let Partner::Surface(name) = side else {
                return None;
            };
            let Shape::Cylinder { axis, .. } = fit(&scene.mesh, scene.mesh.surface(name)?) else {
                return None;
            };
            (0..3).find(|i| axis[*i].abs() > 0.99)
        })
}

/// Line load of contact pair `pair`, of the whole bearing.
///
/// Each node's force is spread evenly over its tributary length along the axis, half way to its
/// neighbours on the surface, and split at the slice ends: nothing is lost or counted twice, so
/// slice means times slice lengths and [`LineLoad::outside`] sum to the load. `None` where the
/// pair has no carrier surface in the mesh or the slices are not ascending.
pub fn line_load(scene: &Scene, state: &State, pair: usize, slices: &Slices) -> Option<LineLoad> {
    let axis = slices.axis;
    let ascending = slices.edges.len() > 1 && slices.edges.windows(2).all(|w| w[0] < w[1]);
    if axis > 2 || !ascending {
        return None;
    }
    let field = state.contacts.get(pair)?;
    let tributary = tributaries(scene, scene.carrier(pair)?, axis);
    let along = load::along(scene, state);
    // A mirror along the axis makes slices of its own, on the other side.
    let mirrored = scene.mirrors.contains(&axis);
    let copies = times(&cutting_pair(scene, pair)) * if mirrored { 0.5 } else { 1.0 };
    let mut load = vec![0.0; slices.edges.len() - 1];
    let mut outside = 0.0;
    for (node, force) in field.nodes.iter().zip(&field.force) {
        let force = copies * dot(*force, along);
        let at = scene.mesh.points[*node as usize][axis];
        let (low, high) = tributary.get(node).copied().unwrap_or((at, at));
        let inside = spread(force, low, high, &slices.edges, &mut load);
        outside += force - inside;
    }
    let lengths = slices.edges.windows(2).map(|w| w[1] - w[0]);
    let q = load
        .iter()
        .zip(lengths)
        .map(|(force, length)| force / length)
        .collect();
    Some(LineLoad {
        slices: slices.clone(),
        q,
        mirrored,
        outside,
    })
}

/// Spreads `force` over [low, high] onto the slices and returns the part that fell on them.
fn spread(force: f64, low: f64, high: f64, edges: &[f64], load: &mut [f64]) -> f64 {
    let mut inside = 0.0;
    let last = load.len() - 1;
    for (i, (slice, ends)) in load.iter_mut().zip(edges.windows(2)).enumerate() {
        let share = if high > low {
            (high.min(ends[1]) - low.max(ends[0])).max(0.0) / (high - low)
        } else {
            let within = low >= ends[0] && (low < ends[1] || (i == last && low <= ends[1]));
            f64::from(u8::from(within))
        };
        *slice += share * force;
        inside += share * force;
    }
    inside
}

/// Range along `axis` that each node of the surface stands for: half way to the farthest node of
/// the faces around it, on both sides.
fn tributaries(scene: &Scene, surface: &Surface, axis: usize) -> BTreeMap<u32, (f64, f64)> {
    let coordinate = |node: u32| scene.mesh.points[node as usize][axis];
    let mut around: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
    for face in &surface.faces {
        let at = face.nodes.map(coordinate);
        let low = at.iter().copied().fold(f64::INFINITY, f64::min);
        let high = at.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for node in face.nodes {
            let range = around.entry(node).or_insert((low, high));
            *range = (range.0.min(low), range.1.max(high));
        }
    }
    for (node, range) in &mut around {
        let at = coordinate(*node);
        *range = (0.5 * (range.0 + at), 0.5 * (range.1 + at));
    }
    around
}
