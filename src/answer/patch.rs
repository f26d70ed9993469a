//! A contact at a point or over an ellipse, where both surfaces have a shape that is known: Hertz's figures of it.

use crate::analytic::hertz::EllipticContact;
use crate::analytic::subsurface::EllipseField;
use crate::answer::results::below::{flows_below, is_layered};
use crate::answer::results::interface::Interface;
use crate::answer::results::load::{cutting_pair, times};
use crate::answer::results::symmetry_planes::SymmetryPlanes;
use crate::ground::geometry::dot;
use crate::model::mesh::shape::Shape;
use crate::model::scene::Scene;
use crate::model::state::{ContactField, State};
use nalgebra::{Matrix2, Vector3};
use serde::Serialize;

/// Hertz's elliptic contact under the force that a patch carries.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PatchFigures {
    /// Where its force acts, on the undeformed surface of the modelled part.
    pub at: [f64; 3],
    /// Patches like this one in the whole.
    pub images: usize,
    /// Its force: the integral of the pressure.
    pub force: f64,
    /// Relative radii of curvature in the principal planes, the larger one first; alike for a sphere on a flat.
    pub relative_radii: [f64; 2],
    /// Semi-axes of the ellipse in those planes, the longer one first.
    pub semi_axes: [f64; 2],
    /// Hertz's peak pressure p0.
    pub hertz_p0: f64,
    /// Approach of distant points of the two bodies.
    pub approach: f64,
    /// Largest Mises stress on the axis below it over p0, in the upper and the lower body; null of a rigid plane.
    pub mises_over_p0: [Option<f64>; 2],
    /// Why the patch is not Hertz's, where it is not.
    pub departs: Option<&'static str>,
}

const FLOWS: &str = "steel flows below it";
const LAYER: &str = "another material lies just below it";
const LARGE: &str = "it is not small beside the radii";
const AREA: &str = "its area is not that of the ellipse";

/// A patch is small while its short semi-axis is up to this share of the smaller radius: there Hertz's parabola leaves
/// a circle by 2 %.
const SMALL: f64 = 0.3;
/// By how much the area of nodes may differ from the ellipse: a coarse mesh knows it no better.
const SHARE: f64 = 0.5;
/// Relative curvatures below this share of the largest are none: the contact is a line.
const FLAT: f64 = 1e-9;

impl PatchFigures {
    /// The patch of contact pair `pair`; `None` where a surface has no shape that is known, where the surfaces do not
    /// curve apart in both directions, and where nothing presses.
    pub fn find(scene: &Scene, state: &State, pair: usize, measured: &Interface) -> Option<Self> {
        let (contact, field) = (scene.contacts.get(pair)?, state.contacts.get(pair)?);
        let sides = [&contact.upper, &contact.lower].map(|side| side.shape(&scene.mesh));
        if sides.contains(&Shape::Facets) {
            return None;
        }
        let mut at = centre(scene, field)?;
        let pressing = || (0..field.nodes.len()).filter(|i| field.is_active(*i));
        // Planes of symmetry that supports make cut it in half, and forces are those of the half.
        let mut halves = 1.0;
        for (axis, centre) in at.iter_mut().enumerate() {
            let places = pressing().map(|i| scene.mesh.points[field.nodes[i] as usize][axis]);
            if let Some(plane) = SymmetryPlanes::of(scene, pair, axis).held(places) {
                (*centre, halves) = (plane, 2.0 * halves);
            }
        }
        let curvatures = relative_curvatures(&sides, at)?;
        if curvatures[0] <= FLAT * curvatures[1] {
            return None;
        }
        // What is measured is of all that mirrors through the bodies make of the pair; one patch is what those through it make.
        let cut = scene.mirrors_that_cut(pressing().map(|i| field.nodes[i]));
        let images = 1 << (scene.mirrors.len() - cut.len());
        let one = halves * times(&cut) / times(&cutting_pair(scene, pair));
        let [force, area] = [measured.pressure_integral, measured.area].map(|all| one * all);
        let compliance = scene.compliance(contact).ok()?;
        let hertz = EllipticContact::new(force, curvatures.map(|k| 0.5 * k), compliance).ok()?;
        let [a, b] = hertz.semi_axes;
        let radii = sides.iter().filter_map(Shape::radius);
        let radius = radii.fold(f64::INFINITY, f64::min);
        let ellipse = std::f64::consts::PI * a * b;
        let bodies = contact.bodies(&scene.mesh);
        let departs = match () {
            () if flows_below(scene, state, contact, (at, a)) => Some(FLOWS),
            () if is_layered(scene, contact, (at, a)) => Some(LAYER),
            () if b > SMALL * radius => Some(LARGE),
            () if (area / ellipse - 1.0).abs() > SHARE => Some(AREA),
            () => None,
        };
        let mises = |body: Option<usize>| {
            let steel = scene.materials.get(body?)?;
            let field = EllipseField::below(&hertz, steel.poissons_ratio).ok()?;
            Some(field.peak_mises_on_axis().value / hertz.peak_pressure)
        };
        Some(Self {
            at,
            images,
            force,
            relative_radii: curvatures.map(f64::recip),
            semi_axes: hertz.semi_axes,
            hertz_p0: hertz.peak_pressure,
            approach: hertz.approach,
            mises_over_p0: bodies.map(mises),
            departs,
        })
    }
}

