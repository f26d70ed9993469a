//! The circle through points of a plane.

use nalgebra::{Matrix3, Vector3};

/// A circle.
pub(super) struct FittedCircle {
    pub centre: [f64; 2],
    pub radius: f64,
}

impl FittedCircle {
    /// The circle on which all of `points` lie, within a thousandth of its radius; `None` where they lie on none, or
    /// are too few to tell.
    pub fn through(points: &[[f64; 2]]) -> Option<Self> {
        const OFF: f64 = 1e-3;
        let centre = circle_centre(points)?;
        let from = |p: &[f64; 2]| (p[0] - centre[0]).hypot(p[1] - centre[1]);
        let radius = points.iter().map(from).sum::<f64>() / points.len() as f64;
        let fits = points
            .iter()
            .all(|p| (from(p) - radius).abs() <= OFF * radius);
        (fits && radius.is_finite() && points.len() > 3).then_some(Self { centre, radius })
    }
}

/// Centre of the circle that fits `points` best: least squares on |p|² = 2 c·p + k.
pub(super) fn circle_centre(points: &[[f64; 2]]) -> Option<[f64; 2]> {
    // Shifted to a point of the set, so that a roller far off the origin fits as well.
    let [u0, v0] = *points.first()?;
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for [u, v] in points {
        let row = Vector3::new(u - u0, v - v0, 1.0);
        matrix += row * row.transpose();
        right += row * (row.x * row.x + row.y * row.y);
    }
    let solution = matrix.lu().solve(&right)?;
    let centre = [u0 + 0.5 * solution.x, v0 + 0.5 * solution.y];
    centre.iter().all(|c| c.is_finite()).then_some(centre)
}
