//! Rigid planes: how they move and turn, and what acts on them.

use super::named::Named;
use crate::answer::results::balance::whole_moment;
use crate::answer::results::load::whole;
use crate::model::scene::Scene;
use crate::model::state::State;
use serde::Serialize;

/// A rigid plane, of the whole.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PlaneFigures {
    /// The point that its motion is of and its moment is about.
    pub about: [f64; 3],
    /// Displacement of that point; where every node is free the mean of all.
    pub travel: [f64; 3],
    /// Angles that it has turned by, in radians.
    pub turn: [f64; 3],
    /// Force on it: applied, or the reaction where it is held.
    pub force: [f64; 3],
    /// Moment on it, likewise.
    pub moment: [f64; 3],
}

/// Every rigid plane of the scene.
pub fn planes(scene: &Scene, state: &State) -> Named<PlaneFigures> {
    let planes = scene.rigid_planes.iter().zip(&state.planes);
    let figures = planes.map(|(plane, field)| {
        let figures = PlaneFigures {
            about: plane.point(&scene.mesh, &scene.mirrors),
            travel: field.travel,
            turn: field.turn,
            force: whole(scene, field.force),
            moment: whole_moment(&scene.mirrors, field.moment),
        };
        (plane.name.clone(), figures)
    });
    Named(figures.collect())
}
