//! Why an increment could not be solved, in terms of the scene.

use crate::solver::linear::cholesky::FactorError;
use crate::solver::solve::equilibrium::evaluation::much_flows;
use crate::solver::solve::error::{Flowing, Obstacle, SolveError};
use crate::solver::solve::increments::place::{body_of, contact_in_words, place, place_in_words};
use crate::solver::solve::model::system::Model;
use crate::solver::solve::newton::failure::{Failure, Stopped};

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
            Some(Flowing {
                body,
                percent: share,
            }),
        ) => SolveError::LimitLoad {
            step,
            percent,
            body,
            share,
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
                rounding,
                changed,
                equation,
                row,
            },
            most,
        ) => SolveError::NotConverged {
            step,
            percent,
            iterations: at.iterations,
            residual,
            penetration,
            place: place_in_words(model, equation),
            contact: contact_in_words(model, row, changed),
            obstacle: (rounding.map(Obstacle::Rounding))
                .or_else(|| {
                    let much = most.filter(|_| much_flows(model, &stopped.flowing));
                    much.map(Obstacle::Flow)
                })
                .map(Box::new),
        },
        (Failure::Cancelled | Failure::UnforeseenFlow, _) => SolveError::NothingFree,
    }
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
        Failure::UnforeseenFlow => "steel flows where it was not expected".to_owned(),
        Failure::Cancelled => "cancelled".to_owned(),
    }
}

fn free_body(model: &Model, node: u32, axis: usize) -> SolveError {
    let body = body_of(model, node);
    let mesh = &model.scene.mesh;
    let own = mesh.body(&body.name);
    let pairs = model.scene.contacts.iter();
    let pairs = pairs.filter(|pair| pair.bodies(mesh).contains(&own));
    SolveError::FreeBody {
        body: body.name.clone(),
        contacts: pairs.map(|pair| pair.name.clone()).collect(),
        axis: ['x', 'y', 'z'][axis],
        pieces: mesh.pieces(body.elements.clone()),
    }
}

/// The body of which the largest share of elements is among the `flowing` ones; `None` where there are none.
fn gives_way(model: &Model, flowing: &[u32]) -> Option<Flowing> {
    let mesh = &model.scene.mesh;
    let mut elements = vec![0usize; mesh.bodies.len()];
    for element in flowing {
        elements[mesh.body_of(*element as usize)] += 1;
    }
    let shares = mesh.bodies.iter().zip(elements);
    let shares = shares.map(|(body, n)| (body, n as f64 / body.elements.len().max(1) as f64));
    let (body, share) = shares.max_by(|a, b| a.1.total_cmp(&b.1))?;
    (share > 0.0).then(|| Flowing {
        body: body.name.clone(),
        percent: 100.0 * share,
    })
}
