//! Plastic strain that has settled.
//!
//! Elements that have flowed but do not flow now are elastic again: their plastic strain stays, and acts on elastic bodies
//! as a load does (an eigenstrain, Mura 1987).

use crate::solver::solve::checkpoint::plastic::Plastic;

/// Elements that have flowed and are taken for elastic again: their plastic strain stays, and acts on elastic
/// bodies as a load does.
#[derive(Clone, Default)]
pub struct Settled {
    pub elements: Plastic,
    /// Its forces on all unknowns, inner ones eliminated; empty where there are none.
    pub forces: Vec<f64>,
}

impl Settled {
    /// Adds its forces to those on all unknowns, inner ones eliminated.
    pub fn act_on(&self, forces: &mut [f64]) {
        forces
            .iter_mut()
            .zip(&self.forces)
            .for_each(|(sum, f)| *sum += f);
    }
}
