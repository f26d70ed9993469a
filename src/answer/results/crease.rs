//! The line along which two planes of a surface meet below a strip, as at the bottom of a V.

use super::strip_row::StripRow;
use crate::ground::geometry::{Vec3, cross, dot, norm, sub, unit};
use crate::model::mesh::shape::{Shape, fit};
use crate::model::mesh::{Face, Mesh, Surface};

/// Two planes that meet beside or below the middle of a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crease {
    /// Half of the angle between their normals.
    slope: f64,
    /// From the middle of the strip to the line along which they meet.
    distance: f64,
}

impl Crease {
    /// That of faces about a row of a strip along `line`; `None` where they lie on one plane, or not on two.
    pub fn between(mesh: &Mesh, about: &Surface, line: &Vec3, row: &StripRow) -> Option<Self> {
        /// Cosine of the angle from which on two facets are of one plane: a thousandth, as rounded coordinates turn them.
        const ONE_PLANE: f64 = 1.0 - 0.5e-6;
        let normal = |face: &Face| unit(face.area_vector(mesh));
        let first = normal(about.faces.first()?)?;
        let is_beside =
            |face: &Face| normal(face).is_some_and(|normal| dot(normal, first) >= ONE_PLANE);
        let (one, other) = about.faces.iter().partition(|face| is_beside(face));
        let plane = |faces| {
            let name = about.name.clone();
            match fit(mesh, &Surface { name, faces }) {
                Shape::Plane { point, normal } => Some((point, normal)),
                _ => None,
            }
        };
        let ((a, m), (b, n)) = (plane(one)?, plane(other)?);
        let along = cross(m, n);
        let turn = norm(along);
        if dot(along, *line).abs() < 0.99 * turn {
            return None;
        }
        // Square to the line: heights of the middle above both planes say how far off it is.
        let (over, under) = (dot(sub(row.centre, a), m), dot(sub(row.centre, b), n));
        let cosine = dot(m, n);
        let off = over * over + under * under - 2.0 * over * under * cosine;
        Some(Self {
            slope: 0.5 * turn.atan2(cosine),
            distance: off.max(0.0).sqrt() / turn,
        })
    }

    /// That of a plane and its own image, where a plane of symmetry square to the direction `across` cuts the strip.
    pub fn with_image(shape: &Shape, across: &Vec3) -> Option<Self> {
        match shape {
            Shape::Plane { normal, .. } => Some(Self {
                slope: dot(*normal, *across).abs().min(1.0).asin(),
                distance: 0.0,
            }),
            _ => None,
        }
    }

    /// Does it split the strip in two? The half-width is `a`, of bodies with the relative radius R.
    ///
    /// Slopes θ beside the gap x²/2R of Hertz change his pressure by some (2/π) θ R/a (Johnson, Contact Mechanics,
    /// sections 4.2 and 5.2).
    pub fn splits(&self, a: f64, radius: f64) -> bool {
        const LITTLE: f64 = 0.01;
        self.distance < 0.5 * a && self.slope > LITTLE * a / radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::Block;

    /// The top of a block from -1 to 1, its heights a function of the coordinate across.
    fn crease(height: impl Fn(f64) -> f64, middle: f64) -> Option<Crease> {
        let x = (0..=10).map(|i| 0.2 * f64::from(i) - 1.0).collect();
        let mut mesh = Block::new("b", x, vec![0.0, 1.0, 2.0], vec![0.0, 1.0])
            .build()
            .unwrap();
        for point in &mut mesh.points {
            point[2] += height(point[0]);
        }
        let row = StripRow {
            centre: [middle, 1.0, 1.0],
            ..StripRow::default()
        };
        Crease::between(
            &mesh,
            mesh.surface("z_max").unwrap(),
            &[0.0, 1.0, 0.0],
            &row,
        )
    }

    #[test]
    fn two_planes_have_one_and_round_surfaces_none() {
        let found = crease(|x| 0.05 * x.abs(), 0.3).unwrap();
        assert!((found.slope - 0.05f64.atan()).abs() < 1e-12);
        // From (0.3, 0) to the bottom of the V at the origin.
        assert!((found.distance - 0.3).abs() < 1e-9);
        assert_eq!(crease(|x| 0.05 * x * x, 0.0), None);
        assert_eq!(crease(|x| 0.05 * x, 0.0), None);
    }

    #[test]
    fn a_strip_is_split_by_slopes_below_its_middle() {
        let below = crease(|x| 0.05 * x.abs(), 0.0).unwrap();
        assert!(below.splits(0.1, 1.0));
        assert!(!below.splits(0.1, 0.01));
        assert!(!crease(|x| 0.05 * x.abs(), 0.3).unwrap().splits(0.1, 1.0));
    }
}
