//! The axis along which the lines of contact of a pair run.

use super::circle::FittedCircle;
use super::load::upright;
use crate::ground::geometry::range;
use crate::model::mesh::shape::{Shape, fit};
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::Scene;

/// The axis (0, 1, 2) of the lines of contact pair `pair`: that about which one of its surfaces is round, a cylinder or
/// a roller with fillets or a crown; else the longer side across the load of the more slender of the two. `None` where
/// the pair has no carrier surface, or where a cylinder lies across all three axes.
pub fn line_axis(scene: &Scene, pair: usize) -> Option<usize> {
    let carrier = scene.carrier(pair)?;
    let contact = &scene.contacts[pair];
    let sides = [&contact.upper, &contact.lower].into_iter();
    let sides: Vec<&Surface> = sides.filter_map(|side| side.surface(&scene.mesh)).collect();
    let axes: Result<Vec<_>, Oblique> = (sides.iter())
        .map(|surface| axis_of_rotation(&scene.mesh, surface))
        .collect();
    let round = axes.ok()?.into_iter().flatten().next();
    Some(round.unwrap_or_else(|| longest_axis(scene, &sides, carrier)))
}

/// Least and largest coordinate of a surface along an axis.
pub(super) fn extent(mesh: &Mesh, surface: &Surface, axis: usize) -> [f64; 2] {
    let nodes = surface.faces.iter().flat_map(|f| f.nodes);
    range(nodes.map(|n| mesh.points[n as usize][axis]))
}

/// From this cosine on a cylinder counts as along an axis: rollers may be a tenth of a radian askew.
const ALONG: f64 = 0.99;

/// A cylinder along none of the axes: sections across these are ellipses.
struct Oblique;

/// The axis along which, or nearly, a surface is a cylinder, or about which
/// its rows of nodes are round. A sphere has none.
fn axis_of_rotation(mesh: &Mesh, surface: &Surface) -> Result<Option<usize>, Oblique> {
    match fit(mesh, surface) {
        Shape::Cylinder { axis, .. } => {
            let along = (0..3).find(|i| axis[*i].abs() > ALONG);
            along.map(Some).ok_or(Oblique)
        }
        Shape::Facets => Ok((0..3).find(|axis| is_round_about(mesh, surface, *axis))),
        Shape::Plane { .. } | Shape::Sphere { .. } => Ok(None),
    }
}

/// Do the nodes of a surface stand in rows across `axis`, each on a circle, and all circles about one line? Those of a
/// surface that is nearly plane stand on circles that are much larger than itself: they count as straight.
fn is_round_about(mesh: &Mesh, surface: &Surface, axis: usize) -> bool {
    const FEWEST_ROWS: usize = 3;
    /// Of the radius, how far the centres may be apart.
    const CENTRED: f64 = 1e-3;
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let [low, high] = extent(mesh, surface, axis);
    let mut nodes: Vec<[f64; 3]> = (surface.nodes().iter())
        .map(|n| mesh.points[*n as usize])
        .collect();
    nodes.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
    let same_row = |a: &[f64; 3], b: &[f64; 3]| b[axis] - a[axis] <= 1e-6 * (high - low);
    let circles: Option<Vec<FittedCircle>> = (nodes.chunk_by(same_row))
        .map(|row| FittedCircle::through(&row.iter().map(|p| [p[u], p[v]]).collect::<Vec<_>>()))
        .collect();
    let Some(circles) = circles.filter(|circles| circles.len() >= FEWEST_ROWS) else {
        return false;
    };
    let size = [u, v].map(|i| extent(mesh, surface, i)).map(|[a, b]| b - a);
    let first = circles[0].centre;
    circles.iter().all(|circle| {
        let [x, y] = circle.centre;
        let off = (x - first[0]).hypot(y - first[1]);
        off <= CENTRED * circle.radius && circle.radius <= size[0].max(size[1])
    })
}

/// The longer side across the load of the more slender surface of a pair; of the carrier, if both are alike.
fn longest_axis(scene: &Scene, sides: &[&Surface], carrier: &Surface) -> usize {
    // A mirrored side is twice as long as it looks.
    let length = |surface: &Surface, axis: usize| {
        let [low, high] = extent(&scene.mesh, surface, axis);
        match scene.mirrors.contains(&axis) {
            true => 2.0 * (high - low),
            false => high - low,
        }
    };
    let across = match upright(scene) {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    };
    let slenderness = |surface: &Surface| {
        let [a, b] = across.map(|axis| length(surface, axis));
        a.max(b) / a.min(b).max(f64::MIN_POSITIVE)
    };
    let more = |most: &Surface, other: &Surface| slenderness(other) > 1.001 * slenderness(most);
    let slender = sides.iter().fold(
        carrier,
        |most, other| if more(most, other) { other } else { most },
    );
    let [one, other] = across;
    if length(slender, other) > length(slender, one) {
        other
    } else {
        one
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, cylindrical, uniform};
    use std::f64::consts::TAU;

    /// A roller along x, half as long as it is wide, whose radius falls by `drop` towards its ends.
    fn roller(drop: impl Fn(f64) -> f64 + 'static) -> Mesh {
        let along_x = move |[r, angle, x]: [f64; 3]| {
            let [y, z, x] = cylindrical([r - drop(x), angle, x]);
            [x, y, z]
        };
        Block::new(
            "roller",
            uniform(1.5, 2.0, 1),
            uniform(0.0, TAU / 2.0, 24),
            uniform(-1.0, 1.0, 10),
        )
        .mapped(along_x)
        .build()
        .unwrap()
    }

    fn axis_of(mesh: &Mesh, name: &str) -> Option<usize> {
        let axis = axis_of_rotation(mesh, mesh.surface(name).unwrap());
        axis.ok().flatten()
    }

    /// The axis of a short roller with a fillet or a crown is that about which it is round, not its longer side.
    #[test]
    fn a_roller_is_round_about_its_axis_whatever_its_ends_are() {
        let fillet = |x: f64| 0.3 - (0.16 - (x.abs() - 0.7).max(0.0).powi(2)).sqrt() + 0.1;
        let crown = |x: f64| 0.01 * x * x;
        assert_eq!(axis_of(&roller(|_| 0.0), "x_max"), Some(0));
        assert_eq!(axis_of(&roller(fillet), "x_max"), Some(0));
        assert_eq!(axis_of(&roller(crown), "x_max"), Some(0));
        // Its flat end has none.
        assert_eq!(axis_of(&roller(crown), "z_max"), None);
    }
}
