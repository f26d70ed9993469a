//! The coarse level: what subdomains cannot see of each other.
//!
//! A subdomain corrects its own unknowns well, but a motion that runs through many subdomains, such as a body
//! moving as a whole, would take one iteration for each subdomain on its way. The coarse level solves for such
//! motions at once. Its unknowns are, for every *piece* (one body within one subdomain), the coefficients of an
//! affine motion
//!
//! ```text
//! u_a(x) = c_a0 + c_a1 ξ + c_a2 η + c_a3 ζ,    a = 1, 2, 3,    (ξ, η, ζ) = (x − centre) / radius
//! ```
//!
//! which are 12: three translations, three rotations, six uniform strains. Without contact and supports the
//! translations and rotations cost no energy, so that local solves cannot see them (Nicolaides, SIAM J. Numer.
//! Anal. 24 (1987) 355). The uniform strains carry loads from piece to piece.
//!
//! Pieces overlap. Where m pieces share a vertex each counts there by 1/m: these weights sum to one (a partition of
//! unity), so that equal coefficients in all pieces make exactly that affine motion of the whole body
//! (Toselli and Widlund, *Domain Decomposition Methods*, 2005, chapter 3).
//!
//! With the columns of Z the weighted motions, the coarse matrix is Zᵀ A Z and the correction of a residual r is
//! Z (Zᵀ A Z)⁻¹ Zᵀ r. Z is never stored: its entries are computed where they are needed (`Coarse::mode`).

use super::partition::Division;
use super::place::Place;
use crate::ground::geometry::Vec3;
use crate::solver::linear::cholesky::{Factor, FactorError, Symbolic};
use crate::solver::linear::ordering::Block;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use rayon::prelude::*;

/// Functions that each displacement component of a piece is made of: 1, ξ, η, ζ.
const FORMS: usize = 4;
/// Coarse unknowns of a piece.
const MODES: usize = 3 * FORMS;
/// Values of the four functions at a vertex, times the piece's weight there.
type Mode = [f64; FORMS];
/// Block of the coarse matrix: modes of one piece by modes of another.
type Coupling = [[f64; MODES]; MODES];

/// Stiffness of a mode, over that of the stiffest, below which it is none but rounding.
const STIFFLESS: f64 = 1e-13;

/// What is added to the diagonal of the coarse matrix, over the diagonal: modes of neighbours may be all but
/// dependent, as where two pieces share most of their vertices.
const SHIFT: f64 = 1e-9;

/// One body within one subdomain, overlap included.
struct Piece {
    vertices: Vec<u32>,
    /// Mean of its points.
    centre: Vec3,
    /// Root mean square of their distances from it, so that all modes have about the same size.
    radius: f64,
}

/// The pieces and which of them couple, found once a pattern.
pub struct Coarse {
    pieces: Vec<Piece>,
    /// Pieces that each vertex belongs to.
    of_vertex: Vec<Vec<u32>>,
    places: Vec<Place>,
    /// Of the coarse matrix; a piece is a vertex of it.
    pattern: Pattern,
    symbolic: Symbolic,
}

/// The coarse matrix and its factor.
pub struct CoarseFactor {
    /// Blocks of Zᵀ A Z: of each piece those with itself and with pieces of lower numbers.
    couplings: Vec<Vec<(u32, Box<Coupling>)>>,
    factor: Factor<f64>,
}

