//! The true shape behind the facets of a surface: a plane, a circular cylinder or a sphere.
//!
//! A mesh replaces a round surface by flat facets, whose corners lie on it while their middles
//! lie inside. Where all nodes of a surface fit one shape, and its facets follow that shape, the
//! shape can stand in for the facets.
//!
//! Everything is measured in units of the surface's own size, so the length unit does not matter.

mod fitting;
mod patch;
mod surface_shape;

use nalgebra::Vector3;

use super::{Mesh, Surface};
use patch::Patch;
pub use surface_shape::Shape;

/// How far nodes may be off the shape, as a share of the surface's size: as much as
/// coordinates with six digits are.
const MOST_OFF: f64 = 1e-6;
/// What a round shape may leave of the distance of the nodes from a plane: a plane with rounded
/// coordinates fits some round shape, too, but hardly better.
const MOST_LEFT_OF_PLANE: f64 = 0.01;
/// Facets may subtend twice this angle, in radians (twice 20 degrees), to pass as round: a
/// hexagonal bar is not a cylinder.
const MOST_SUBTENDED: f64 = 0.35;
/// Angle by which rounded coordinates may turn a facet, in radians.
const MOST_TURNED: f64 = 1e-3;

/// The shape on which all nodes of `surface` lie within a millionth of the size of the surface,
/// and from which its facets differ by no more than the angle they subtend.
///
/// A round shape needs four rows of nodes at least, and a sphere a node that is not on the rim;
/// facets may not subtend more than 40 degrees. Anything else, a cone for example, is
/// [`Shape::Facets`].
pub fn fit(mesh: &Mesh, surface: &Surface) -> Shape {
    let Some(patch) = Patch::new(mesh, surface) else {
        return Shape::Facets;
    };
    let (plane, deviation) = patch.plane();
    // A narrow strip of a cylinder is nearly plane: its width is the measure, not its length.
    if deviation <= MOST_OFF * patch.width.min(1.0) && follows(&plane, &patch) {
        return patch.in_place(plane);
    }
    let allowed = MOST_OFF.min(MOST_LEFT_OF_PLANE * deviation);
    let round = [fitting::cylinder(&patch), fitting::sphere(&patch)];
    for shape in round.into_iter().flatten() {
        if off(&shape, &patch) <= allowed && enough_nodes(&shape, &patch) && follows(&shape, &patch)
        {
            return patch.in_place(shape);
        }
    }
    if deviation <= MOST_OFF && follows(&plane, &patch) {
        patch.in_place(plane)
    } else {
        Shape::Facets
    }
}

/// Largest distance of a node from the shape.
fn off(shape: &Shape, patch: &Patch) -> f64 {
    let distance = |p: &Vector3<f64>| match shape.project((*p).into()) {
        Some((foot, _)) => (p - Vector3::from(foot)).norm(),
        None => f64::INFINITY,
    };
    patch.points.iter().map(distance).fold(0.0, f64::max)
}

/// Whether the facets have the normals of the shape, as far as flat facets can.
fn follows(shape: &Shape, patch: &Patch) -> bool {
    let normal_at = |p: Vector3<f64>| shape.project(p.into()).map(|(_, n)| Vector3::from(n));
    patch.facets.iter().all(|facet| {
        let Some(normal) = normal_at(facet.centre) else {
            return false;
        };
        let mut subtended = 0.0f64;
        for corner in facet.corners {
            let Some(there) = normal_at(corner) else {
                return false;
            };
            subtended = subtended.max(angle(normal, there));
        }
        subtended <= MOST_SUBTENDED && angle(normal, facet.normal) <= subtended + MOST_TURNED
    })
}

/// Whether the nodes are enough to tell the shape: three rows of nodes lie on some cylinder, two
/// circles on some sphere, whatever the surface is.
fn enough_nodes(shape: &Shape, patch: &Patch) -> bool {
    match *shape {
        Shape::Cylinder {
            point,
            axis,
            radius,
            ..
        } => patch.rows(point.into(), axis.into(), radius) >= 4,
        Shape::Sphere { .. } => patch.has_inner_node,
        Shape::Plane { .. } | Shape::Facets => true,
    }
}

fn angle(a: Vector3<f64>, b: Vector3<f64>) -> f64 {
    a.cross(&b).norm().atan2(a.dot(&b))
}

#[cfg(test)]
mod tests;
