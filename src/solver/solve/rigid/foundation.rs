//! Contact nodes that give way as one layer of elements would.
//!
//! They are the springs of a foundation after Winkler (*Die Lehre von der Elasticität und Festigkeit*, 1867), with Coulomb
//! friction by radial return.

use crate::solver::contact::law::Node;
use crate::solver::solve::rigid::touch::Touch;
use crate::solver::solve::rows::contact_row::ContactRow;
use nalgebra::{DMatrix, DVector};

/// A node of a foundation.
pub struct FoundationPoint {
    pub touch: Touch,
    pub gap: f64,
    pub stiffness: f64,
}

impl FoundationPoint {
    /// Force in local components, and the shear that there would be if it stuck.
    fn force(&self, q: &DVector<f64>) -> ([f64; 3], f64) {
        let pressed = self.stiffness * (self.touch.normal.dot(q) - self.gap);
        if pressed <= 0.0 {
            return ([0.0; 3], 0.0);
        }
        let Some([s, t]) = &self.touch.tangents else {
            return ([pressed, 0.0, 0.0], 0.0);
        };
        let shear = [s, t].map(|t| self.stiffness * t.dot(q));
        let size = shear[0].hypot(shear[1]);
        let bound = self.touch.friction * pressed;
        let share = if size > bound { bound / size } else { 1.0 };
        ([pressed, share * shear[0], share * shear[1]], size)
    }

    /// The contact node for these motions: its multipliers are what the tractions are beside what the law adds.
    pub fn node(&self, row: &ContactRow, q: &DVector<f64>) -> Node {
        let (force, shear) = self.force(q);
        let closed = force[0] > 0.0;
        let bound = self.touch.friction * force[0];
        let mut node = Node {
            closed,
            sticks: closed && shear <= bound,
            bound: bound / row.row.area,
            ..Node::default()
        };
        if closed {
            let mut d = [self.touch.normal.dot(q) - self.gap, 0.0, 0.0];
            if let Some([s, t]) = &self.touch.tangents {
                (d[1], d[2]) = (s.dot(q), t.dot(q));
            }
            let beside = row.law.traction(&node, &d).traction;
            node.multiplier = std::array::from_fn(|i| force[i] / row.row.area - beside[i]);
        }
        node
    }
}

/// Loads less contact forces at `q`, and the derivative of contact forces.
pub fn unbalance(
    points: &[FoundationPoint],
    load: &DVector<f64>,
    q: &DVector<f64>,
) -> (DVector<f64>, DMatrix<f64>) {
    let mut left = load.clone();
    let mut tangent = DMatrix::zeros(q.len(), q.len());
    for point in points {
        let ([pressure, s, t], shear) = point.force(q);
        if pressure <= 0.0 {
            continue;
        }
        let (k, n) = (point.stiffness, &point.touch.normal);
        left.axpy(-pressure, n, 1.0);
        tangent.ger(k, n, n, 1.0);
        let Some(tangents) = &point.touch.tangents else {
            continue;
        };
        for (force, along) in [s, t].iter().zip(tangents) {
            left.axpy(-force, along, 1.0);
        }
        let bound = point.touch.friction * pressure;
        if shear <= bound {
            for along in tangents {
                tangent.ger(k, along, along, 1.0);
            }
            continue;
        }
        // Radial return: across the slip it turns, along it it follows the pressure.
        let e = [s / bound, t / bound];
        let along = &tangents[0] * e[0] + &tangents[1] * e[1];
        let across = &tangents[1] * e[0] - &tangents[0] * e[1];
        tangent.ger(k * bound / shear, &across, &across, 1.0);
        tangent.ger(k * point.touch.friction, &along, n, 1.0);
    }
    (left, tangent)
}
