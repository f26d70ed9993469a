//! Does a state belong to a scene?

use super::State;
use crate::model::scene::Scene;
use thiserror::Error;

/// A state whose arrays are not as long as the scene asks for.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("the state does not belong to the scene: {what} has {found} entries, expected {expected}")]
pub struct Misfit {
    /// The array.
    pub what: String,
    /// Its length,
    pub found: usize,
    /// and the length that the scene asks for.
    pub expected: usize,
}

fn same(what: &str, found: usize, expected: usize) -> Result<(), Misfit> {
    if found == expected {
        Ok(())
    } else {
        Err(Misfit {
            what: what.to_string(),
            found,
            expected,
        })
    }
}

impl State {
    /// Checks that every array is as long as the mesh and the contact pairs of `scene` ask for.
    ///
    /// `peeq` may be left out altogether, which says that nothing yielded.
    ///
    /// # Errors
    /// [`Misfit`] names the first array of another length.
    pub fn check(&self, scene: &Scene) -> Result<(), Misfit> {
        let elements = scene.mesh.hexes.len();
        same(
            "displacement",
            self.displacement.len(),
            scene.mesh.points.len(),
        )?;
        same("stress", self.stress.len(), elements)?;
        if !self.peeq.is_empty() {
            same("peeq", self.peeq.len(), elements)?;
        }
        same("contacts", self.contacts.len(), scene.contacts.len())?;
        same("planes", self.planes.len(), scene.rigid_planes.len())?;
        same("ties", self.ties.len(), scene.ties.len())?;
        for (pair, field) in scene.contacts.iter().zip(&self.contacts) {
            let n = field.nodes.len();
            let of = |array: &str| format!("{array} of {}", pair.name);
            same(&of("pressure"), field.pressure.len(), n)?;
            same(&of("multiplier"), field.multiplier.len(), n)?;
            same(&of("sagitta"), field.sagitta.len(), n)?;
            same(&of("gap"), field.gap.len(), n)?;
            same(&of("traction"), field.traction.len(), n)?;
            same(&of("slip"), field.slip.len(), n)?;
            same(&of("status"), field.status.len(), n)?;
            same(&of("area"), field.area.len(), n)?;
            same(&of("force"), field.force.len(), n)?;
            same(&of("acts_at"), field.acts_at.len(), n)?;
        }
        Ok(())
    }

    /// Equivalent plastic strain at the integration points of `element`; zero where left out.
    pub fn peeq_of(&self, element: usize) -> [f64; 8] {
        self.peeq.get(element).copied().unwrap_or([0.0; 8])
    }
}
