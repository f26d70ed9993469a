//! Whether the statics of rigid bodies explain a failure.

use crate::ground::geometry::{dot, norm, scale, sub, unit};
use crate::solver::solve::error::SolveError;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::no_balance::NoBalance;
use crate::solver::solve::params::TIPPING_TURN;
use crate::solver::solve::statics::imbalance::imbalance;

/// Why there is no balance at `time` within step `step`, if the statics of rigid bodies say so.
pub fn no_balance(model: &Model, (step, time): (usize, f64), done: f64) -> Option<SolveError> {
    let scene = model.scene;
    let rows = model.rows.iter().chain(&model.spare);
    let found = imbalance(scene, rows, &|name| model.scene.factor(name, step, time))?;
    let motion = found.motion;
    let turns = norm(motion.turn) > TIPPING_TURN * norm(motion.translation);
    let tips = turns && found.friction.is_none();
    // Along the contact: where a cone of friction is left, a part of the way leads up from it.
    let sideways = found.bears.map_or(motion.translation, |bears| {
        let lift = dot(motion.translation, bears.normal);
        sub(motion.translation, scale(bears.normal, lift))
    });
    let along = match (tips, found.friction) {
        (true, _) => motion.turn,
        (false, Some(_)) => sideways,
        (false, None) => motion.translation,
    };
    Some(SolveError::NoBalance(Box::new(NoBalance {
        step: scene.steps[step].name.clone(),
        percent: 100.0 * done,
        body: motion.body,
        tips,
        along: unit(along).unwrap_or_default(),
        bears: (found.bears).map(|b| (scene.contacts[b.pair].name.clone(), b.at)),
        friction: found.friction,
    })))
}
