//! The inner unknowns of the element in balance: where the bubbles stand for given corner displacements u.
//!
//! The bubbles' amplitudes a are free inside the element. So they move until the stress does no work on them,
//!
//! ```text
//! f_a(a) = ∫ B_aᵀ σ(B_u u + B_a a, ε_p) dV = 0                                         (1)
//! ```
//!
//! which is (Simo and Rifai, IJNME 29 (1990) 1595) the element's own balance. There are two cases.
//!
//! *Frozen*: the plastic strain ε_p stays as it is. Then σ = C (ε − ε_p) is linear and (1) is nine linear equations,
//! K_aa a = −∫ B_aᵀ C (B_u u − ε_p) dV, with the elastic K_aa = ∫ B_aᵀ C B_a dV.
//!
//! *Flowing*: ε_p follows from the strain by radial return. The stress is then the derivative of a convex
//! incremental energy by the strain, and (1) says that this energy is least over a. Newton's method finds the minimum.
//! It begins at the frozen answer, so that nothing about the bubbles has to be kept from increment to increment.

use super::condense::{INNER, SHIFT};
use super::{BUBBLES, Enhanced, Field, field};
use crate::model::material::j2::{self, Flow, PlasticPoint};
use crate::model::material::{Moduli, Steel};
use crate::solver::fem::bbar::ElementVector;
use crate::solver::linear::small::SmallCholesky;

/// The bubbles balance where what is left of their force is below this share of the forces that cancel in it: some
/// fifty roundings.
const BALANCED: f64 = 1e-14;
/// Left of the force after the last iteration, as such a share: above this the bubbles have found no balance.
const MOST_UNBALANCED: f64 = 1e-9;
/// Newton iterations at most. A few are enough but where the whole element flows at next to no cost.
const ITERATIONS: usize = 60;
/// Searches along a Newton direction before the elastic one is taken.
const SEARCHES: usize = 4;
/// What a step may leave of the slope that it began with, beyond the minimum.
const OVERSHOOT: f64 = 0.5;

/// What the material answers to a field of displacements.
struct Response {
    points: [PlasticPoint; 8],
    flows: [Option<Flow>; 8],
    /// f_a = ∫ B_aᵀ σ dV, zero in balance.
    force: [f64; INNER],
    /// The largest component of the same sum with absolute values: the forces that cancel in f_a.
    scale: f64,
}

impl Enhanced {
    /// New history and flow of the integration points at corner displacements `u`, from the
    /// history `old`; `None` where the bubbles find no balance.
    pub fn answer(
        &self,
        steel: &Steel,
        elastic: &Moduli,
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
            // Near balance a step that gains nothing is at the limit of rounding.
            if size(&next.force) >= before && before <= 100.0 * BALANCED * response.scale {
                break;
            }
            (field, response) = (moved, next);
        }
        let balanced = size(&response.force) <= MOST_UNBALANCED * response.scale;
        balanced.then_some((response.points, response.flows))
    }

    /// Forces on the corners that the plastic strain of `points` takes off the elastic answer,
    /// the bubbles in balance: ∫ B_uᵀ C ε_p dV − K_ua K_aa⁻¹ ∫ B_aᵀ C ε_p dV.
    pub fn relief(&self, elastic: &Moduli, points: &[PlasticPoint; 8]) -> ElementVector {
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
        elastic: &Moduli,
        u: &ElementVector,
        points: &[PlasticPoint; 8],
    ) -> [[f64; 6]; 8] {
        let field = self.frozen(elastic, u, points);
        std::array::from_fn(|k| {
            let strain = self.strain(k, &field);
            elastic.stress(&std::array::from_fn(|i| strain[i] - points[k].strain[i]))
        })
    }

    /// Corners at `u`, bubbles in balance while the plastic strain stays at that of `points`: the frozen case.
    fn frozen(&self, elastic: &Moduli, u: &ElementVector, points: &[PlasticPoint; 8]) -> Field {
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

    /// Stresses, flow and forces at a field, from the histories `old`.
    fn respond(
        &self,
        steel: &Steel,
        elastic: &Moduli,
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

    /// Adds the share of integration point `k` of f_a.
    fn add_inner_force(&self, k: usize, stress: &[f64; 6], force: &mut [f64; INNER]) {
        for (m, node) in BUBBLES.enumerate() {
            let f = self.stress_force(k, node, stress);
            for i in 0..3 {
                force[3 * m + i] += self.volumes[k] * f[i];
            }
        }
    }

    /// A Newton step with a line search; where that fails, an elastic step.
    ///
    /// The elastic step −K_aa⁻¹ f_a always lowers the energy: flow only softens, so that the elastic stiffness bounds
    /// the tangent from above, and the quadratic model with K_aa lies above the energy.
    fn step(
        &self,
        steel: &Steel,
        elastic: &Moduli,
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
            // The slope of the energy along the step, from −`start` at its beginning. The energy is convex, so that the
            // slope only rises; the minimum is where it is zero. Far beyond it the step is shortened by the secant.
            let start = dot(&response.force, &direction);
            let mut share = 1.0;
            for _ in 0..SEARCHES {
                let next = along(&direction, share);
                let slope = dot(&next.1.force, &direction);
                if slope >= -OVERSHOOT * start {
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
