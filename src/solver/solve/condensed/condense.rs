//! Condensation of one group, where that pays.

use crate::solver::linear::cholesky::FactorError;
use crate::solver::linear::sparse::Pattern;
use crate::solver::linear::substructure::{Condensation, Substructure};
use crate::solver::solve::condensed::assembly::{Condensing, assemble_elastic};
use crate::solver::solve::condensed::cost::{seconds_condensed, seconds_sparse};
use crate::solver::solve::condensed::groups::{Group, local_pattern, numbering};
use crate::solver::solve::error::SolveError;

/// A condensed group of bodies that hold together.
pub struct CondensedPart {
    /// The group's equations, ascending.
    pub equations: Vec<u32>,
    pub substructure: Substructure,
}

/// What became of a group.
pub enum Made {
    Sparse(Group),
    Condensed(Box<Condensed>),
}

pub struct Condensed {
    pub part: CondensedPart,
    pub zone: Vec<u32>,
    pub kept_vertices: Vec<u32>,
    /// The part's stiffness seen from the kept vertices: the lower triangle, column by column.
    pub schur: Vec<f64>,
}

/// A group, and how its inner unknowns would be eliminated if that is possible and may pay.
pub struct Candidate {
    group: Group,
    condensing: Option<(Pattern, Condensation)>,
}

impl Candidate {
    /// Condensing does not pay where nothing or more than a third of the vertices is kept.
    ///
    /// # Errors
    /// [`SolveError::Factor`] where memory runs out.
    pub fn new(plan: &Condensing, vertex_of: &[u32], group: Group) -> Result<Self, SolveError> {
        let kept = kept(plan, &group);
        let count = kept.iter().filter(|k| **k).count();
        let condensing = if !plan.condense || count == 0 || 3 * count > kept.len() {
            None
        } else {
            let pattern = local_pattern(plan, vertex_of, &group);
            let condensation = Condensation::new(&pattern, &kept)?;
            Some((pattern, condensation))
        };
        Ok(Self { group, condensing })
    }

    /// Seconds of an iteration with it condensed and sparse.
    pub fn seconds(&self) -> [f64; 2] {
        let sparse = seconds_sparse(self.group.elements.len());
        let condensed = self
            .condensing
            .as_ref()
            .map_or(sparse, |(_, condensation)| {
                seconds_condensed(condensation.kept(), condensation.work())
            });
        [condensed, sparse]
    }

    /// Condenses the group, if `worth`. One that could still turn while its kept nodes stand has a singular inner
    /// stiffness, and is left sparse, too.
    ///
    /// # Errors
    /// [`SolveError::Factor`] where memory runs out.
    pub fn make(self, plan: &Condensing, worth: bool) -> Result<Made, SolveError> {
        let Self { group, condensing } = self;
        let Some((pattern, condensation)) = condensing.filter(|_| worth) else {
            return Ok(Made::Sparse(group));
        };
        let (equations, local_of) = numbering(plan, &group);
        let matrix = assemble_elastic(plan, &group.elements, &pattern, |e| local_of[e as usize]);
        match condensation.eliminate(&pattern, &matrix) {
            Ok((substructure, schur)) => Ok(Made::Condensed(Box::new(Condensed {
                kept_vertices: (group.vertices.iter().zip(kept(plan, &group)))
                    .filter_map(|(v, kept)| kept.then_some(*v))
                    .collect(),
                zone: group.zone,
                part: CondensedPart {
                    equations,
                    substructure,
                },
                schur,
            }))),
            // Held at the kept nodes alone it could still turn.
            Err(FactorError::NotPositiveDefinite { .. }) => Ok(Made::Sparse(group)),
            Err(error) => Err(error.into()),
        }
    }
}

/// Which vertices of a group are kept.
fn kept(plan: &Condensing, group: &Group) -> Vec<bool> {
    let vertices = group.vertices.iter();
    vertices.map(|v| plan.needed[*v as usize]).collect()
}
