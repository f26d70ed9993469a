//! What every answer has to fulfil: balance, Coulomb's law, energy, no overlap.

use super::draw::Stack;
use crate::ground::geometry::{add, norm, sub};
use crate::model::state::State;
use crate::product::converge::energy::strain_energy;

/// Largest relative error of forces, of Coulomb's law and of energies: a hundred times the residual of 1e-8 at which
/// iterations end.
const BALANCE_ERROR: f64 = 1e-6;

/// Largest overlap that the meshes do not explain, over the largest displacement: more is a mesh that is too coarse.
const UNEXPLAINED_OVERLAP: f64 = 1e-3;

/// What does not hold of the answer.
pub fn check(stack: &Stack, state: &State) -> Option<String> {
    let size = norm(stack.force);
    for (pair, field) in stack.scene.contacts.iter().zip(&state.contacts) {
        let force = field.force.iter().fold([0.0; 3], |sum, f| add(sum, *f));
        let off = norm(sub(force, stack.force)) / size;
        if !(off <= BALANCE_ERROR) {
            return Some(format!("{}: the force is off by {off:.1e}", pair.name));
        }
        let most = largest(field.pressure.iter().copied());
        let slips = field.traction.iter().zip(&field.pressure);
        let beyond = slips.map(|(t, p)| norm(*t) - pair.friction * p.max(0.0));
        let beyond = largest(beyond) / most;
        if !(beyond <= BALANCE_ERROR) {
            return Some(format!(
                "{}: beyond Coulomb's law by {beyond:.1e}",
                pair.name
            ));
        }
    }
    let Some(energy) = state.energy else {
        return Some("its energy is not known".into());
    };
    let spent = energy.elastic + energy.plastic + energy.friction + energy.contact;
    let lost = (energy.work - spent).abs() / energy.turned_over;
    let stored = (strain_energy(&stack.scene, state) - energy.elastic).abs() / energy.turned_over;
    let worst = lost.max(stored);
    (!(worst <= BALANCE_ERROR)).then(|| format!("energy is off by {worst:.1e}"))
}

/// Overlap that the meshes do not explain, where it is too much.
pub fn overlap(stack: &Stack, state: &State) -> Option<String> {
    let pairs = stack.scene.contacts.iter().zip(&state.contacts);
    let moved = largest(state.displacement.iter().map(|u| norm(*u)));
    let overlaps = pairs.map(|(pair, field)| (field.unexplained / moved, &pair.name));
    let (worst, name) = overlaps.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (!(worst <= UNEXPLAINED_OVERLAP)).then(|| format!("{name}: an overlap of {worst:.1e}"))
}

/// The largest of values that are not negative.
pub fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}
