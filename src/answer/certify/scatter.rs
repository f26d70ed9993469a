//! How far the pressures of nodes are from a smooth pressure.

use super::fall::from_peak;
use crate::answer::results::around::IRREGULAR;
use crate::ground::geometry::{Vec3, add, bounds, dot, norm, scale, sub, tangents, unit};
use crate::model::scene::Scene;
use crate::model::state::ContactField;
use nalgebra::{DMatrix, DVector};
use std::array::from_fn;
use std::collections::BTreeSet;

/// Nodes as far as this from a peak, in faces, say how smooth pressures are there,
const RINGS: usize = 2;
/// if they press by more than this share of it: nearer to the rim pressures fall too steeply.
const PRESSING: f64 = 0.5;

/// Relative: by how much the largest pressure, of the node `top`, differs from that of the smooth pressure next to those of
/// the nodes around it, and by how much these scatter about that.
///
/// Smooth is a pressure whose square is a polynomial of the second degree of the place, as of Hertz (Johnson, Contact
/// Mechanics, section 4.2). Zero where as many nodes as it has coefficients, or fewer, press, and on a grid: what is left there
/// is of that pressure, and no scatter.
pub(super) fn about(scene: &Scene, field: &ContactField, pair: usize, top: usize) -> f64 {
    let near = around(scene, field, pair, top);
    if is_grid(scene, field, pair, &near) {
        return 0.0;
    }
    let Some(frame) = frame_at(scene, field, pair, top) else {
        return 0.0;
    };
    let points = near.into_iter().flat_map(|i| {
        let share = field.pressure[i] / field.pressure[top];
        let places = from_peak(scene, field.nodes[top], field.nodes[i]).into_iter();
        places.map(move |away| (frame.map(|along| dot(away, along)), share))
    });
    off_smooth(&points.collect::<Vec<_>>()).unwrap_or(0.0)
}

/// Pressures are given by their places from the peak and over the largest one.
fn off_smooth(points: &[([f64; 2], f64)]) -> Option<f64> {
    const NOTHING: f64 = 1e-9;
    let places = points.iter().flat_map(|(place, _)| place);
    let reach = places.fold(0.0f64, |most, x| most.max(x.abs()));
    let terms = DMatrix::from_fn(points.len(), 6, |row, term| {
        let [u, v] = points[row].0.map(|x| x / reach);
        [1.0, u, v, u * u, u * v, v * v][term]
    });
    let squares = DVector::from_iterator(points.len(), points.iter().map(|(_, p)| p * p));
    let parts = (reach > 0.0).then(|| terms.clone().svd(true, true))?;
    let free = points.len().checked_sub(parts.rank(NOTHING))?;
    if free == 0 {
        return None;
    }
    let fitted = parts.solve(&squares, NOTHING).ok()?;
    // That of a root is half of that of its square.
    let scatter = 0.5 * ((squares - terms * &fitted).norm_squared() / free as f64).sqrt();
    Some((fitted[0].max(0.0).sqrt() - 1.0).abs() + scatter)
}

/// Are the elements below these nodes of the carrier, and those of the other side as near, parts of a grid?
fn is_grid(scene: &Scene, field: &ContactField, pair: usize, near: &[usize]) -> bool {
    let point = |node: u32| scene.mesh.points[node as usize];
    let [low, high] = bounds(near.iter().map(|i| point(field.nodes[*i])));
    let middle = scale(add(low, high), 0.5);
    let reach = 0.5 * norm(sub(high, low));
    let inside = |node: &u32| norm(sub(point(*node), middle)) <= reach;
    let sides = scene.contacts[pair].carrier_first().into_iter();
    let surfaces = sides.filter_map(|side| side.surface(&scene.mesh));
    let mut faces = surfaces.flat_map(|surface| &surface.faces);
    !faces.any(|face| {
        face.nodes.iter().any(inside) && scene.mesh.distortion(face.element as usize) > IRREGULAR
    })
}

/// Two axes along the surface at a node.
fn frame_at(scene: &Scene, field: &ContactField, pair: usize, node: usize) -> Option<[Vec3; 2]> {
    let surface = scene.carrier(pair)?;
    let normal = surface.area_vector_at(&scene.mesh, field.nodes[node]);
    Some(tangents(unit(normal)?))
}