/// Centre of the forces on the modelled part; `None` where nothing presses.
fn centre(scene: &Scene, field: &ContactField) -> Option<[f64; 3]> {
    let (mut sum, mut total) = ([0.0; 3], 0.0);
    for (i, node) in field.nodes.iter().enumerate() {
        let force = field.multiplier[i].max(0.0) * field.area[i];
        total += force;
        let point = scene.mesh.points[*node as usize];
        (0..3).for_each(|k| sum[k] += force * point[k]);
    }
    (total > 0.0).then(|| sum.map(|s| s / total))
}

/// The two principal relative curvatures of the surfaces at a point, ascending; `None` where they do not curve apart.
fn relative_curvatures(sides: &[Shape; 2], at: [f64; 3]) -> Option<[f64; 2]> {
    let (_, normal) = sides[0].project(at)?;
    let normal = Vector3::from(normal);
    let away = Vector3::ith(normal.iamin(), 1.0);
    let u = normal.cross(&away).try_normalize(0.0)?;
    let v = normal.cross(&u);
    let sum = sides.iter().fold(Matrix2::zeros(), |sum, side| {
        sum + curvature(side, [u.into(), v.into()])
    });
    let mut values: [f64; 2] = sum.symmetric_eigenvalues().into();
    values.sort_by(f64::total_cmp);
    (values[1] > 0.0 && values[0] >= -FLAT * values[1] && values.iter().all(|v| v.is_finite()))
        .then_some(values)
}

/// Curvature of a surface along two tangents, convex positive.
fn curvature(shape: &Shape, tangents: [[f64; 3]; 2]) -> Matrix2<f64> {
    let signed = |radius: f64, convex: bool| if convex { 1.0 / radius } else { -1.0 / radius };
    match *shape {
        Shape::Sphere { radius, convex, .. } => Matrix2::identity() * signed(radius, convex),
        Shape::Cylinder {
            axis,
            radius,
            convex,
            ..
        } => {
            let [s, t] = tangents.map(|tangent| dot(tangent, axis));
            // Along the axis a cylinder is straight.
            let along = Matrix2::new(s * s, s * t, s * t, t * t);
            (Matrix2::identity() - along) * signed(radius, convex)
        }
        Shape::Plane { .. } | Shape::Facets => Matrix2::zeros(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cylinder(axis: [f64; 3], radius: f64, convex: bool) -> Shape {
        Shape::Cylinder {
            point: [0.0, 0.0, -radius],
            axis,
            radius,
            convex,
        }
    }

    /// Crossed cylinders: 1/R1 and 1/R2. Turned by an angle: the sum of the squares of Johnson (4.3).
    #[test]
    fn curvatures_of_crossed_cylinders() {
        let sides = [
            cylinder([1.0, 0.0, 0.0], 10.0, true),
            cylinder([0.0, 1.0, 0.0], 20.0, true),
        ];
        let k = relative_curvatures(&sides, [0.0; 3]).unwrap();
        assert!((k[0] - 0.05).abs() < 1e-15 && (k[1] - 0.1).abs() < 1e-15);
        let angle = 0.5f64;
        let turned = [
            sides[0],
            cylinder([angle.cos(), angle.sin(), 0.0], 20.0, true),
        ];
        let k = relative_curvatures(&turned, [0.0; 3]).unwrap();
        let difference = (0.01 + 0.0025 + 2.0 * 0.1 * 0.05 * (2.0 * angle).cos()).sqrt();
        assert!((k[0] + k[1] - 0.15).abs() < 1e-15 && (k[1] - k[0] - difference).abs() < 1e-15);
    }

    #[test]
    fn a_ball_in_a_groove_is_flatter_along_it_and_parallel_cylinders_are_a_line() {
        let ball = Shape::Sphere {
            centre: [0.0, 0.0, 10.0],
            radius: 10.0,
            convex: true,
        };
        let k = relative_curvatures(&[ball, cylinder([1.0, 0.0, 0.0], 12.5, false)], [0.0; 3]);
        let k = k.unwrap();
        assert!((k[0] - 0.02).abs() < 1e-15 && (k[1] - 0.1).abs() < 1e-15);
        let alike = cylinder([1.0, 0.0, 0.0], 10.0, true);
        let k = relative_curvatures(&[alike, alike], [0.0; 3]).unwrap();
        assert!(k[0] <= FLAT * k[1]);
        // A ball in a hole that is tighter than it does not curve apart.
        let tight = cylinder([1.0, 0.0, 0.0], 8.0, false);
        assert_eq!(relative_curvatures(&[ball, tight], [0.0; 3]), None);
    }
}
