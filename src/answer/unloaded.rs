//! What is left after unloading.

use super::named::Named;
use crate::answer::results::dent::dent;
use crate::answer::results::load;
use crate::model::scene::{Partner, Scene};
use crate::model::state::State;
use serde::Serialize;

/// The state after unloading.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Unloaded {
    /// The load that is left.
    pub applied_load: f64,
    /// The descent that is left.
    pub descent: Option<f64>,
    /// Largest equivalent plastic strain of each body.
    pub peeq_max: Named<f64>,
    /// Was what the load that is left presses elastically taken off the dents?
    pub elastic_removed: bool,
    /// The dent in each contact surface, by the surface's name.
    pub dents: Named<DentFigures>,
}

/// What stays in a contact surface.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DentFigures {
    /// The body that it is in.
    pub body: String,
    /// Inward residual displacement of the deepest point, the body's best-fit rigid motion removed,
    /// in the length unit of the scene.
    pub depth: f64,
    /// Undeformed position of that point.
    pub at: [f64; 3],
}

impl Unloaded {
    /// Of the unloaded `state`; `stays` is the displacement of every node that is left without any load.
    pub fn new(scene: &Scene, state: &State, stays: Option<&[[f64; 3]]>) -> Self {
        let mut names: Vec<&str> = Vec::new();
        for partner in scene.contacts.iter().flat_map(|c| [&c.upper, &c.lower]) {
            match partner {
                Partner::Surface(name) if !names.contains(&name.as_str()) => names.push(name),
                _ => {}
            }
        }
        let displacement = stays.unwrap_or(&state.displacement);
        let dents = names.into_iter().filter_map(|name| {
            let surface = scene.mesh.surface(name)?;
            let body = surface.body(&scene.mesh)?;
            let dent = dent(scene, displacement, body, surface)?;
            let summary = DentFigures {
                body: scene.mesh.bodies[body].name.clone(),
                depth: dent.depth,
                at: dent.at,
            };
            Some((surface.name.clone(), summary))
        });
        let strain = scene.mesh.bodies.iter().map(|body| {
            let points = body.elements.clone().flat_map(|e| state.peeq_of(e));
            let most = points.fold(0.0, f64::max);
            (body.name.clone(), most)
        });
        Self {
            applied_load: load::applied(scene, state),
            descent: load::descent(scene, state),
            peeq_max: Named(strain.collect()),
            elastic_removed: stays.is_some(),
            dents: Named(dents.collect()),
        }
    }
}