impl Coarse {
    /// The coarse level of a `division` of the vertices of `pattern`.
    ///
    /// # Errors
    /// [`FactorError::Memory`].
    pub fn new(
        pattern: &Pattern,
        places: &[Place],
        division: &Division,
    ) -> Result<Self, FactorError> {
        let vertices = pattern.vertex_start.len() - 1;
        let point = |v: u32| places[pattern.vertex_start[v as usize] as usize].map(|p| p.0);
        let pieces: Vec<Piece> = (division.pieces.iter())
            .map(|vertices| Piece::new(vertices, point))
            .collect();
        let mut of_vertex = vec![Vec::new(); vertices];
        for (index, piece) in pieces.iter().enumerate() {
            for v in &piece.vertices {
                of_vertex[*v as usize].push(index as u32);
            }
        }
        // Pieces couple where a vertex of one is a neighbour of a vertex of the other.
        let pairs: Vec<[u32; 2]> = (pieces.par_iter().enumerate())
            .flat_map_iter(|(index, piece)| {
                let mut near: Vec<u32> = (piece.vertices.iter())
                    .flat_map(|v| pattern.neighbours(*v as usize))
                    .flat_map(|v| &of_vertex[*v as usize])
                    .copied()
                    .collect();
                near.sort_unstable();
                near.dedup();
                near.into_iter().map(move |other| [index as u32, other])
            })
            .collect();
        let starts = (0..=pieces.len() as u32)
            .map(|i| MODES as u32 * i)
            .collect();
        let coupled = pairs.iter().filter(|p| p[0] != p[1]);
        let own = Pattern::new(starts, coupled.map(|p| p.as_slice()));
        Ok(Self {
            symbolic: Symbolic::new(&own, &[Block::Sparse(0..pieces.len() as u32)])?,
            pattern: own,
            pieces,
            of_vertex,
            places: places.to_vec(),
        })
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.symbolic.factor_entries()
    }

    /// Zᵀ A Z and its factor. Blocks of `old` are kept for pieces without an equation that has `changed`.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or Zᵀ A Z is not positive definite.
    pub fn factorise(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        old: Option<CoarseFactor>,
        changed: impl Fn(u32) -> bool + Sync,
    ) -> Result<CoarseFactor, FactorError> {
        let (mut couplings, storage) = match old {
            Some(old) => (old.couplings, Some(old.factor)),
            None => (vec![Vec::new(); self.pieces.len()], None),
        };
        couplings
            .par_iter_mut()
            .enumerate()
            .for_each(|(index, list)| {
                let mut equations = (self.pieces[index].vertices.iter()).flat_map(|v| {
                    pattern.vertex_start[*v as usize]..pattern.vertex_start[*v as usize + 1]
                });
                if list.is_empty() || equations.any(&changed) {
                    *list = self.couple(pattern, matrix, index as u32);
                }
            });
        let mut coarse = self.pattern.zeros();
        for (i, list) in couplings.iter().enumerate() {
            for (j, block) in list {
                for q in 0..MODES {
                    let column = MODES * *j as usize + q;
                    let first = if i == *j as usize { q } else { 0 };
                    let row = (MODES * i + first) as u32;
                    let start = self.pattern.position(row, column as u32);
                    for p in first..MODES {
                        coarse.values[start + p - first] = block[p][q];
                    }
                }
            }
        }
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
        Ok(CoarseFactor {
            couplings,
            factor: self.symbolic.factorise(&self.pattern, &coarse, storage)?,
        })
    }

