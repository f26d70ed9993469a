//! How well the nodes of a contact surface resolve the pressure.

use super::{Claim, Errors, Quantity};
use crate::results::State;
use crate::results::contact_lines::contact_lines;
use crate::results::edges::carrier;
use crate::results::interface::Interface;
use crate::results::line_load::Slices;
use crate::results::load::copies;
use crate::scene::Scene;
use std::collections::BTreeSet;
use std::f64::consts::PI;

const UNRESOLVED: &str = "the nodes are farther apart than the strip of contact is wide: the figure \
                          belongs to the mesh";

/// The strip of pressure that carries most.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Width {
    /// Half-width of the strip, or radius of the patch.
    half: f64,
    /// Distance of its nodes.
    spacing: f64,
}

impl Width {
    /// Of the line of contact that carries most per length.
    fn of_line(scene: &Scene, state: &State, pair: usize) -> Option<Self> {
        let axis = Slices::equal(scene, pair, 1)?.axis;
        let lines = contact_lines(scene, state, pair, axis);
        let loaded = lines.iter().filter_map(|line| Some((line.peak()?.0, line)));
        let (_, heaviest) = loaded.max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Self {
            half: heaviest.half_width,
            spacing: heaviest.spacing,
        })
    }

    /// Of a patch that is no strip: a circle of the area of the nodes that press.
    fn of_patch(scene: &Scene, state: &State, pair: usize) -> Option<Self> {
        let field = state.contacts.get(pair)?;
        let (mut nodes, mut area) = (0.0, 0.0);
        for i in (0..field.nodes.len()).filter(|i| field.is_active(*i)) {
            // A node on a mirror plane stands for as much on its other side.
            let at = &scene.mesh.points[field.nodes[i] as usize];
            let images = 0.5f64.powi(scene.mirrors_through(at).count() as i32);
            nodes += images;
            area += field.area[i];
        }
        (nodes > 0.0).then(|| Self {
            half: (copies(scene) * area / PI).sqrt(),
            spacing: (area / nodes).sqrt(),
        })
    }

    /// Are there nodes within the strip?
    fn is_resolved(&self) -> bool {
        self.spacing < self.half
    }

    /// Relative error of peak pressure and half-width: (h/a)²/4. Of the half-width it is what is
    /// measured on problem H (7.1, 1.64, 0.39 and 0.11 % at h/a = 1/2 to 1/16); the peak of a profile
    /// of straight pieces misses p'' h²/8, which is as much.
    fn error(&self) -> f64 {
        0.25 * (self.spacing / self.half).powi(2)
    }
}

/// Peak pressure, half-width and area of an interface. The rim of the area lies anywhere in the
/// elements of its last nodes: half their area.
pub(super) fn claims(
    scene: &Scene,
    state: &State,
    pair: usize,
    interface: &Interface,
) -> Vec<Claim> {
    let strip = Width::of_line(scene, state, pair);
    let patch = || Width::of_patch(scene, state, pair);
    let Some(width) = strip.or_else(patch) else {
        return Vec::new();
    };
    let resolved = width.is_resolved();
    let claim = |what: Quantity, value: f64, error: Option<f64>| Claim {
        what,
        place: interface.name.clone(),
        value,
        error: Errors {
            discretisation: error,
            ..Errors::default()
        },
        note: (!resolved).then_some(UNRESOLVED),
    };
    let error = |value: f64| resolved.then(|| width.error() * value);
    let peak = interface.max_pressure;
    let mut claims = vec![claim(Quantity::PeakPressure, peak, error(peak))];
    let strip = strip.filter(|_| resolved);
    claims.extend(strip.map(|s| claim(Quantity::HalfWidth, s.half, error(s.half))));
    let band = 0.5 * copies(scene) * rim(scene, state, pair);
    let band = resolved.then_some(band);
    claims.push(claim(Quantity::ContactArea, interface.area, band));
    claims
}

/// Area of the nodes that press next to one that does not, modelled part.
fn rim(scene: &Scene, state: &State, pair: usize) -> f64 {
    let (Some(field), Some(surface)) = (state.contacts.get(pair), carrier(scene, pair)) else {
        return 0.0;
    };
    let index = |node: u32| field.nodes.binary_search(&node).ok();
    let mut rim = BTreeSet::new();
    for face in &surface.faces {
        for side in 0..4 {
            let ends = [face.nodes[side], face.nodes[(side + 1) % 4]].map(index);
            let [Some(a), Some(b)] = ends else { continue };
            match [field.is_active(a), field.is_active(b)] {
                [true, false] => rim.insert(a),
                [false, true] => rim.insert(b),
                _ => false,
            };
        }
    }
    rim.iter().map(|i| field.area[*i]).sum()
}
