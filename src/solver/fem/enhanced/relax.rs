//! The bubbles' own balance: for given displacements of the corners they move until the stress
//! does no work on them, ∫ B_aᵀ σ dV = 0.
//!
//! With a frozen plastic strain that is a linear system. With flow it is the minimum of a convex
//! energy, found by Newton's method from the frozen answer; nothing else is remembered.

use super::condense::{INNER, SHIFT};
use super::{BUBBLES, Enhanced, Field, field};
use crate::model::material::j2::{self, Flow, PlasticPoint};
use crate::model::material::{Elastic, Steel};
use crate::solver::fem::bbar::ElementVector;
use crate::solver::linear::small::SmallCholesky;

/// Out-of-balance force of the bubbles over the forces that cancel in it.
const BALANCED: f64 = 1e-14;
/// Above this the bubbles failed to find their balance.
const LOST: f64 = 1e-9;
const ITERATIONS: usize = 60;

/// The answer of the material to a field.
struct Response {
    points: [PlasticPoint; 8],
    flows: [Option<Flow>; 8],
    /// ∫ B_aᵀ σ dV.
    force: [f64; INNER],
    /// Sum of the absolute values in the largest component of `force`.
    scale: f64,
}

impl Enhanced {
    /// New history and flow of the integration points at corner displacements `u`, from the
    /// history `old`; `None` where the bubbles find no balance.
    pub fn answer(
        &self,
        steel: &Steel,
        elastic: &Elastic,
        u: &ElementVector,
        old: &[PlasticPoint; 8],
    ) -> Option<([PlasticPoint; 8], [Option<Flow>; 8])> {
        let mut field = self.frozen(elastic, u, old);
        let mut response = self.respond(steel, elastic, &field, old);
        if response.flows.iter().all(Option::is_none) {
            return Some((response.points, response.flows));
        }
        for _ in 0..ITERATIONS {
            let before = size(&response.force);
            if before <= BALANCED * response.scale {
                break;
            }
            let (moved, next) = self.step(steel, elastic, &field, &response, old)?;
            // At the limit of round-off there is nothing left to gain.
            if size(&next.force) >= before && before <= 100.0 * BALANCED * response.scale {
                break;
            }
            (field, response) = (moved, next);
        }
        let balanced = size(&response.force) <= LOST * response.scale;
        balanced.then_some((response.points, response.flows))
    }

    /// Forces on the corners that the plastic strain of `points` takes off the elastic answer,
    /// the bubbles in balance: ∫ B_uᵀ C ε_p dV − K_ua K_aa⁻¹ ∫ B_aᵀ C ε_p dV.
    pub fn relief(&self, elastic: &Elastic, points: &[PlasticPoint; 8]) -> ElementVector {
        let moved = self.frozen(elastic, &[[0.0; 3]; 8], points);
        let mut force = [[0.0; 3]; super::NODES];
        for (k, point) in points.iter().enumerate() {
            let strain = self.strain(k, &moved);
            let relieved = std::array::from_fn(|i| point.strain[i] - strain[i]);
            self.add_stress_force(k, &elastic.stress(&relieved), &mut force);
        }
        std::array::from_fn(|a| force[a])
    }

    /// Stress at the integration points at corner displacements `u` and the history `points`.
    pub fn stress(
        &self,
        elastic: &Elastic,
        u: &ElementVector,
        points: &[PlasticPoint; 8],
    ) -> [[f64; 6]; 8] {
        let field = self.frozen(elastic, u, points);
        std::array::from_fn(|k| {
            let strain = self.strain(k, &field);
            elastic.stress(&std::array::from_fn(|i| strain[i] - points[k].strain[i]))
        })
    }

    /// Corners and bubbles in balance while the plastic strain stays at that of `points`.
    fn frozen(&self, elastic: &Elastic, u: &ElementVector, points: &[PlasticPoint; 8]) -> Field {
        let mut field = field(u);
        let Some(inner) = SmallCholesky::new(self.inner_stiffness(elastic)) else {
            return field;
        };
        let mut force = [0.0; INNER];
        for (k, point) in points.iter().enumerate() {
            let strain = self.strain(k, &field);
            let stress = elastic.stress(&std::array::from_fn(|i| strain[i] - point.strain[i]));
            self.add_inner_force(k, &stress, &mut force);
        }
        inner.solve(&mut force);
        advance(&mut field, &force, -1.0);
        field
    }

    fn respond(
        &self,
        steel: &Steel,
        elastic: &Elastic,
        field: &Field,
        old: &[PlasticPoint; 8],
    ) -> Response {
        let mut response = Response {
            points: *old,
            flows: [None; 8],
            force: [0.0; INNER],
            scale: 0.0,
        };
        let mut absolute = [0.0; INNER];
        for k in 0..8 {
            let update = j2::update(steel, elastic, &self.strain(k, field), &old[k]);
            (response.points[k], response.flows[k]) = (update.point, update.flow);
            let mut force = [0.0; INNER];
            self.add_inner_force(k, &update.stress, &mut force);
            for ((sum, absolute), f) in response.force.iter_mut().zip(&mut absolute).zip(force) {
                *sum += f;
                *absolute += f.abs();
            }
        }
        response.scale = size(&absolute);
        response
    }

    fn add_inner_force(&self, k: usize, stress: &[f64; 6], force: &mut [f64; INNER]) {
        for (m, node) in BUBBLES.enumerate() {
            let f = self.stress_force(k, node, stress);
            for i in 0..3 {
                force[3 * m + i] += self.volumes[k] * f[i];
            }
        }
    }

    /// A Newton step, or where it does not descend an elastic one, which always does: the elastic
    /// stiffness bounds the tangent from above.
    fn step(
        &self,
        steel: &Steel,
        elastic: &Elastic,
        from: &Field,
        response: &Response,
        old: &[PlasticPoint; 8],
    ) -> Option<(Field, Response)> {
        let stiff = self.inner_stiffness(elastic);
        let mut tangent = self.inner_tangent(elastic, &response.flows);
        for (row, stiff) in tangent.iter_mut().zip(&stiff) {
            for (value, stiff) in row.iter_mut().zip(stiff) {
                *value += SHIFT * stiff;
            }
        }
        let along = |direction: &[f64; INNER], share: f64| {
            let mut field = *from;
            advance(&mut field, direction, -share);
            let response = self.respond(steel, elastic, &field, old);
            (field, response)
        };
        if let Some(tangent) = SmallCholesky::new(tangent) {
            let mut direction = response.force;
            tangent.solve(&mut direction);
            // The slope of the energy along the way; convex, so it only rises.
            let start = dot(&response.force, &direction);
            let mut share = 1.0;
            for _ in 0..4 {
                let next = along(&direction, share);
                let slope = dot(&next.1.force, &direction);
                if slope >= -0.5 * start {
                    return Some(next);
                }
                share *= (start / (start - slope)).clamp(0.1, 0.5);
            }
        }
        let mut direction = response.force;
        SmallCholesky::new(stiff)?.solve(&mut direction);
        Some(along(&direction, 1.0))
    }
}

/// Moves the bubbles by `factor` times `direction`.
fn advance(field: &mut Field, direction: &[f64; INNER], factor: f64) {
    let bubbles = field[BUBBLES].as_flattened_mut();
    for (value, d) in bubbles.iter_mut().zip(direction) {
        *value += factor * d;
    }
}

fn dot(a: &[f64; INNER], b: &[f64; INNER]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Largest component.
fn size(force: &[f64; INNER]) -> f64 {
    force.iter().fold(0.0, |m, f| m.max(f.abs()))
}
