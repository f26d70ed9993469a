//! Overlap of two convex polygons in a plane.

pub(super) type Point = [f64; 2];

/// Corners of a polygon, kept in place: two quadrilaterals overlap in eight corners at most.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Polygon {
    corners: [Point; MOST_CORNERS],
    count: usize,
}

/// Corners that a polygon has room for: twice those of two convex quadrilaterals' overlap, for facets that are not
/// quite convex.
const MOST_CORNERS: usize = 16;

impl Polygon {
    /// A copy of the first corners of a list.
    fn of(corners: &[Point]) -> Self {
        let mut polygon = Self::default();
        corners.iter().for_each(|p| polygon.push(*p));
        polygon
    }

    fn push(&mut self, p: Point) {
        if let Some(slot) = self.corners.get_mut(self.count) {
            *slot = p;
            self.count += 1;
        }
    }
}

impl std::ops::Deref for Polygon {
    type Target = [Point];

    fn deref(&self) -> &[Point] {
        &self.corners[..self.count]
    }
}

/// The part of `subject` inside `window`, both counter-clockwise and convex
/// (Sutherland and Hodgman, Comm. ACM 17 (1974) 32). Empty where they do not overlap.
///
/// What lies on an edge of the window to rounding lies on it: two edges in one line cross nowhere.
pub(super) fn intersect(subject: &[Point], window: &[Point]) -> Polygon {
    /// Distance from an edge over its length.
    const ROUNDING: f64 = 1e-10;
    let mut polygon = Polygon::of(subject);
    for (k, a) in window.iter().enumerate() {
        let b = window[(k + 1) % window.len()];
        let edge = [b[0] - a[0], b[1] - a[1]];
        let least = ROUNDING * (edge[0] * edge[0] + edge[1] * edge[1]);
        let side = |p: &Point| {
            let side = edge[0] * (p[1] - a[1]) - edge[1] * (p[0] - a[0]);
            if side.abs() > least { side } else { 0.0 }
        };
        let mut next = Polygon::default();
        for (i, p) in polygon.iter().enumerate() {
            let q = polygon[(i + 1) % polygon.len()];
            let (sp, sq) = (side(p), side(&q));
            if sp >= 0.0 {
                next.push(*p);
            }
            if (sp > 0.0 && sq < 0.0) || (sp < 0.0 && sq > 0.0) {
                let t = sp / (sp - sq);
                next.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
            }
        }
        polygon = next;
        if polygon.len() < 3 {
            return Polygon::default();
        }
    }
    polygon
}

/// Area of a polygon, positive if counter-clockwise.
pub(super) fn area(polygon: &[Point]) -> f64 {
    let pairs = polygon.iter().zip(polygon.iter().cycle().skip(1));
    0.5 * pairs.map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: [Point; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    #[test]
    fn a_shifted_square_overlaps_in_a_quarter() {
        let moved = UNIT.map(|p| [p[0] + 0.5, p[1] + 0.5]);
        assert!((area(&intersect(&UNIT, &moved)) - 0.25).abs() < 1e-15);
    }

    #[test]
    fn a_square_overlaps_itself_whole_and_its_neighbour_not_at_all() {
        assert_eq!(area(&intersect(&UNIT, &UNIT)), 1.0);
        let beside = UNIT.map(|p| [p[0] + 1.0, p[1]]);
        assert!(area(&intersect(&UNIT, &beside)).abs() < 1e-15);
    }

    #[test]
    fn edges_in_one_line_cross_nowhere_whatever_rounding_makes_of_them() {
        let wavy = [
            [0.0, 1e-16],
            [1.0, -1e-16],
            [1.0 + 1e-16, 1.0],
            [-1e-16, 1.0],
        ];
        let polygon = intersect(&wavy, &UNIT);
        assert_eq!(polygon.len(), 4);
        assert!((area(&polygon) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_diamond_inside_stays_whole() {
        let diamond = [[0.5, 0.1], [0.9, 0.5], [0.5, 0.9], [0.1, 0.5]];
        assert!((area(&intersect(&diamond, &UNIT)) - 0.32).abs() < 1e-15);
    }
}
