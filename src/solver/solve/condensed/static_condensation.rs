//! Static condensation of the bodies onto what Newton's method iterates on.
//!
//! Away from contact and plastic flow a body is linear. Order its unknowns as inner ones i, which only elastic elements
//! act on, and kept ones k, which contact rows or flowing elements act on too. Inner unknowns carry no residual, so that
//! ```text
//! S = K_kk − K_ki K_ii⁻¹ K_ik,    g = f_k − K_ki K_ii⁻¹ f_i,    u_i = K_ii⁻¹ (f_i − K_ik u_k)
//! ```
//! give the same kept displacements as the whole system: S u_k = g (Guyan 1965; Irons 1965). K_ii is factored once, and
//! iterations see S only, about a tenth of the unknowns. Bodies of which most nodes are kept are left sparse, and so are those
//! where iterations with dense S would take longer than with the sparse factor of the whole (`condensed/cost.rs`): a
//! displaced bearing of 136 thousand unknowns of which 31 thousand flow takes 1.4 s for a new factor and some directions
//! with S, 0.9 s without, and 14 s less for condensing.
//!
//! Numbering: the equations of sparse groups come first; then, group by group, those of its flowing elements and those of
//! S, the small groups before the large ones.

use crate::solver::fem::dofs::{DofMap, FIXED, Further};
use crate::solver::linear::ordering::Block;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use crate::solver::solve::condensed::assembly::Condensing;
use crate::solver::solve::condensed::condense::{Candidate, CondensedPart, Made};
use crate::solver::solve::condensed::cost::worth_condensing;
use crate::solver::solve::condensed::groups::{Group, groups};
use crate::solver::solve::error::SolveError;
use rayon::prelude::*;
use std::ops::Range;

/// All bodies, and the equations that are left of them.
///
/// Equations and vertices are those of all unknowns; *kept* ones have numbers of their own.
pub struct CondensedBodies {
    /// The condensed groups.
    pub parts: Vec<CondensedPart>,
    /// Kept equation of each equation, or [`FIXED`].
    kept_of: Vec<u32>,
    /// Equation of each kept equation.
    pub kept: Vec<u32>,
    /// First kept equation of each kept vertex, and their number at the end.
    pub vertex_start: Vec<u32>,
    /// Kept vertices in the order in which they are to be eliminated.
    pub blocks: Vec<Block>,
    /// Elements that were not condensed.
    pub sparse_elements: Vec<u32>,
    /// Kept vertices of each condensed group, and its stiffness S seen from there, the lower triangle column by column: a
    /// superelement.
    superelements: Vec<(Range<u32>, Vec<f64>)>,
}

impl CondensedBodies {
    /// Condenses every group of bodies that is worth it.
    ///
    /// # Errors
    /// [`SolveError::Factor`] where memory runs out.
    pub fn new(plan: &Condensing) -> Result<Self, SolveError> {
        let vertex_of = plan.dofs.vertices();
        let mut sparse: Vec<Group> = Vec::new();
        let mut condensed = Vec::new();
        let candidates: Result<Vec<_>, _> = groups(plan, &vertex_of)
            .into_par_iter()
            .map(|group| Candidate::new(plan, &vertex_of, group))
            .collect();
        let candidates = candidates?;
        let seconds: Vec<_> = candidates.iter().map(Candidate::seconds).collect();
        let made: Vec<_> = (candidates.into_par_iter().zip(worth_condensing(&seconds)))
            .map(|(candidate, worth)| candidate.make(plan, worth))
            .collect();
        for result in made {
            match result? {
                Made::Sparse(group) => sparse.push(group),
                Made::Condensed(made) => condensed.push(*made),
            }
        }
        // Small ones are eliminated first: a chain of bodies then fills nothing in.
        condensed.sort_by_key(|made| made.kept_vertices.len());
        let mut bodies = Self {
            parts: Vec::new(),
            kept_of: vec![FIXED; plan.dofs.len()],
            kept: Vec::new(),
            vertex_start: vec![0],
            blocks: Vec::new(),
            sparse_elements: Vec::new(),
            superelements: Vec::new(),
        };
        bodies.sparse_elements = plan.flow.to_vec();
        let mut vertices = Vec::new();
        for group in sparse {
            bodies.sparse_elements.extend(group.elements);
            vertices.extend(group.vertices.into_iter().chain(group.zone));
        }
        bodies.sparse_elements.sort_unstable();
        vertices.sort_unstable();
        let range = bodies.keep(plan.dofs, &vertices);
        bodies.blocks.push(Block::Sparse(range));
        for made in condensed {
            let range = bodies.keep(plan.dofs, &made.zone);
            bodies.blocks.push(Block::Sparse(range));
            let range = bodies.keep(plan.dofs, &made.kept_vertices);
            bodies.blocks.push(Block::Dense(range.clone()));
            bodies.superelements.push((range, made.schur));
            bodies.parts.push(made.part);
        }
        Ok(bodies)
    }

