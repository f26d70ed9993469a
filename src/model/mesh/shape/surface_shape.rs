//! A plane, cylinder or sphere: its curvature, and the projection onto it.

use crate::ground::geometry::dot;
use nalgebra::Vector3;

/// The true shape of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// The plane through `point`; `normal` is the outward unit normal of the body.
    Plane { point: [f64; 3], normal: [f64; 3] },
    /// The circular cylinder about the line through `point` (next to the middle of the surface)
    /// along the unit vector `axis`. `convex` where the body is inside, as a roller is in its
    /// rolling surface; not where it is outside, as a roller is of its bore.
    Cylinder {
        point: [f64; 3],
        axis: [f64; 3],
        radius: f64,
        convex: bool,
    },
    /// The sphere about `centre`; `convex` where the body is inside.
    Sphere {
        centre: [f64; 3],
        radius: f64,
        convex: bool,
    },
    /// None of these: the facets themselves.
    Facets,
}

impl Shape {
    /// Curvature across the direction `along`, convex positive, of a plane or of a cylinder whose axis
    /// makes an angle with it that has a cosine above `parallel`.
    pub fn curvature(&self, along: [f64; 3], parallel: f64) -> Option<f64> {
        match *self {
            Self::Plane { .. } => Some(0.0),
            Self::Cylinder {
                axis,
                radius,
                convex,
                ..
            } if dot(axis, along).abs() > parallel => {
                Some(if convex { 1.0 / radius } else { -1.0 / radius })
            }
            _ => None,
        }
    }

    /// The point of the true surface next to `p`, and the unit normal there that points out of
    /// the body; none for facets, for a point on the axis or at the centre, or for a point that
    /// is not finite.
    pub fn project(&self, p: [f64; 3]) -> Option<([f64; 3], [f64; 3])> {
        let p = Vector3::from(p);
        let (foot, normal) = match *self {
            Shape::Plane { point, normal } => {
                let normal = Vector3::from(normal);
                (p - normal * (p - Vector3::from(point)).dot(&normal), normal)
            }
            Shape::Cylinder {
                point,
                axis,
                radius,
                convex,
            } => {
                let (point, axis) = (Vector3::from(point), Vector3::from(axis));
                let centre = point + axis * (p - point).dot(&axis);
                on_circle(p, centre, radius, convex)?
            }
            Shape::Sphere {
                centre,
                radius,
                convex,
            } => on_circle(p, Vector3::from(centre), radius, convex)?,
            Shape::Facets => return None,
        };
        let finite = foot.iter().chain(&normal).all(|c| c.is_finite());
        finite.then(|| (foot.into(), normal.into()))
    }

    /// Radius of a cylinder or sphere.
    pub fn radius(&self) -> Option<f64> {
        match self {
            Shape::Cylinder { radius, .. } | Shape::Sphere { radius, .. } => Some(*radius),
            Shape::Plane { .. } | Shape::Facets => None,
        }
    }
}

/// The point at `radius` from `centre` towards `p`, and the outward normal of the body there.
fn on_circle(
    p: Vector3<f64>,
    centre: Vector3<f64>,
    radius: f64,
    convex: bool,
) -> Option<(Vector3<f64>, Vector3<f64>)> {
    let out = (p - centre).try_normalize(0.0)?;
    Some((centre + out * radius, if convex { out } else { -out }))
}
