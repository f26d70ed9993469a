//! Is there a balance of rigid bodies at all?
//!
//! Loads, supports that hold both ways, and contact that only pushes and rubs no more than Coulomb lets it: if
//! these can be in balance, some forces within the cones of friction add up to the loads on every motion that
//! supports leave to the bodies. The forces that come nearest are those of a least-squares problem with
//! unknowns that are not negative. What they leave over is, when there is no balance, a motion that the loads drive
//! and that no contact resists (the lemma of Farkas): the body tips or slides along it. Nothing here knows of
//! stiffness, or of how the solution is found.

use crate::model::scene::Scene;
use crate::solver::solve::params::{BALANCE_REMAINDER, CONE_EDGES, ROUGHEST_FRICTION};
use crate::solver::solve::rigid::free_motion::FreeMotion;
use crate::solver::solve::rigid::movable::Movable;
use crate::solver::solve::rigid::touch::Touch;
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::statics::bears::{Bears, bears};
use crate::solver::solve::statics::friction_cone::cones;
use crate::solver::solve::statics::nonnegative::nearest;
use crate::solver::solve::statics::ridges::ridges;
use std::f64::consts::PI;

/// There is no balance of rigid bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct Imbalance {
    /// How the bodies would move.
    pub motion: FreeMotion,
    /// The least coefficient of friction, between all bodies, with which there is a balance; `None` where
    /// no friction makes one.
    pub friction: Option<f64>,
    /// What the body bears on most.
    pub bears: Option<Bears>,
}

/// Why bodies that touch at `rows` cannot be in balance under loads of these `factors`, by name; `None` where they
/// can, or nothing drives them.
pub fn imbalance<'r>(
    scene: &Scene,
    rows: impl Iterator<Item = &'r ContactRow>,
    factors: &dyn Fn(&str) -> f64,
) -> Option<Imbalance> {
    let Movable {
        bodies,
        modes,
        load,
    } = Movable::new(scene, factors)?;
    let whole = load.norm();
    let rows = ridges(scene, rows.collect());
    let points: Vec<Touch> = rows
        .iter()
        .map(|row| Touch::new(row, &bodies, &modes))
        .collect();
    let enclosing = 1.0 / (PI / CONE_EDGES as f64).cos();
    let found = nearest(&cones(&points, |friction| enclosing * friction), &load)?;
    if found.left.norm() <= BALANCE_REMAINDER * whole {
        return None;
    }
    // Advice is on the safe side: there the polygon lies within the circle.
    let rough = rows.iter().map(|row| Touch::rough(row, &bodies, &modes));
    let rough: Vec<Touch> = rough.collect();
    let stands = |least: f64| {
        let found = nearest(&cones(&rough, |friction| friction.max(least)), &load);
        found.is_some_and(|f| f.left.norm() <= BALANCE_REMAINDER * whole)
    };
    let motion = bodies.motion(scene, (&modes * &found.left).as_slice(), true)?;
    let body = scene
        .mesh
        .bodies
        .iter()
        .position(|b| b.name == motion.body)?;
    // What touches nothing needs no statics.
    let touched = |row: &&&ContactRow| {
        let nodes = row.row.terms.iter().map(|(node, _)| *node as usize);
        nodes
            .flat_map(|node| &bodies.bodies[node])
            .any(|b| *b == body)
    };
    rows.iter().find(touched)?;
    let bears = bears(scene, &rows, &bodies, (&found.forces, body));
    Some(Imbalance {
        motion,
        friction: stands(ROUGHEST_FRICTION).then(|| least(&stands)),
        bears,
    })
}

/// The least coefficient of friction with which bodies `stand`, to a thousandth.
fn least(stands: &dyn Fn(f64) -> bool) -> f64 {
    let (mut no, mut yes) = (0.0, ROUGHEST_FRICTION);
    while yes - no > 5e-4 * yes {
        let middle = 0.5 * (no + yes);
        if stands(middle) {
            yes = middle;
        } else {
            no = middle;
        }
    }
    yes
}
