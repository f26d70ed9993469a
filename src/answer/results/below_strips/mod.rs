//! The Mises stress below long strips of contact, as half spaces and what else acts in a body make it.
//!
//! A few nodes across a strip say little of the stress below it, but its load is known well, and under that load the half
//! space of each strip of a pair is known in closed form ([`LineField`](crate::analytic::subsurface::LineField)). What these do not know of, as the bending of a
//! ring, the other side of a plate or a corner, changes little over a half-width: it is what the solution shows beyond them a
//! few half-widths away, where elements follow it.

mod friction;
mod reading;
mod section;
mod strips;

use super::edges::SingularEdges;
use super::hertz::{Departure, HeaviestLine};
use super::recovery::Recovered;
use crate::ground::geometry::scale;
use crate::model::scene::Scene;
use crate::model::state::State;
pub use reading::BelowStrips;
use strips::Strips;

/// That of every body, in the order of the mesh; `None` where no strip is a half space's, or the nodes tell nothing of the rest.
pub fn below_strips(
    (scene, state): (&Scene, &State),
    recovered: &Recovered,
    lines: &[Option<HeaviestLine>],
    edges: &SingularEdges,
) -> Vec<Option<BelowStrips>> {
    let mut all = vec![None; scene.mesh.bodies.len()];
    for (index, (pair, line)) in scene.contacts.iter().zip(lines).enumerate() {
        let Some(line) = line.as_ref().filter(|line| is_known(line)) else {
            continue;
        };
        let Some((strips, field)) =
            Strips::of(scene, index, line, edges).zip(state.contacts.get(index))
        else {
            continue;
        };
        let turns = strips.turns(scene, field);
        // Forces are those on the lower body.
        let sides = pair.bodies(&scene.mesh).into_iter().zip([-1.0, 1.0]);
        for (body, sign) in sides.filter_map(|(body, sign)| Some((body?, sign))) {
            let forces = |row: f64| scale(strips.force(scene, field, row), sign);
            let largest = strips.largest((scene, edges), recovered, body, (&forces, turns));
            let known: &mut Option<BelowStrips> = &mut all[body];
            let is_larger = |new: &BelowStrips| known.is_none_or(|old| new.mises > old.mises);
            if let Some(new) = largest.filter(is_larger) {
                *known = Some(new);
            }
        }
    }
    all
}

/// Are the bodies below it half spaces to it, and elastic?
fn is_known(line: &HeaviestLine) -> bool {
    let departs = |by| line.departs == Some(by);
    line.strip().is_some() && !departs(Departure::Width) && !departs(Departure::Flow)
}