    /// Appends vertices to the kept ones; returns their numbers there.
    fn keep(&mut self, dofs: &DofMap, vertices: &[u32]) -> Range<u32> {
        let first = self.vertex_start.len() as u32 - 1;
        for vertex in vertices {
            let vertex = *vertex as usize;
            for equation in dofs.vertex_start[vertex]..dofs.vertex_start[vertex + 1] {
                self.kept_of[equation as usize] = self.kept.len() as u32;
                self.kept.push(equation);
            }
            self.vertex_start.push(self.kept.len() as u32);
        }
        first..first + vertices.len() as u32
    }

    /// Kept equation of an equation, or [`FIXED`].
    pub fn kept_of(&self, equation: u32) -> u32 {
        self.kept_of[equation as usize]
    }

    /// `dofs` with kept equations only; all other components count as without equation.
    pub fn kept_dofs(&self, dofs: &DofMap) -> DofMap {
        let kept = |equation: u32| match equation {
            FIXED => FIXED,
            _ => self.kept_of[equation as usize],
        };
        DofMap {
            equations: dofs.equations.iter().map(|e| e.map(kept)).collect(),
            vertex_start: self.vertex_start.clone(),
            planes: dofs.planes.clone(),
            turns: dofs.turns.clone(),
            turn_length: dofs.turn_length.clone(),
            further: (dofs.further.iter())
                .map(|further| Further {
                    equation: kept(further.equation),
                    ..*further
                })
                .collect(),
            prescribed: dofs.prescribed.clone(),
            turned: dofs.turned.clone(),
            tied: dofs.tied.clone(),
        }
    }

    /// Vertices of each condensed part: they are coupled in full.
    pub fn cliques(&self) -> impl Iterator<Item = Vec<u32>> {
        self.superelements.iter().map(|(r, _)| r.clone().collect())
    }

    /// Adds the condensed stiffness on the kept equations.
    pub fn add_stiffness(&self, pattern: &Pattern, matrix: &mut SymmetricMatrix) {
        for (vertices, schur) in &self.superelements {
            let [first, end] = [vertices.start, vertices.end]
                .map(|vertex| self.vertex_start[vertex as usize] as usize);
            for (column, own) in schur.chunks_exact((end - first).max(1)).enumerate() {
                // Below the diagonal a column of the part begins with the part's own rows.
                let start = pattern.columns[first + column] as usize;
                let own = &own[column..];
                let values = &mut matrix.values[start..start + own.len()];
                values
                    .iter_mut()
                    .zip(own)
                    .for_each(|(value, s)| *value += s);
            }
        }
    }

    /// Forgets the condensed stiffness, once it is in the matrix.
    pub fn release(&mut self) {
        self.superelements = Vec::new();
    }

    /// Forgets the factors as well.
    pub fn forget(&mut self) {
        self.parts = Vec::new();
    }

    /// Entries of all factors.
    pub fn factor_entries(&self) -> usize {
        let parts = self.parts.iter();
        parts.map(|p| p.substructure.factor_entries()).sum()
    }
}