    /// Blocks of Zᵀ A Z between a piece and itself, and pieces of lower numbers.
    ///
    /// Row by row of A: at each vertex v of the piece, A times the modes of every piece near v (the `forces`
    /// that those motions make at v), and these times the piece's own modes at v.
    fn couple(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        index: u32,
    ) -> Vec<(u32, Box<Coupling>)> {
        let mut list: Vec<(u32, Box<Coupling>)> = Vec::new();
        // At the vertex at hand, of each piece near it: the force along each axis that each of its modes makes.
        let mut forces: Vec<(u32, [[Mode; 3]; 3])> = Vec::new();
        let starts = &pattern.vertex_start;
        let axes = |v: u32| {
            let equations = starts[v as usize]..starts[v as usize + 1];
            equations.map(|e| self.axis(e)).enumerate()
        };
        let piece = &self.pieces[index as usize];
        for &v in &piece.vertices {
            forces.clear();
            for &w in pattern.neighbours(v as usize).iter().chain([&v]) {
                let near = self.of_vertex[w as usize].iter();
                let mut near = near.filter(|other| **other <= index).peekable();
                if near.peek().is_none() {
                    continue;
                }
                let block = pattern.block(matrix, v, w);
                for &other in near {
                    let mode = self.mode(&self.pieces[other as usize], w, starts);
                    let target = entry(&mut forces, other, Default::default);
                    for ((i, a), (j, b)) in axes(v).flat_map(|a| axes(w).map(move |b| (a, b))) {
                        for (t, m) in target[a][b].iter_mut().zip(mode) {
                            *t += block[i][j] * m;
                        }
                    }
                }
            }
            let own = self.mode(piece, v, starts);
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

    /// The axis of an equation; the first for a motion that many nodes share.
    fn axis(&self, equation: u32) -> usize {
        self.places[equation as usize].map_or(0, |p| p.1)
    }

    /// The four functions of a piece at a vertex, times its weight there: the entries of Z.
    fn mode(&self, piece: &Piece, v: u32, starts: &[u32]) -> Mode {
        let share = 1.0 / self.of_vertex[v as usize].len() as f64;
        match self.places[starts[v as usize] as usize] {
            None => [share, 0.0, 0.0, 0.0],
            Some((point, _)) => {
                let scale = share / piece.radius;
                let form = |k: usize| scale * (point[k] - piece.centre[k]);
                [share, form(0), form(1), form(2)]
            }
        }
    }

    /// The coarse correction Z (Zᵀ A Z)⁻¹ Zᵀ r of a residual `r`.
    pub fn solve(&self, pattern: &Pattern, factor: &CoarseFactor, r: &[f64]) -> Vec<f64> {
        let starts = &pattern.vertex_start;
        let mut c: Vec<f64> = (self.pieces.par_iter())
            .flat_map_iter(|piece| {
                let mut sum = [0.0; MODES];
                for &v in &piece.vertices {
                    let mode = self.mode(piece, v, starts);
                    for e in starts[v as usize]..starts[v as usize + 1] {
                        let first = FORMS * self.axis(e);
                        for (s, m) in sum[first..first + FORMS].iter_mut().zip(mode) {
                            *s += m * r[e as usize];
                        }
                    }
                }
                sum
            })
            .collect();
        self.symbolic.solve(&factor.factor, &mut c);
        let values = (0..starts.len() - 1).into_par_iter().flat_map_iter(|v| {
            let pieces = &self.of_vertex[v];
            let modes: Vec<_> = (pieces.iter())
                .map(|i| (*i, self.mode(&self.pieces[*i as usize], v as u32, starts)))
                .collect();
            let c = &c;
            (starts[v]..starts[v + 1]).map(move |e| {
                let shares = modes.iter().map(|(i, mode)| {
                    let first = MODES * *i as usize + FORMS * self.axis(e);
                    let c = &c[first..first + FORMS];
                    c.iter().zip(mode).map(|(c, m)| c * m).sum::<f64>()
                });
                shares.sum()
            })
        });
        values.collect()
    }
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

impl Piece {
    /// The piece of `vertices`, whose points are given by `point`.
    fn new(vertices: &[u32], point: impl Fn(u32) -> Option<Vec3>) -> Self {
        let points: Vec<Vec3> = vertices.iter().filter_map(|v| point(*v)).collect();
        let count = points.len().max(1) as f64;
        let centre = [0, 1, 2].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / count);
        let square = |p: &Vec3| (0..3).map(|k| (p[k] - centre[k]).powi(2)).sum::<f64>();
        let radius = (points.iter().map(square).sum::<f64>() / count).sqrt();
        Self {
            vertices: vertices.to_vec(),
            centre,
            radius: if radius > 0.0 { radius } else { 1.0 },
        }
    }
}
