//! Consistent nodal values of the contact traction.
//!
//! A multiplier is the coefficient of its node's hat function in the traction z(x) = Σ z_B N_B(x).
//! Where a strip ends within an element these coefficients oscillate about the traction that they
//! stand for. The force on a node over the area that it stands for does not:
//! ```text
//! t_A = ∫ N_A z dA / ∫ N_A dA = Σ_B C_AB z_B,   C_AB = ∫ N_A N_B dA / w_A
//! ```
//! It is what dual (biorthogonal) multipliers carry, and C is the carrier's own part of the contact
//! rows. Sums of t_A w_A are sums of z_B w_B, so that no force is lost, and as C is not negative,
//! |shear| ≤ μ p holds of the consistent values where it holds of the coefficients. A node beside
//! those in contact has a share of their traction, though it is open itself. On a curved carrier the pressures are averaged and
//! not the vectors, which turn from node to node: an even pressure is read as it is, beside the shear that it allows.

use crate::ground::geometry::{Vec3, add, scale};
use crate::model::mesh::Hanging;
use crate::model::scene::Scene;
use crate::model::state::ContactField;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::rows::contact_row::ContactRow;

/// Normal and tangential traction of one contact node: coefficients of its hat function.
#[derive(Clone, Copy, Default)]
struct Coefficient {
    normal: f64,
    shear: Vec3,
}

/// Sets pressure and tangential traction (on the lower body) of all nodes that a row exists for.
pub fn consistent_tractions(model: &Model, evaluation: &Evaluation, fields: &mut [ContactField]) {
    let none = |field: &ContactField| vec![Coefficient::default(); field.nodes.len()];
    let mut coefficients: Vec<Vec<Coefficient>> = fields.iter().map(none).collect();
    for (row, answer) in model.rows.iter().zip(&evaluation.contact) {
        let [pressure, s, t] = answer.traction;
        let coefficient = Coefficient {
            normal: pressure,
            shear: row.global(&[0.0, s, t]),
        };
        for node in row.row.nodes() {
            if let Ok(at) = fields[row.pair].nodes.binary_search(&node) {
                coefficients[row.pair][at] = coefficient;
            }
        }
    }
    let hanging = &model.scene.mesh.hanging;
    let hanging: Vec<_> = (fields.iter())
        .map(|field| hanging_on(field, hanging))
        .collect();
    for (hanging, own) in hanging.iter().zip(&mut coefficients) {
        for (at, corners) in hanging {
            own[*at] = Coefficient {
                normal: mean_of(corners, |c| own[c].normal),
                shear: middle(corners, |c| own[c].shear),
            };
        }
    }
    for row in model.rows.iter().chain(&model.spare) {
        let field = &mut fields[row.pair];
        let Coefficient { normal, shear } = mean(row, field, &coefficients[row.pair]);
        let sign = model.scene.contacts[row.pair].carrier.sign();
        for node in row.row.nodes() {
            let Ok(at) = field.nodes.binary_search(&node) else {
                continue;
            };
            field.pressure[at] = normal;
            field.traction[at] = scale(shear, sign);
        }
    }
    for field in fields.iter_mut() {
        cancel_across_mirrors(model.scene, field);
    }
    // A node that hangs has no area of its own: it shows what is between its corners.
    for (field, hanging) in fields.iter_mut().zip(hanging) {
        for (at, corners) in hanging {
            let mean = |of: &[f64]| mean_of(&corners, |c| of[c]);
            field.pressure[at] = mean(&field.pressure);
            field.multiplier[at] = mean(&field.multiplier);
            field.gap[at] = mean(&field.gap);
            field.slip[at] = mean(&field.slip);
            field.traction[at] = middle(&corners, |c| field.traction[c]);
            let status = corners.iter().map(|c| field.status[*c]);
            field.status[at] = match status.clone().min() {
                Some(0) | None => 0,
                _ => status.max().unwrap_or_default(),
            };
        }
    }
}

/// In a plane of symmetry the shear across it and that of the other half cancel: half of a hat function sees its own only.
fn cancel_across_mirrors(scene: &Scene, field: &mut ContactField) {
    for (node, traction) in field.nodes.iter().zip(&mut field.traction) {
        for axis in scene.mirrors_through(&scene.mesh.points[*node as usize]) {
            traction[axis] = 0.0;
        }
    }
}

/// By place in a field: nodes that hang, and what they hang on, where that is in the field, too.
fn hanging_on(field: &ContactField, hanging: &[Hanging]) -> Vec<(usize, Vec<usize>)> {
    let place = |node: &u32| field.nodes.binary_search(node).ok();
    let of = |h: &Hanging| {
        let corners: Option<Vec<usize>> = h.corners.iter().map(place).collect();
        Some((place(&h.node)?, corners?))
    };
    hanging.iter().filter_map(of).collect()
}

/// The mean at some places.
fn mean_of(places: &[usize], of: impl Fn(usize) -> f64) -> f64 {
    places.iter().map(|at| of(*at)).sum::<f64>() / places.len().max(1) as f64
}

/// The mean at some places.
fn middle(places: &[usize], of: impl Fn(usize) -> Vec3) -> Vec3 {
    let sum = places.iter().fold([0.0; 3], |sum, at| add(sum, of(*at)));
    scale(sum, 1.0 / places.len().max(1) as f64)
}

/// Σ_B C_AB z_B over the nodes B of the carrier that the row of node A knows.
fn mean(row: &ContactRow, field: &ContactField, coefficients: &[Coefficient]) -> Coefficient {
    let mut mean = Coefficient::default();
    for (node, share) in &row.row.terms {
        // The other terms are of the opposite side.
        if let Ok(b) = field.nodes.binary_search(node) {
            mean.normal += coefficients[b].normal * share[0];
            mean.shear = add(mean.shear, scale(coefficients[b].shear, share[0]));
        }
    }
    mean
}
