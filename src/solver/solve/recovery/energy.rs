//! Where the work of the loads goes: elastic energy, plastic flow, friction.
//!
//! Each increment adds the trapezoidal sum over its two ends. Then
//!
//! W = U + D_p + D_f + W_c
//!
//! with the work W of the loads and of temperatures, −½ (σ₀ + σ₁) : Δε_th: what is heated where it cannot stretch takes
//! in elastic energy without a force that does work. What slides does so under the force of friction that it ends with,
//! though the increment may begin with another one, as where sliding turns: what the trapezoidal sum lacks of that goes to
//! both W and D_f. The sum holds to the residual of the increments, whatever their size, by
//! virtual work: ½ (σ₀ + σ₁) : Δε is the change of ½ σ : C⁻¹ : σ, and ½ (σ₀ + σ₁) : Δε_p and : Δε_th. W_c is what the
//! pressure does on closing gaps within an increment; like every error of the sum it vanishes with their size.

use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub};
use crate::model::material::{Moduli, mises};
use crate::model::mesh::hexahedron::gauss_volumes;
use crate::model::scene::{PlaneMotion, PlaneTurn, Support};
use crate::model::state::{Energy, State};
use crate::solver::fem::loads;
use crate::solver::solve::model::system::Model;
use rayon::prelude::*;

impl Energy {
    /// With the increment from `before`, which is empty at the start, to `after`. `None` where a
    /// support moves: what it takes is not known here.
    pub(in crate::solver::solve) fn after(
        self,
        model: &Model,
        before: &State,
        after: &State,
    ) -> Option<Self> {
        if model.scene.supports.iter().any(Support::moves) {
            return None;
        }
        let work = of_planes(model, before, after) + of_tractions(model, before, after);
        let (thermal, scale) = of_temperatures(model, before, after);
        let work = work + thermal;
        let (elastic, plastic) = in_bodies(model, before, after);
        let AtContacts {
            friction,
            contact,
            turned,
        } = at_contacts(model, before, after);
        let (work, friction) = (work + turned, friction + turned);
        Some(Self {
            work: self.work + work,
            turned_over: self.turned_over + work.abs() + scale,
            elastic,
            plastic: self.plastic + plastic,
            friction: self.friction + friction,
            contact: self.contact + contact,
        })
    }
}

fn of_planes(model: &Model, before: &State, after: &State) -> f64 {
    let planes = &model.scene.rigid_planes;
    let work = planes.iter().zip(&after.planes).enumerate();
    work.map(|(i, (plane, now))| {
        let was = before.planes.get(i).copied().unwrap_or_default();
        let axes = (0..3).filter(|axis| plane.motion[*axis] != PlaneMotion::Free);
        let moved = axes
            .map(|a| 0.5 * (was.force[a] + now.force[a]) * (now.travel[a] - was.travel[a]))
            .sum::<f64>();
        let axes = (0..3).filter(|axis| plane.turn[*axis] != PlaneTurn::Held(0.0));
        let turned =
            axes.map(|a| 0.5 * (was.moment[a] + now.moment[a]) * (now.turn[a] - was.turn[a]));
        turned.fold(moved, |sum, work| sum + work)
    })
    .sum()
}

fn of_tractions(model: &Model, before: &State, after: &State) -> f64 {
    let scene = model.scene;
    let start = if before.displacement.is_empty() {
        0.0
    } else {
        before.time
    };
    let work = scene.tractions.iter().filter_map(|traction| {
        let surface = scene.mesh.surface(&traction.surface)?;
        let factor = |state: &State, time| model.scene.factor(&traction.name, state.step, time);
        let mean = 0.5 * (factor(before, start) + factor(after, after.time));
        let mut force = vec![[0.0; 3]; scene.mesh.points.len()];
        loads::add_traction(&scene.mesh, surface, traction.value, mean, &mut force);
        let nodes = surface.nodes().into_iter().map(|n| n as usize);
        Some(
            nodes
                .map(|n| dot(force[n], moved(before, after, n)))
                .sum::<f64>(),
        )
    });
    work.sum()
}

/// What temperatures do, and as a scale for it what they would do if nothing could stretch.
fn of_temperatures(model: &Model, before: &State, after: &State) -> (f64, f64) {
    if model.heated.is_empty() {
        return (0.0, 0.0);
    }
    let elements: Vec<(f64, f64)> = (0..after.stress.len())
        .into_par_iter()
        .map(|element| {
            let strain = |state: &State| {
                let moment = (state.step, state.time);
                model
                    .thermal_strain(element as u32, moment)
                    .unwrap_or_default()
            };
            let [was, now] = [before, after].map(strain);
            let bulk = model.elastic[model.scene.mesh.body_of(element)].bulk;
            let volumes = gauss_volumes(&model.scene.mesh.corners(element));
            let (mut work, mut scale) = (0.0, 0.0);
            for (k, volume) in volumes.iter().enumerate() {
                let trace = |state: &State| {
                    let stress = state.stress.get(element).map_or([0.0; 6], |s| s[k]);
                    stress[0] + stress[1] + stress[2]
                };
                let mean = 0.5 * (trace(before) + trace(after));
                work -= volume * mean * (now[k] - was[k]);
                scale += volume * 4.5 * bulk * (now[k].powi(2) - was[k].powi(2)).abs();
            }
            (work, scale)
        })
        .collect();
    in_order(&elements)
}

