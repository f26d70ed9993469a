//! Directions that a cloud of nodes has of its own, however it is turned.

use super::line_frame::unit_along;
use crate::ground::geometry::{Vec3, cross, dot, range, scale, sub, tangents, unit};
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::Scene;
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// The three axes.
pub(super) const AXES: [Vec3; 3] = [unit_along(0), unit_along(1), unit_along(2)];

/// Three directions, square to each other, in which nodes lie far apart or near to each other: those of the sides of a block or a
/// rectangle, and the axis of a half cylinder among them, whatever its ends are. Where two are as good as any others in their plane,
/// as of a square, the line through the two nodes of `side` says which.
pub(super) fn own_directions(scene: &Scene, nodes: &[u32], side: [u32; 2]) -> [Vec3; 3] {
    /// Difference of spreads, of the largest, below which they are alike.
    const ALIKE: f64 = 1e-3;
    let point = |node: u32| scene.mesh.points[node as usize];
    let places: Vec<Vector3<f64>> = nodes.iter().map(|n| point(*n).into()).collect();
    let middle = places.iter().sum::<Vector3<f64>>() / places.len().max(1) as f64;
    let arms = places.iter().map(|place| place - middle);
    let mut moments: Matrix3<f64> = arms.map(|arm| arm * arm.transpose()).sum();
    // Images make a mirror's normal a direction of their own.
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        if scene.mirrors.contains(&i) || scene.mirrors.contains(&j) {
            (moments[(i, j)], moments[(j, i)]) = (0.0, 0.0);
        }
    }
    let spread = SymmetricEigen::new(moments);
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| spread.eigenvalues[*b].total_cmp(&spread.eigenvalues[*a]));
    let [most, middle, least] = order.map(|k| spread.eigenvalues[k]);
    let [first, second, third] =
        order.map(|k| snapped(spread.eigenvectors.column(k).into_owned().into()));
    let side = sub(point(side[1]), point(side[0]));
    let about = |own: Vec3| {
        let across = unit(sub(side, scale(own, dot(own, side))));
        let across = across.map_or_else(|| tangents(own)[0], snapped);
        [own, across, snapped(cross(own, across))]
    };
    match [most - middle, middle - least].map(|by| by < ALIKE * most) {
        [true, true] => about(unit(side).map_or(first, snapped)),
        [true, false] => about(third),
        [false, true] => about(first),
        [false, false] => [first, second, third],
    }
}

/// The axes, or [`own_directions`] where the box along these is the smaller one by its surface.
pub(super) fn box_directions(scene: &Scene, nodes: &[u32], side: [u32; 2]) -> [Vec3; 3] {
    const SMALLER: f64 = 0.99;
    let surface = |directions: &[Vec3; 3]| {
        let [a, b, c] = directions.map(|along| length(&scene.mesh, nodes, along));
        a * b + b * c + c * a
    };
    let own = own_directions(scene, nodes, side);
    match surface(&own) < SMALLER * surface(&AXES) {
        true => own,
        false => AXES,
    }
}

/// The first side of the first face of a surface.
pub(super) fn first_side(surface: &Surface) -> [u32; 2] {
    surface.faces.first().map_or([0; 2], |face| face.edge(0))
}

/// How far nodes are apart along a direction.
pub(super) fn length(mesh: &Mesh, nodes: &[u32], along: Vec3) -> f64 {
    let [low, high] = range(nodes.iter().map(|n| dot(along, mesh.points[*n as usize])));
    high - low
}

/// A direction, or the axis that it is but for the rounding of coordinates.
pub(super) fn snapped(direction: Vec3) -> Vec3 {
    const ROUNDING: f64 = 1e-4;
    let axis = |axis: &Vec3| 1.0 - dot(*axis, direction).abs() < 0.5 * ROUNDING * ROUNDING;
    AXES.into_iter().find(axis).unwrap_or(direction)
}
