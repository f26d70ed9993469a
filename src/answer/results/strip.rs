//! The half-width of a strip of contact pressure.

use super::quad::integrate;
use crate::model::mesh::{Mesh, Surface};
use crate::model::state::ContactField;

/// Which part of a contact surface is one strip, and which way it is wide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// The axis (0, 1, 2) across the strip.
    pub across: usize,
    /// Coordinate of the middle across the strip, or `None` for the centre of pressure. Give it
    /// where a mirror plane cuts the strip.
    pub middle: Option<f64>,
    /// Only faces whose centre lies inside this box count.
    pub within: [(f64, f64); 3],
}

impl Strip {
    /// The strip across `axis` that takes the whole surface.
    pub fn across(axis: usize) -> Self {
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        Self {
            across: axis,
            middle: None,
            within: [all; 3],
        }
    }
}

/// Half-width a = 2 sqrt(∫ p x² / ∫ p), in the length unit of the scene; `None` without pressure.
///
/// The pressure is that of the hat functions that carry it, integrated exactly over flat faces; x is the undeformed distance from the middle.
pub fn half_width(
    mesh: &Mesh,
    surface: &Surface,
    field: &ContactField,
    strip: &Strip,
) -> Option<f64> {
    if strip.across > 2 {
        return None;
    }
    let pressure_of = |node: u32| {
        field
            .nodes
            .binary_search(&node)
            .ok()
            .map_or(0.0, |i| field.multiplier[i])
    };
    // Moments about a point of the strip, lest a far origin cost digits.
    let origin = strip.middle.unwrap_or_else(|| {
        let first = surface
            .faces
            .first()
            .map(|f| mesh.points[f.nodes[0] as usize]);
        first.map_or(0.0, |p| p[strip.across])
    });
    let mut moments = [0.0; 3];
    for face in &surface.faces {
        let corners = face.corners(mesh);
        let inside = (0..3).all(|i| {
            let centre = 0.25 * corners.iter().map(|c| c[i]).sum::<f64>();
            strip.within[i].0 <= centre && centre <= strip.within[i].1
        });
        let pressure = face.nodes.map(pressure_of);
        if !inside || pressure == [0.0; 4] {
            continue;
        }
        integrate(&corners, |shape, area| {
            let p: f64 = shape.iter().zip(pressure).map(|(n, p)| n * p).sum();
            let x: f64 = shape
                .iter()
                .zip(corners)
                .map(|(n, c)| n * (c[strip.across] - origin))
                .sum();
            for (power, moment) in moments.iter_mut().enumerate() {
                *moment += p * x.powi(power as i32) * area;
            }
        });
    }
    let [force, first, second] = moments;
    if force <= 0.0 {
        return None;
    }
    let centre = if strip.middle.is_some() {
        0.0
    } else {
        first / force
    };
    Some(2.0 * (second / force - centre * centre).max(0.0).sqrt())
}
