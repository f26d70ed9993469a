//! Ties beside contact.

use crate::model::mesh::{Face, Surface};
use crate::model::scene::{Scene, Tie};
use crate::solver::fem::tied::Tied;
use crate::solver::solve::ties::error::TieError;
use std::collections::BTreeSet;

/// Contact may run across a tie, and may be beside it on one surface. But what is tied cannot open, and a surface of which
/// every node follows another one has none that could carry pressure.
///
/// # Errors
/// [`TieError::Contact`] where a pair and a tie join the same two surfaces, facet by facet, or where the carrier of a pair
/// follows altogether.
pub fn beside_contact(scene: &Scene, tied: &Tied) -> Result<(), TieError> {
    let mesh = &scene.mesh;
    for pair in &scene.contacts {
        let sides = pair.carrier_first().map(|side| side.surface(mesh));
        for tie in &scene.ties {
            let Some(own) = tie.of(mesh) else { continue };
            let [a, b] = sides.map(|side| own.map(|own| side.is_some_and(|s| meet(s, own))));
            let both = (a[0] && b[1]) || (a[1] && b[0]);
            let all = |s: &Surface| s.nodes().iter().all(|node| tied.has(*node));
            if both || ((a[0] || a[1]) && sides[0].is_some_and(all)) {
                return Err(refused(tie, &pair.name));
            }
        }
    }
    Ok(())
}

/// Have the surfaces a facet in common?
fn meet(one: &Surface, other: &Surface) -> bool {
    let of = |s: &Surface| -> BTreeSet<_> { s.faces.iter().map(Face::key).collect() };
    !of(one).is_disjoint(&of(other))
}

fn refused(tie: &Tie, pair: &str) -> TieError {
    TieError::Contact {
        tie: tie.name.clone(),
        pair: pair.to_owned(),
    }
}
