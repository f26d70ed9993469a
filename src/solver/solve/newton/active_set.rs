//! Multipliers and active sets after an iteration.
//!
//! Contact conditions are solved by augmented Lagrange with a primal-dual active set (Alart and Curnier 1991; Hüeber and
//! Wohlmuth 2005). After each correction the traction of a row becomes its multiplier, and the row decides anew whether it
//! is open, sticks or slips; see [`crate::solver::contact::law`]. An increment has converged only when no decision changes
//! any more, so that the answer does not depend on the penalty.

use crate::solver::contact::law::MOST_RAISED;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::newton::progress::Progress;
use crate::solver::solve::newton::rounding::closures;
use crate::solver::solve::params::{
    FREE_SWITCHES, FREE_SWITCHING_ITERATIONS, UNCHANGED_FORCE, UNCHANGED_SHARE_OF_LOAD,
};

/// Decides multipliers, active set and friction bounds anew; returns how many nodes changed.
///
/// A node has changed where it switched between open, stick and slip, where its friction bound moved, or where its shear
/// did not become its multiplier. Changes by next to nothing of the largest contact force, or of the load, do not
/// count; next to nothing is larger by the factor `roughness` than for an answer. Nor do changes that
/// rounding makes: of a traction by what is left of its digits, of a force by less than what it is `known` to. Late in an
/// increment, nodes that have switched between stick and slip a few times become cautious.
pub fn update_active_set(
    model: &Model,
    point: &mut Point,
    (evaluation, known): (&Evaluation, f64),
    (iteration, roughness, progress): (usize, f64, &mut Progress),
) -> usize {
    // What is next to nothing is measured by the largest normal force, and where that is small itself by the load.
    let forces =
        (model.rows.iter().zip(&evaluation.contact)).map(|(r, a)| r.row.area * a.traction[0]);
    let largest = forces.fold(0.0, f64::max);
    let least =
        roughness * (UNCHANGED_FORCE * largest).max(UNCHANGED_SHARE_OF_LOAD * model.reference);
    let rows = model.rows.iter().zip(&evaluation.contact);
    let wanted: Vec<f64> = rows.map(|(r, a)| r.law.bound(&a.traction)).collect();
    let bounds = (progress.bounds).next(&point.nodes, wanted, progress.settled > 0);
    let (mut changed, mut switched) = (0, 0);
    // The longer nothing switches the nearer the slopes of slipping nodes may come to Newton's.
    let calm = progress
        .settled
        .saturating_sub(1)
        .min(usize::from(MOST_RAISED)) as u8;
    let closures = closures(model, point);
    for (index, (row, node)) in model.rows.iter().zip(&mut point.nodes).enumerate() {
        let law = &row.law;
        if !node.cautious {
            node.raised = calm;
        }
        let traction = &evaluation.contact[index].traction;
        let relative = &evaluation.relative[index];
        let next = law.decide(node, traction, relative, bounds[index]);
        let rounding = (law.rounding(node, closures[index])).max(known / row.row.area);
        let least = (least / row.row.area).max(rounding);
        let same = (law.friction * least).max(rounding);
        let turned =
            !node.cautious && (1..3).any(|i| (next.multiplier[i] - traction[i]).abs() > same);
        let moved = next.closed && (law.bound(traction) - node.bound).abs() > same;
        let switches = match (node.closed, next.closed) {
            (true, true) => {
                next.sticks != node.sticks
                    && law.beyond(traction, relative, bounds[index]).abs() > same
            }
            (false, false) => false,
            _ => law.presses(node, traction, relative).abs() > least,
        };
        switched += usize::from(switches);
        changed += usize::from(switches || moved || turned);
        *node = next;
        if !node.cautious && iteration > FREE_SWITCHING_ITERATIONS && node.switches > FREE_SWITCHES
        {
            (node.cautious, node.raised) = (true, 0);
        }
    }
    progress.settled = if switched == 0 {
        progress.settled + 1
    } else {
        0
    };
    changed
}

/// Shear tractions of cautious nodes become multipliers.
pub fn take_shears(model: &Model, point: &mut Point, evaluation: &Evaluation) {
    let rows = model.rows.iter().zip(&evaluation.contact);
    for (node, (row, answer)) in point.nodes.iter_mut().zip(rows) {
        if node.cautious && node.closed {
            row.law.take_shear(node, answer);
        }
    }
}
