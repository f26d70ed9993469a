//! The proximal point method: floating bodies, held back until contact holds them.
//!
//! A body that only contact holds can be anywhere while the wrong nodes are closed: it tips or slides out of
//! the model within an iteration. A weak spring from every unknown to where it stands keeps it near, as the
//! stabilisation of contact in other programs does. The springs are let go and made weaker in turns
//! (Rockafellar, *Monotone Operators and the Proximal Point Algorithm*, 1976): each turn moves the bodies towards their
//! balance, and what comes out is a first guess. No spring acts in the balance that is then found from it.

use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::linear_system::linear_solver::LinearSolver;
use crate::solver::solve::linear_system::proximal_springs::ProximalSprings;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::newton::balance::balance_increment;
use crate::solver::solve::newton::failure::{Failure, Stopped};
use crate::solver::solve::newton::goal::Goal;
use crate::solver::solve::observer::Observer;
use crate::solver::solve::params::PROXIMAL_STIFFNESSES;

/// Moves `point` near its balance, with springs that become weaker. Only a cancelled solution is an error: what
/// else goes wrong leaves a poor guess.
pub fn approach_balance(
    model: &Model,
    history: &History,
    point: &mut Point,
    solver: &mut LinearSolver,
    observer: &mut dyn Observer,
    counters: &mut Counters,
) -> Result<(), Stopped> {
    let bodies = model.pattern.diagonal(&model.stiffness);
    for share in PROXIMAL_STIFFNESSES {
        let springs = ProximalSprings {
            stiffness: bodies.iter().map(|k| share * k).collect(),
            at: point.x.clone(),
        };
        let mut trial = point.clone();
        let held = (&mut trial, Goal::Held(&springs));
        match balance_increment(model, history, held, solver, observer, counters) {
            Ok(_) => *point = trial,
            Err(
                stopped @ Stopped {
                    why: Failure::Cancelled,
                    ..
                },
            ) => return Err(stopped),
            // Weaker springs would do worse.
            Err(_) => break,
        }
    }
    solver.forget();
    Ok(())
}