/// Displacement of a node in the increment.
fn moved(before: &State, after: &State, node: usize) -> [f64; 3] {
    let was = before.displacement.get(node).copied().unwrap_or_default();
    let now = after.displacement[node];
    [0, 1, 2].map(|i| now[i] - was[i])
}

/// The elastic energy at the end, and what the increment has put into plastic flow.
fn in_bodies(model: &Model, before: &State, after: &State) -> (f64, f64) {
    let elements: Vec<(f64, f64)> = (0..after.stress.len())
        .into_par_iter()
        .map(|element| {
            let elastic = &model.elastic[model.scene.mesh.body_of(element)];
            let volumes = gauss_volumes(&model.scene.mesh.corners(element));
            let (mut stored, mut spent) = (0.0, 0.0);
            for (point, volume) in volumes.iter().enumerate() {
                let stress = &after.stress[element][point];
                stored += volume * density(elastic, stress);
                let flow = after.peeq_of(element)[point] - before.peeq_of(element)[point];
                if flow > 0.0 {
                    let was = before.stress.get(element).map_or([0.0; 6], |s| s[point]);
                    spent += volume * flow * flow_stress(&was, stress);
                }
            }
            (stored, spent)
        })
        .collect();
    in_order(&elements)
}

/// The sum in the order of the elements, whatever the number of threads.
fn in_order(elements: &[(f64, f64)]) -> (f64, f64) {
    let add = |sum: (f64, f64), e: &(f64, f64)| (sum.0 + e.0, sum.1 + e.1);
    elements.iter().fold((0.0, 0.0), add)
}

/// Elastic energy by volume, q²/6G + p²/2K.
fn density(elastic: &Moduli, stress: &[f64; 6]) -> f64 {
    let pressure = (stress[0] + stress[1] + stress[2]) / 3.0;
    mises(stress).powi(2) / (6.0 * elastic.shear) + pressure * pressure / (2.0 * elastic.bulk)
}

/// ½ (σ₀ + σ₁) : N with the direction of backward Euler's flow, N = 3 s₁ / 2 q₁.
fn flow_stress(was: &[f64; 6], now: &[f64; 6]) -> f64 {
    let q = mises(now);
    let pressure = (now[0] + now[1] + now[2]) / 3.0;
    let along: f64 = (0..6)
        .map(|i| {
            if i < 3 {
                was[i] * (now[i] - pressure)
            } else {
                2.0 * was[i] * now[i]
            }
        })
        .sum();
    if q > 0.0 {
        0.5 * (q + 1.5 * along / q)
    } else {
        0.0
    }
}

/// Work at contacts in an increment.
#[derive(Default)]
struct AtContacts {
    /// Spent in friction, and of pressures on closing gaps: trapezoidal sums.
    friction: f64,
    contact: f64,
    /// What the first lacks where friction reaches its limit within the increment.
    turned: f64,
}

fn at_contacts(model: &Model, before: &State, after: &State) -> AtContacts {
    let mut sum = AtContacts::default();
    for row in &model.rows {
        let pair = &model.scene.contacts[row.pair];
        let force_in = |state: &State| {
            let field = state.contacts.get(row.pair)?;
            let at = field.nodes.binary_search(&row.row.node).ok()?;
            Some(scale(field.force[at], pair.carrier.sign()))
        };
        let [was, now] = [before, after].map(|state| force_in(state).unwrap_or_default());
        let mut closed = [0.0; 3];
        for (node, coefficient) in &row.row.terms {
            let moved = moved(before, after, *node as usize);
            (0..3).for_each(|i| closed[i] += coefficient[i] * moved[i]);
        }
        let normal = row.row.normal;
        let along = |v: Vec3| sub(v, scale(normal, dot(v, normal)));
        let force = scale(add(was, now), 0.5);
        let rubbed = dot(along(force), along(closed));
        sum.contact += dot(force, normal) * dot(closed, normal);
        sum.friction += rubbed;
        let limits = [was, now].map(|force| pair.friction * dot(force, normal).abs());
        let under_limit = rubbed_at(limits, along(now), along(closed));
        sum.turned += under_limit.map_or(0.0, |all| (all - rubbed).max(0.0));
    }
    sum
}

/// What is spent on the way `slid`, the limits of friction being as they are before and after: what slides in the end under
/// `friction` has done so under the limit. `None` of what sticks in the end.
fn rubbed_at([was, now]: [f64; 2], friction: Vec3, slid: Vec3) -> Option<f64> {
    const SLIDES: f64 = 1.0 - 1e-6;
    let size = norm(friction);
    (size > 0.0 && size >= SLIDES * now).then(|| 0.5 * (was / size + 1.0) * dot(friction, slid))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_turns_within_an_increment_rubs_under_the_limit_all_the_way() {
        let friction = [3.0, 0.0, 0.0];
        assert_eq!(
            rubbed_at([3.0, 3.0], friction, [0.2, 0.0, 0.0]),
            Some(3.0 * 0.2)
        );
        assert_eq!(
            rubbed_at([0.0, 3.0], friction, [0.2, 0.0, 0.0]),
            Some(1.5 * 0.2)
        );
        assert_eq!(rubbed_at([3.0, 4.0], friction, [0.2, 0.0, 0.0]), None);
        assert_eq!(rubbed_at([0.0, 0.0], [0.0; 3], [0.0; 3]), None);
    }
}
