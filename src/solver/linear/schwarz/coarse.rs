//! The coarse level: what subdomains cannot see of each other.
//!
//! A subdomain corrects its own unknowns well, but a motion that runs through many subdomains, such as a body
//! moving as a whole, would take one iteration for each subdomain on its way. The coarse level solves for such
//! motions at once. Its unknowns are, for every *piece* (one body within one subdomain), the coefficients of a
//! motion of second order
//!
//! ```text
//! u_a = c_a0 + c_a1 ξ + c_a2 η + c_a3 ζ + c_a4 ξ² + c_a5 η² + c_a6 ζ² + c_a7 ξη + c_a8 ηζ + c_a9 ζξ
//! a = 1, 2, 3,    (ξ, η, ζ) = (x − centre) / radius
//! ```
//!
//! which are 30: three translations, three rotations, six uniform strains, and eighteen of linear strain, bending and
//! twisting among them. Without contact and supports the translations and rotations cost no energy, so that local
//! solves cannot see them (Nicolaides, SIAM J. Numer. Anal. 24 (1987) 355). The uniform strains carry loads from piece to
//! piece. Plates and rings bend: without linear strain a piece cannot, its neighbours fold between two layers of nodes
//! instead, and the coarse level is as many times too stiff as a piece is elements long.
//!
//! Pieces overlap. Where m pieces share a vertex each counts there by 1/m: these weights sum to one (a partition of
//! unity), so that a motion of second order of a whole body is made exactly
//! (Toselli and Widlund, *Domain Decomposition Methods*, 2005, chapter 3).
//!
//! With the columns of Z the weighted motions, the coarse matrix is Zᵀ A Z and the correction of a residual r is
//! Z (Zᵀ A Z)⁻¹ Zᵀ r. Z is never stored: its entries are computed where they are needed (`Space::mode`).
//!
//! A is the elastic matrix K and what contact and flow change of it, which is at few vertices: Zᵀ K Z is made once, and
//! Zᵀ (A − K) Z from these vertices alone.

use super::partition::Division;
use super::place::Place;
use super::space::{FORMS, MODES, Mode, Space};
use crate::solver::linear::cholesky::{Factor, FactorError, Symbolic};
use crate::solver::linear::ordering::Block;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use rayon::prelude::*;

/// Block of the coarse matrix: modes of one piece by modes of another.
type Coupling = [[f64; MODES]; MODES];

/// Stiffness of a mode, over that of the stiffest, below which it is none but rounding.
const STIFFLESS: f64 = 1e-13;

/// Change of an entry of the diagonal, over it, that is rounding or what keeps a factor positive definite.
const UNCHANGED: f64 = 1e-9;

/// What is added to the diagonal of the coarse matrix, over the diagonal: modes of neighbours may be all but
/// dependent, as where two pieces share most of their vertices.
const SHIFT: f64 = 1e-9;

/// The coarse space, and which of its pieces couple; found once a pattern.
pub(super) struct Coarse {
    space: Space,
    /// Of the coarse matrix; a piece is a vertex of it.
    pattern: Pattern,
    symbolic: Symbolic,
    /// Zᵀ K Z.
    elastic: SymmetricMatrix,
}

impl Coarse {
    /// The coarse level of a `division` of the vertices of `pattern`, of the `elastic` matrix K.
    ///
    /// # Errors
    /// [`FactorError::Memory`].
    pub fn new(
        pattern: &Pattern,
        elastic: &SymmetricMatrix,
        places: &[Place],
        division: &Division,
    ) -> Result<Self, FactorError> {
        let space = Space::new(pattern, places, division);
        let pieces = space.pieces.len() as u32;
        let starts = (0..=pieces).map(|i| MODES as u32 * i).collect();
        let coupled = space.coupled(pattern);
        let own = Pattern::new(starts, coupled.iter().map(|p| p.as_slice()));
        let mut coarse = Self {
            symbolic: Symbolic::new(&own, &[Block::Sparse(0..pieces)])?,
            elastic: own.zeros(),
            pattern: own,
            space,
        };
        let block = |v, w| pattern.block(elastic, v, w);
        coarse.elastic = coarse.with(pattern, block, |_| true);
        Ok(coarse)
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.symbolic.factor_entries()
    }

