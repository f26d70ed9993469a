//! By how much contact conditions are violated.

use crate::solver::contact::law::Status;
use crate::solver::fem::dofs::FIXED;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::{Evaluation, flowing_points};
use crate::solver::solve::model::system::Model;
use crate::solver::solve::observer::Iteration;

/// Largest violation of a contact condition, as a length over the largest displacement: closure
/// of a closed node, slip of a sticking one.
///
/// Where elastic parts are condensed only nodes in contact may be left, and these rest where all of them stick to a
/// rigid plane. The bodies give way all the same: what the largest pressure does to its node is a displacement, too.
pub fn violation(model: &Model, point: &Point, evaluation: &Evaluation) -> f64 {
    let worst = violations(model, point, evaluation).fold(0.0, f64::max);
    let moved = |axes: &[u32; 3]| {
        let free = axes.iter().filter(|e| **e != FIXED);
        free.map(|e| point.x[*e as usize].powi(2)).sum::<f64>()
    };
    let travel = (model.dofs.equations.iter().map(moved))
        .fold(0.0, f64::max)
        .sqrt();
    let pressed = model.rows.iter().zip(&evaluation.contact);
    let gives_way = pressed.map(|(row, answer)| answer.traction[0] / row.law.stiffness);
    let travel = gives_way.fold(travel, f64::max);
    if worst == 0.0 {
        0.0
    } else {
        worst / travel.max(f64::MIN_POSITIVE)
    }
}

/// Violation of the conditions at each contact node, as a length.
pub fn violations<'e>(
    model: &'e Model,
    point: &'e Point,
    evaluation: &'e Evaluation,
) -> impl Iterator<Item = f64> + 'e {
    let rows = model.rows.iter().zip(&evaluation.contact).zip(&point.nodes);
    rows.map(|((row, answer), node)| row.law.violation(node, answer))
}

pub fn count_statuses(last: &mut Iteration, evaluation: &Evaluation) {
    let with = |status| {
        evaluation
            .contact
            .iter()
            .filter(|a| a.status == status)
            .count()
    };
    (last.sticking, last.slipping) = (with(Status::Stick), with(Status::Slip));
    last.active = last.sticking + last.slipping;
    last.flowing = flowing_points(evaluation);
}
