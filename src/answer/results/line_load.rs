//! The load per length along a roller.

use std::collections::BTreeMap;

use super::line_direction::line_frame;
use super::line_frame::is_mirrored;
use super::load::{self, cutting_pair, times};
use crate::ground::geometry::{Vec3, dot, range};
use crate::model::mesh::Surface;
use crate::model::scene::Scene;
use crate::model::state::State;

/// Where a line load is cut into slices.
#[derive(Debug, Clone, PartialEq)]
pub struct Slices {
    /// Unit vector along the carrier body.
    pub along: Vec3,
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
    /// `count` equal slices over the extent of the carrier surface of pair `pair`, along its lines of contact.
    /// `None` without such a surface or without extent.
    pub fn equal(scene: &Scene, pair: usize, count: usize) -> Option<Self> {
        Self::along(scene, pair, (line_frame(scene, pair)?.along, count))
    }

    /// The same along another direction.
    pub fn along(scene: &Scene, pair: usize, (along, count): (Vec3, usize)) -> Option<Self> {
        let nodes = scene.carrier(pair)?.nodes().into_iter();
        let [low, high] = range(nodes.map(|n| dot(along, scene.mesh.points[n as usize])));
        let step = (high - low) / count.max(1) as f64;
        let whole = step.is_finite() && step > 0.0;
        whole.then(|| Self {
            along,
            edges: (0..=count.max(1)).map(|i| low + step * i as f64).collect(),
        })
    }
}

/// Line load of contact pair `pair`, of the whole bearing.
///
/// Each node's force is spread evenly over its tributary length along the axis, half way to its
/// neighbours on the surface, and split at the slice ends: nothing is lost or counted twice, so
/// slice means times slice lengths and [`LineLoad::outside`] sum to the load. `None` where the
/// pair has no carrier surface in the mesh or the slices are not ascending.
pub fn line_load(scene: &Scene, state: &State, pair: usize, slices: &Slices) -> Option<LineLoad> {
    let ascending = slices.edges.len() > 1 && slices.edges.windows(2).all(|w| w[0] < w[1]);
    if !ascending {
        return None;
    }
    let field = state.contacts.get(pair)?;
    let tributary = tributaries(scene, scene.carrier(pair)?, &slices.along);
    let along = load::along(scene, state);
    // A mirror along the axis makes slices of its own, on the other side.
    let mirrors = cutting_pair(scene, pair);
    let mirrored = is_mirrored(&slices.along, &mirrors);
    let copies = times(&mirrors) * if mirrored { 0.5 } else { 1.0 };
    let mut load = vec![0.0; slices.edges.len() - 1];
    let mut outside = 0.0;
    for (node, force) in field.nodes.iter().zip(&field.force) {
        let force = copies * dot(*force, along);
        let at = dot(slices.along, scene.mesh.points[*node as usize]);
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

/// Range along a direction that each node of the surface stands for: half way to the farthest node of
/// the faces around it, on both sides.
fn tributaries(scene: &Scene, surface: &Surface, along: &Vec3) -> BTreeMap<u32, (f64, f64)> {
    let coordinate = |node: u32| dot(*along, scene.mesh.points[node as usize]);
    let mut around: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
    for face in &surface.faces {
        let [low, high] = range(face.nodes.map(coordinate));
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
