//! Bodies that float as rigid ones: where they come to rest.
//!
//! Bodies that only contact holds settle on a few nodes before they deform, and may rock or roll a long way until
//! they do. As rigid bodies on a foundation of springs they have six unknowns each, and their balance costs next to
//! nothing. It is found by steps against a resistance to motion that fades as the balance comes nearer
//! (pseudo-transient continuation, Kelley and Keyes 1998). What comes out is where contact presses, sticks and
//! slips: a first guess of these, no part of the answer.

use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use crate::model::state::turn::FAR;
use crate::solver::contact::law::Node;
use crate::solver::solve::params::{
    EASY_REST_ITERATIONS, REST_ITERATIONS, REST_RESIDUAL, REST_STEP_RESIDUAL, REST_STEPS,
};
use crate::solver::solve::rigid::foundation::{FoundationPoint, unbalance};
use crate::solver::solve::rigid::movable::Movable;
use crate::solver::solve::rigid::touch::Touch;
use crate::solver::solve::rows::contact_row::ContactRow;
use nalgebra::{DMatrix, DVector};

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
    let Movable {
        bodies,
        modes,
        load,
    } = Movable::new(scene, factors)?;
    let points = rows.iter().map(|row| FoundationPoint {
        touch: Touch::new(row, &bodies, &modes),
        gap: row.row.gap,
        stiffness: row.law.stiffness * row.row.area,
    });
    let points: Vec<FoundationPoint> = points.collect();
    let q = find_rest(&points, &load)?;
    let motions = &modes * &q;
    if bodies.largest_turn(motions.as_slice()) > FAR {
        return None;
    }
    let nodes = rows.iter().zip(&points).map(|(row, p)| p.node(row, &q));
    Some(Rest {
        nodes: nodes.collect(),
        displacement: bodies.displacement(motions.as_slice()),
    })
}

/// The motions at which contact balances the load, if they are found.
fn find_rest(points: &[FoundationPoint], load: &DVector<f64>) -> Option<DVector<f64>> {
    let mut q = DVector::zeros(load.len());
    // At first as stiff as all contact together.
    let mut resistance: f64 = points.iter().map(|p| p.stiffness).sum();
    for _ in 0..REST_STEPS {
        let here = unbalance(points, load, &q);
        if here.0.norm() <= REST_RESIDUAL * load.norm() {
            return Some(q);
        }
        match settle(points, load, (&q, here), resistance) {
            Some((next, easy)) => {
                q = next;
                resistance *= if easy { 0.1 } else { 0.5 };
            }
            None => resistance *= 8.0,
        }
    }
    None
}

/// The balance against a `resistance` to motion from `start`, where forces and their derivative are known, and whether
/// it was found easily.
fn settle(
    points: &[FoundationPoint],
    load: &DVector<f64>,
    (start, at_start): (&DVector<f64>, (DVector<f64>, DMatrix<f64>)),
    resistance: f64,
) -> Option<(DVector<f64>, bool)> {
    let mut q = start.clone();
    let mut known = Some(at_start);
    for iteration in 0..REST_ITERATIONS {
        let here = known.take();
        let (contact, mut tangent) = here.unwrap_or_else(|| unbalance(points, load, &q));
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
