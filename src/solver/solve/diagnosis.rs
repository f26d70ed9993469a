//! Why an increment could not be solved, in terms of the scene.

use super::error::{NoBalance, SolveError};
use super::model::Model;
use super::newton::{Failure, Stopped};
use super::statics::imbalance;
use crate::ground::geometry::{dot, norm, scale, sub, unit};
use crate::model::mesh::Body;
use crate::solver::fem::dofs::FIXED;
use crate::solver::linear::cholesky::FactorError;
use crate::solver::solve::params::TIPPING_TURN;

/// Where a solution stood when it was given up.
pub struct At {
    /// Step, and the share of it that was done.
    pub step: usize,
    pub time: f64,
    /// Iterations of the last increment.
    pub iterations: usize,
}

/// What to tell of an increment that was `stopped` and cannot be made smaller.
pub fn diagnose(model: &Model, stopped: &Stopped, at: &At) -> SolveError {
    let step = model.scene.steps[at.step].name.clone();
    let percent = 100.0 * at.time;
    let gives_way = gives_way(model, &stopped.flowing);
    match (stopped.why, gives_way) {
        (
            Failure::Runaway { .. } | Failure::Factor(FactorError::NotPositiveDefinite { .. }),
            Some((body, share)),
        ) => SolveError::LimitLoad {
            step,
            percent,
            body,
            share: 100.0 * share,
        },
        (Failure::Runaway { node, axis }, None) => free_body(model, node, axis),
        (Failure::Factor(error @ FactorError::NotPositiveDefinite { equation }), None) => {
            match place(model, equation) {
                Some((node, axis)) => free_body(model, node, axis),
                None => SolveError::Factor(error),
            }
        }
        (Failure::Factor(error), _) => SolveError::Factor(error),
        (
            Failure::Slow {
                residual,
                penetration,
                changed,
                equation,
                row,
            },
            _,
        ) => SolveError::NotConverged {
            step,
            percent,
            iterations: at.iterations,
            residual,
            penetration,
            place: place_in_words(model, equation),
            contact: contact_in_words(model, row, changed),
        },
        (Failure::Cancelled, _) => SolveError::NothingFree,
    }
}

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

/// Why an increment is made smaller.
pub fn describe(failure: &Failure) -> String {
    match failure {
        Failure::Slow {
            residual,
            penetration,
            ..
        } => format!(
            "slow convergence (residual {residual:.1e}, contact violation {penetration:.1e})"
        ),
        Failure::Runaway { .. } => "displacements left the model".to_owned(),
        Failure::Factor(error) => error.to_string(),
        Failure::Cancelled => "cancelled".to_owned(),
    }
}

fn free_body(model: &Model, node: u32, axis: usize) -> SolveError {
    let body = body_of(model, node);
    SolveError::FreeBody {
        body: body.name.clone(),
        axis: ['x', 'y', 'z'][axis],
        pieces: model.scene.mesh.pieces(body.elements.clone()),
    }
}

fn body_of<'m>(model: &'m Model, node: u32) -> &'m Body {
    let mesh = &model.scene.mesh;
    let element = mesh.hexes.iter().position(|h| h.contains(&node));
    &mesh.bodies[mesh.body_of(element.unwrap_or(0))]
}

/// The body of which the largest share of elements is among the `flowing` ones, and that share;
/// `None` where there are none.
fn gives_way(model: &Model, flowing: &[u32]) -> Option<(String, f64)> {
    let mesh = &model.scene.mesh;
    let mut elements = vec![0usize; mesh.bodies.len()];
    for element in flowing {
        elements[mesh.body_of(*element as usize)] += 1;
    }
    let shares = mesh.bodies.iter().zip(elements);
    let shares = shares.map(|(body, n)| (body, n as f64 / body.elements.len().max(1) as f64));
    let (body, share) = shares.max_by(|a, b| a.1.total_cmp(&b.1))?;
    (share > 0.0).then(|| (body.name.clone(), share))
}

/// Node and axis of an equation.
fn place(model: &Model, equation: usize) -> Option<(u32, usize)> {
    let nodes = (0..).zip(&model.dofs.equations);
    let on = |e: &u32| *e != FIXED && *e as usize == equation;
    let mut found = nodes.filter_map(|(node, axes)| Some((node, axes.iter().position(on)?)));
    found.next()
}

fn place_in_words(model: &Model, equation: usize) -> String {
    let Some((node, _)) = place(model, equation) else {
        return "the motion of a rigid plane".to_owned();
    };
    let at = model.scene.mesh.points[node as usize];
    format!("`{}` at {}", body_of(model, node).name, point(at))
}

/// The contact that is furthest from settled.
fn contact_in_words(model: &Model, row: Option<usize>, changed: usize) -> String {
    let Some(row) = row.and_then(|row| model.rows.get(row)) else {
        return "there is no contact".to_owned();
    };
    let at = model.scene.mesh.points[row.row.node as usize];
    let pair = &model.scene.contacts[row.pair].name;
    let at = point(at);
    format!("`{pair}` at {at}, {changed} contact nodes still changing")
}

fn point(at: [f64; 3]) -> String {
    let size = at.iter().fold(0.0f64, |size, c| size.max(c.abs()));
    let plain = size == 0.0 || (1e-2..1e5).contains(&size);
    let [x, y, z] = at.map(|c| match plain {
        true => format!("{c:.4}"),
        false => format!("{c:.3e}"),
    });
    format!("({x}, {y}, {z})")
}