    /// Factors Zᵀ A Z of `matrix`, in the memory of `old`; `elastic` is K.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or Zᵀ A Z is not positive definite.
    pub fn factorise(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        elastic: &SymmetricMatrix,
        old: Option<Factor<f64>>,
    ) -> Result<Factor<f64>, FactorError> {
        let changed = changed_vertices(pattern, matrix, elastic);
        let change = |v, w| {
            let [now, then] = [matrix, elastic].map(|m| pattern.block(m, v, w));
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| now[i][j] - then[i][j]))
        };
        let mut coarse = self.with(pattern, change, |v| changed[v as usize]);
        // A mode without stiffness stands for nothing: components that are held everywhere in the piece, or the slopes
        // of a motion that many nodes share. A stiffness of its own keeps it at zero.
        let diagonal = self.pattern.diagonal(&coarse);
        let most = diagonal.iter().copied().fold(0.0, f64::max);
        for (start, d) in self.pattern.columns.iter().zip(diagonal) {
            let added = if d > STIFFLESS * most {
                SHIFT * d
            } else {
                most
            };
            coarse.values[*start as usize] += added;
        }
        self.symbolic.factorise(&self.pattern, &coarse, old)
    }

    /// Zᵀ K Z and Zᵀ B Z, B having a `block` between any two of the vertices that are `chosen`, and no other.
    fn with(
        &self,
        pattern: &Pattern,
        block: impl Fn(u32, u32) -> [[f64; 3]; 3] + Sync,
        chosen: impl Fn(u32) -> bool + Sync,
    ) -> SymmetricMatrix {
        let pieces = (0..self.space.pieces.len() as u32).into_par_iter();
        let couplings: Vec<_> = pieces
            .map(|index| self.couple(pattern, &block, &chosen, index))
            .collect();
        let mut coarse = self.elastic.clone();
        for (i, list) in couplings.iter().enumerate() {
            for (j, coupling) in list {
                for q in 0..MODES {
                    let column = MODES * *j as usize + q;
                    let first = if i == *j as usize { q } else { 0 };
                    let row = (MODES * i + first) as u32;
                    let start = self.pattern.position(row, column as u32);
                    for p in first..MODES {
                        coarse.values[start + p - first] += coupling[p][q];
                    }
                }
            }
        }
        coarse
    }

    /// Blocks of Zᵀ B Z between a piece and itself, and pieces of lower numbers.
    ///
    /// Row by row of B: at each vertex v of the piece, B times the modes of every piece near v (the `forces`
    /// that those motions make at v), and these times the piece's own modes at v.
    fn couple(
        &self,
        pattern: &Pattern,
        block: impl Fn(u32, u32) -> [[f64; 3]; 3],
        chosen: impl Fn(u32) -> bool,
        index: u32,
    ) -> Vec<(u32, Box<Coupling>)> {
        let mut list: Vec<(u32, Box<Coupling>)> = Vec::new();
        // At the vertex at hand, of each piece near it: the force along each axis that each of its modes makes.
        let mut forces: Vec<(u32, [[Mode; 3]; 3])> = Vec::new();
        let starts = &pattern.vertex_start;
        let axes = |v: u32| {
            let equations = starts[v as usize]..starts[v as usize + 1];
            equations.map(|e| self.space.axis(e)).enumerate()
        };
        let piece = &self.space.pieces[index as usize];
        for &v in piece.vertices.iter().filter(|v| chosen(**v)) {
            forces.clear();
            let near = pattern.neighbours(v as usize).iter().chain([&v]);
            for &w in near.filter(|w| chosen(**w)) {
                let near = self.space.of_vertex[w as usize].iter();
                let mut near = near.filter(|other| **other <= index).peekable();
                if near.peek().is_none() {
                    continue;
                }
                let block = block(v, w);
                for &other in near {
                    let mode = self
                        .space
                        .mode(&self.space.pieces[other as usize], w, starts);
                    let target = entry(&mut forces, other, Default::default);
                    for ((i, a), (j, b)) in axes(v).flat_map(|a| axes(w).map(move |b| (a, b))) {
                        for (t, m) in target[a][b].iter_mut().zip(mode) {
                            *t += block[i][j] * m;
                        }
                    }
                }
            }
            let own = self.space.mode(piece, v, starts);
            for (other, forces) in &forces {
                let coupling = entry(&mut list, *other, || Box::new([[0.0; MODES]; MODES]));
                for (a, forces) in forces.iter().enumerate() {
                    for (p, own) in own.iter().enumerate() {
                        let row = &mut coupling[FORMS * a + p];
                        for (t, f) in row.iter_mut().zip(forces.as_flattened()) {
                            *t += own * f;
                        }
                    }
                }
            }
        }
        list
    }

    /// The coarse correction Z (Zᵀ A Z)⁻¹ Zᵀ r of a residual `r`.
    pub fn solve(&self, pattern: &Pattern, factor: &Factor<f64>, r: &[f64]) -> Vec<f64> {
        let mut c = self.space.restrict(pattern, r);
        self.symbolic.solve(factor, &mut c);
        self.space.prolong(pattern, &c)
    }
}

/// Which vertices stand in a matrix otherwise than in the elastic one, by more than rounding. What contact or flow changes
/// between two vertices it changes at both.
fn changed_vertices(
    pattern: &Pattern,
    matrix: &SymmetricMatrix,
    elastic: &SymmetricMatrix,
) -> Vec<bool> {
    let [now, then] = [matrix, elastic].map(|m| pattern.diagonal(m));
    let differs = |e: usize| (now[e] - then[e]).abs() > UNCHANGED * then[e].abs();
    let vertices = pattern.vertex_start.par_windows(2);
    let changed = vertices.map(|own| (own[0] as usize..own[1] as usize).any(differs));
    changed.collect()
}

/// The entry of `key` in a short list, new where there is none.
fn entry<T>(list: &mut Vec<(u32, T)>, key: u32, new: impl Fn() -> T) -> &mut T {
    let at = list.iter().position(|(k, _)| *k == key);
    let at = at.unwrap_or_else(|| {
        list.push((key, new()));
        list.len() - 1
    });
    &mut list[at].1
}
