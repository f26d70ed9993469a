//! A nodal field along a straight line into a body.

use super::recovery::Recovered;
use crate::ground::geometry::{cross, dot, range, sub};
use crate::model::mesh::surface::FACES;
use crate::model::scene::Scene;

/// Barycentric coordinates may miss a triangle by this much: lines run along edges of elements.
const MISS: f64 = 1e-6;

/// Mises stress of the nodal averages of body `body` along the line from `from` in the unit
/// direction `into`, as far as `reach`: distance and stress wherever the line passes from element to
/// element, ascending. Between these it is straight to the accuracy of the elements.
pub fn mises_along(
    scene: &Scene,
    recovered: &Recovered,
    body: usize,
    (from, into): ([f64; 3], [f64; 3]),
    reach: f64,
) -> Vec<(f64, f64)> {
    let mesh = &scene.mesh;
    let Some(body) = mesh.bodies.get(body) else {
        return Vec::new();
    };
    // A line along the surface of touching, or bodies that overlap by the mesh: begin a little above.
    let (low, high) = (-1e-3 * reach, reach);
    let mut found: Vec<(f64, f64)> = Vec::new();
    for element in body.elements.clone() {
        let corners = mesh.corners(element);
        if !may_meet(&corners, from, into, low, high) {
            continue;
        }
        let stress = recovered.points.cells[element].map(|p| recovered.mises_nodal[p as usize]);
        for face in FACES {
            for triangle in [[0, 1, 2], [0, 2, 3]] {
                let at = triangle.map(|k| face[k]);
                let hit = meet(at.map(|c| corners[c]), from, into);
                if let Some((distance, weights)) = hit.filter(|(t, _)| (low..=high).contains(t)) {
                    let value = (0..3).map(|k| weights[k] * stress[at[k]]).sum();
                    found.push((distance, value));
                }
            }
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.dedup_by(|b, a| b.0 - a.0 <= 1e-6 * reach);
    found
}

/// Does the line come near the box around the corners?
fn may_meet(corners: &[[f64; 3]; 8], from: [f64; 3], into: [f64; 3], low: f64, high: f64) -> bool {
    (0..3).all(|k| {
        let [least, most] = range(corners.iter().map(|c| c[k]));
        let slack = 1e-3 * (most - least);
        let ends = [from[k] + low * into[k], from[k] + high * into[k]];
        ends[0].min(ends[1]) <= most + slack && ends[0].max(ends[1]) >= least - slack
    })
}

/// Distance along the line at which it meets a triangle, and the weights of the corners there.
fn meet(corners: [[f64; 3]; 3], from: [f64; 3], into: [f64; 3]) -> Option<(f64, [f64; 3])> {
    let [a, b, c] = corners;
    let (u, v) = (sub(b, a), sub(c, a));
    let normal = cross(u, v);
    let steep = dot(normal, into);
    let size = dot(normal, normal);
    if steep * steep <= 1e-12 * size {
        return None;
    }
    let distance = dot(normal, sub(a, from)) / steep;
    let at = sub([0, 1, 2].map(|k| from[k] + distance * into[k]), a);
    let second = dot(normal, cross(at, v)) / size;
    let third = dot(normal, cross(u, at)) / size;
    let weights = [1.0 - second - third, second, third];
    (weights.iter().all(|w| *w >= -MISS)).then_some((distance, weights))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_meets_a_triangle_at_its_corners_and_inside() {
        let triangle = [[0.0, 0.0, 2.0], [3.0, 0.0, 2.0], [0.0, 3.0, 2.0]];
        let down = [0.0, 0.0, 1.0];
        let (t, weights) = meet(triangle, [1.0, 1.0, 0.0], down).unwrap();
        assert_eq!(t, 2.0);
        assert!(weights.iter().all(|w| (w - 1.0 / 3.0).abs() < 1e-12));
        let (_, corner) = meet(triangle, [3.0, 0.0, 0.0], down).unwrap();
        assert_eq!(corner, [0.0, 1.0, 0.0]);
        assert!(meet(triangle, [2.0, 2.0, 0.0], down).is_none());
        assert!(meet(triangle, [0.0; 3], [1.0, 0.0, 0.0]).is_none());
    }
}
