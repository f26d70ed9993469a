//! Stresses at all integration points; they follow from displacements and plastic strains.

use crate::model::material::j2::PlasticPoint;
use crate::model::state::State;
use crate::solver::solve::checkpoint::kept::Kept;
use crate::solver::solve::checkpoint::plastic::{Plastic, points};
use crate::solver::solve::model::system::Model;
use crate::solver::solve::recovery::contact_fields::carrier_nodes;
use rayon::prelude::*;

/// Stresses and equivalent plastic strains at all integration points, of displacements `u` at a `moment`: a step and the
/// share of it that is done.
pub fn stresses(
    model: &Model,
    plastic: &Plastic,
    (u, moment): (&[[f64; 3]], (usize, f64)),
) -> (Vec<[[f64; 6]; 8]>, Vec<[f64; 8]>) {
    let mesh = &model.scene.mesh;
    let stress_of = |element: usize, points: &[PlasticPoint; 8]| {
        let local = mesh.hexes[element].map(|n| u[n as usize]);
        let elastic = &model.elastic[mesh.body_of(element)];
        let shape = model.element(element as u32);
        let free = model.free_strains(element as u32, *points, moment);
        shape.stress(elastic, &local, &free)
    };
    let elements = (0..mesh.hexes.len()).into_par_iter();
    if plastic.is_empty() {
        // Nothing has yielded: no plastic strain is put out.
        let virgin = [PlasticPoint::default(); 8];
        return (
            elements.map(|e| stress_of(e, &virgin)).collect(),
            Vec::new(),
        );
    }
    elements
        .map(|element| {
            let points = points(plastic, element as u32);
            (stress_of(element, &points), points.map(|p| p.peeq))
        })
        .unzip()
}

impl Kept {
    /// The whole state.
    pub fn restore(&self, model: &Model) -> State {
        let displacement = &self.state.displacement;
        let moment = (self.state.step, self.state.time);
        let (stress, peeq) = stresses(model, &self.plastic, (displacement, moment));
        let fields = model.scene.contacts.iter().zip(&self.contacts);
        let contacts = fields.map(|(pair, field)| field.unpack(carrier_nodes(model.scene, pair)));
        State {
            stress,
            peeq,
            contacts: contacts.collect(),
            ..self.state.clone()
        }
    }
}
