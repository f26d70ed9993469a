//! An accepted solution in the terms of the scene.

use crate::ground::geometry::Vec3;
use crate::model::state::State;
use crate::solver::contact::facing::Sight;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::recovery::contact_fields::contact_fields;
use crate::solver::solve::recovery::left_over::left_over;
use crate::solver::solve::recovery::plane_fields::plane_fields;
use crate::solver::solve::recovery::stresses::stresses;
use crate::solver::solve::recovery::tie_fields::tie_fields;

/// The accepted state at `point`, in the terms of the scene; `displacement` is that of all its nodes.
pub fn recovered_state(
    model: &Model,
    history: &History,
    (point, displacement): (&Point, Vec<Vec3>),
    (evaluation, sights): (&Evaluation, &[Vec<Sight>]),
) -> State {
    let plastic = history.all_plastic(model);
    let (stress, peeq) = stresses(model, &plastic, (&displacement, (point.step, point.time)));
    let mut left = left_over(model, (point, evaluation), &plastic, &displacement);
    // Planes bear what ties hand on to their nodes.
    let ties = tie_fields(model, &mut left);
    State {
        step: point.step,
        time: point.time,
        ties,
        contacts: contact_fields(model, history, (evaluation, sights), &displacement),
        planes: plane_fields(model, &left, point, &displacement),
        displacement,
        stress,
        peeq,
        energy: None,
    }
}