/// The nodes around a peak, itself among them, see [`RINGS`].
fn around(scene: &Scene, field: &ContactField, pair: usize, top: usize) -> Vec<usize> {
    let faces = scene.carrier(pair).into_iter().flat_map(|s| &s.faces);
    let mut ring = BTreeSet::from([field.nodes[top]]);
    for _ in 0..RINGS {
        let touched = faces
            .clone()
            .filter(|f| f.nodes.iter().any(|n| ring.contains(n)));
        ring = touched.flat_map(|face| face.nodes).collect();
    }
    let index = ring
        .iter()
        .filter_map(|n| field.nodes.binary_search(n).ok());
    index
        .filter(|i| field.pressure[*i] > PRESSING * field.pressure[top])
        .collect()
}

/// By how much pressures differ from the mean of those beside them, in the mean over the area that presses.
pub(super) fn mean(scene: &Scene, field: &ContactField, pair: usize) -> f64 {
    let off = off_beside(scene, field, pair, |i| [field.pressure[i]]);
    let pressing = (0..field.nodes.len()).filter(|i| field.pressure[*i] > 0.0);
    let [sum, area] = pressing.fold([0.0; 2], |[sum, area], i| {
        [sum + field.area[i] * off[i][0].abs(), area + field.area[i]]
    });
    if area > 0.0 { sum / area } else { 0.0 }
}

/// The force that by how much tractions differ from the mean of those beside them makes, whatever its directions.
pub(super) fn of_tractions(scene: &Scene, field: &ContactField, pair: usize) -> f64 {
    let off = off_beside(scene, field, pair, |i| field.traction[i]);
    let nodes = off.into_iter().zip(&field.area);
    nodes.map(|(off, area)| norm(off) * area).sum()
}

/// What a value of every node of the carrier differs by from the mean of those at the other ends of its edges.
fn off_beside<const N: usize>(
    scene: &Scene,
    field: &ContactField,
    pair: usize,
    value: impl Fn(usize) -> [f64; N],
) -> Vec<[f64; N]> {
    let faces = scene.carrier(pair).into_iter().flat_map(|s| &s.faces);
    let edges: BTreeSet<[u32; 2]> = faces
        .flat_map(|f| [0, 1, 2, 3].map(|side| f.edge(side)))
        .collect();
    let mut beside = vec![([0.0; N], 0.0); field.nodes.len()];
    for ends in edges {
        if let [Ok(a), Ok(b)] = ends.map(|node| field.nodes.binary_search(&node)) {
            for (own, other) in [(a, b), (b, a)] {
                let (sum, number) = &mut beside[own];
                sum.iter_mut()
                    .zip(value(other))
                    .for_each(|(sum, v)| *sum += v);
                *number += 1.0;
            }
        }
    }
    let off = |(i, (sum, number)): (usize, ([f64; N], f64))| {
        let own = value(i);
        from_fn(|k| match number > 0.0 {
            true => own[k] - sum[k] / number,
            false => 0.0,
        })
    };
    beside.into_iter().enumerate().map(off).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a grid of 5 by 5 nodes of the spacing 1.
    fn off(pressure: impl Fn(f64, f64) -> f64) -> Option<f64> {
        let point = |i: i32| {
            let [u, v] = [f64::from(i % 5 - 2), f64::from(i / 5 - 2)];
            ([u, v], pressure(u, v) / pressure(0.0, 0.0))
        };
        off_smooth(&(0..25).map(point).collect::<Vec<_>>())
    }

    #[test]
    fn hertz_is_smooth_and_one_node_that_is_off_is_seen() {
        let hertz =
            |u: f64, v: f64| (1.0 - (u * u + 0.5 * v * v + 0.2 * u * v + 0.1 * u) / 20.0).sqrt();
        assert!(off(hertz).is_some_and(|off| off < 1e-12));
        let low = |u: f64, v: f64| hertz(u, v) * if u == 0.0 && v == 0.0 { 0.97 } else { 1.0 };
        let found = off(low).unwrap();
        assert!((0.025..0.04).contains(&found), "{found}");
    }

    #[test]
    fn as_few_nodes_as_terms_say_nothing() {
        assert_eq!(off_smooth(&[([0.0; 2], 1.0)]), None);
        let few: Vec<([f64; 2], f64)> = (0..3).map(|i| ([f64::from(i), 0.0], 1.0)).collect();
        assert_eq!(off_smooth(&few), None);
    }
}
