//! Bodies that float as rigid ones: where they come to rest.
//!
//! Bodies that only contact holds settle on a few nodes before they deform, and may rock or roll a long way until
//! they do. As rigid bodies on contact nodes that give way as one layer of elements would (a foundation of
//! Winkler's springs, with Coulomb friction by radial return), they have six unknowns each, and their balance costs
//! next to nothing. It is found by steps against a resistance to motion that fades as the balance comes nearer
//! (pseudo-transient continuation, Kelley and Keyes 1998). What comes out is where contact presses, sticks and
//! slips: a first guess of these, no part of the answer.

use super::holding::{Resistance, RigidBodies, relative};
use super::rows::ContactRow;
use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use crate::model::state::turn::FAR;
use crate::solver::contact::law::Node;
use crate::solver::solve::params::{
    EASY_REST_ITERATIONS, MOVABLE_EIGENVALUE, REST_ITERATIONS, REST_RESIDUAL, REST_STEP_RESIDUAL,
    REST_STEPS,
};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// A contact point as the motions of rigid bodies see it: closure, and slip along both tangents.
pub struct Touch {
    pub friction: f64,
    pub normal: DVector<f64>,
    pub tangents: Option<[DVector<f64>; 2]>,
}

impl Touch {
    /// Of a contact row, for the motions in the columns of `free`.
    pub fn new(contact: &ContactRow, frames: &RigidBodies, free: &DMatrix<f64>) -> Self {
        let on = |direction: Vec3| {
            let mut sum = DVector::zeros(free.ncols());
            for (body, values) in relative(contact, direction, frames) {
                for (i, value) in values.into_iter().enumerate() {
                    sum += value * free.row(6 * body + i).transpose();
                }
            }
            sum
        };
        Self {
            friction: contact.law.friction,
            normal: on(contact.row.normal),
            tangents: contact.row.tangents.map(|t| t.map(on)),
        }
    }
}

/// Motions of all bodies that supports, rigid planes and shared nodes leave, a column each; `None` where there are
/// none.
pub fn movable_modes(scene: &Scene, frames: &RigidBodies) -> Option<DMatrix<f64>> {
    let mut seen = Resistance::new(scene.mesh.bodies.len());
    seen.supports(scene, frames);
    seen.planes(scene, frames);
    seen.shared_nodes(frames);
    let eigen = SymmetricEigen::new(seen.matrix);
    let free = (0..eigen.eigenvalues.len()).filter(|i| eigen.eigenvalues[*i] < MOVABLE_EIGENVALUE);
    let columns: Vec<_> = free
        .map(|i| eigen.eigenvectors.column(i).into_owned())
        .collect();
    (!columns.is_empty()).then(|| DMatrix::from_columns(&columns))
}

/// Where bodies have come to rest.
pub struct Rest {
    /// Displacement of each node of the mesh.
    pub displacement: Vec<Vec3>,
    /// Contact nodes, row by row: which press and stick, and with what.
    pub nodes: Vec<Node>,
}

/// Where rigid bodies that touch at `rows` come to rest under loads of these `factors`; `None` where nothing is free
/// or loaded, or no rest is found near where they stand.
pub fn at_rest(scene: &Scene, rows: &[&ContactRow], factors: &dyn Fn(&str) -> f64) -> Option<Rest> {
    let frames = RigidBodies::new(scene);
    let free = movable_modes(scene, &frames)?;
    let load = free.tr_mul(&DVector::from_vec(frames.load(scene, factors)));
    if load.norm() == 0.0 {
        return None;
    }
    let points = rows.iter().map(|row| FoundationPoint {
        touch: Touch::new(row, &frames, &free),
        gap: row.row.gap,
        stiffness: row.law.stiffness * row.row.area,
    });
    let points: Vec<FoundationPoint> = points.collect();
    let q = find_rest(&points, &load)?;
    let motions = &free * &q;
    if frames.largest_turn(motions.as_slice()) > FAR {
        return None;
    }
    let nodes = rows.iter().zip(&points).map(|(row, p)| p.node(row, &q));
    Some(Rest {
        nodes: nodes.collect(),
        displacement: frames.displacement(motions.as_slice()),
    })
}

/// The motions at which contact balances the load, if they are found.
fn find_rest(points: &[FoundationPoint], load: &DVector<f64>) -> Option<DVector<f64>> {
    let mut q = DVector::zeros(load.len());
    // At first as stiff as all contact together.
    let mut resistance: f64 = points.iter().map(|p| p.stiffness).sum();
    for _ in 0..REST_STEPS {
        if unbalance(points, load, &q).0.norm() <= REST_RESIDUAL * load.norm() {
            return Some(q);
        }
        match settle(points, load, &q, resistance) {
            Some((next, easy)) => {
                q = next;
                resistance *= if easy { 0.1 } else { 0.5 };
            }
            None => resistance *= 8.0,
        }
    }
    None
}

/// A node of a foundation.
struct FoundationPoint {
    touch: Touch,
    gap: f64,
    stiffness: f64,
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
    fn node(&self, row: &ContactRow, q: &DVector<f64>) -> Node {
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
fn unbalance(
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

/// The balance against a `resistance` to motion from `start`, and whether it was found easily.
fn settle(
    points: &[FoundationPoint],
    load: &DVector<f64>,
    start: &DVector<f64>,
    resistance: f64,
) -> Option<(DVector<f64>, bool)> {
    let mut q = start.clone();
    for iteration in 0..REST_ITERATIONS {
        let (contact, mut tangent) = unbalance(points, load, &q);
        let left = contact - resistance * (&q - start);
        if left.norm() <= REST_STEP_RESIDUAL * load.norm() {
            return Some((q, iteration <= EASY_REST_ITERATIONS));
        }
        for i in 0..q.len() {
            tangent[(i, i)] += resistance;
        }
        q += tangent.lu().solve(&left)?;
    }
    None
}
