//! Condensation of one group, where that pays.

use crate::solver::linear::cholesky::FactorError;
use crate::solver::linear::substructure::{Condensation, Substructure};
use crate::solver::solve::condensed::assembly::{Condensing, assemble_elastic};
use crate::solver::solve::condensed::groups::{Group, local_pattern, numbering};
use crate::solver::solve::error::SolveError;
use faer::Mat;

/// A condensed group of bodies that hold together.
pub struct Part {
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
    pub part: Part,
    pub zone: Vec<u32>,
    pub kept_vertices: Vec<u32>,
    /// The part's stiffness seen from the kept vertices.
    pub schur: Mat<f64>,
}

/// Condenses a group where that pays.
///
/// It does not pay where nothing or more than a third of its vertices is kept, nor where a dense factor of the kept
/// unknowns, made anew in many iterations, takes more work than eliminating the inner ones once. A group that could
/// still turn while its kept nodes stand has a singular inner stiffness, and is left sparse, too.
pub fn make(plan: &Condensing, vertex_of: &[u32], group: Group) -> Result<Made, SolveError> {
    let kept: Vec<bool> = group
        .vertices
        .iter()
        .map(|v| plan.needed[*v as usize])
        .collect();
    let count = kept.iter().filter(|k| **k).count();
    if !plan.condense || count == 0 || 3 * count > kept.len() {
        return Ok(Made::Sparse(group));
    }
    let (equations, local_of) = numbering(plan, &group);
    let pattern = local_pattern(plan, vertex_of, &group);
    let condensation = Condensation::new(&pattern, &kept)?;
    // A dense factor takes n³/6 multiplications, and iterations make it anew.
    if (condensation.kept() as f64).powi(3) / 6.0 > condensation.work() {
        return Ok(Made::Sparse(group));
    }
    let matrix = assemble_elastic(plan, &group.elements, &pattern, |e| local_of[e as usize]);
    match condensation.eliminate(&pattern, matrix) {
        Ok((substructure, schur)) => Ok(Made::Condensed(Box::new(Condensed {
            zone: group.zone,
            kept_vertices: (group.vertices.iter().zip(&kept))
                .filter_map(|(v, kept)| kept.then_some(*v))
                .collect(),
            part: Part {
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
