//! The motions of the coarse level: the columns of Z, piece by piece.

use super::partition::Division;
use super::place::Place;
use crate::ground::geometry::Vec3;
use crate::ground::order::ascending;
use crate::solver::linear::sparse::Pattern;
use rayon::prelude::*;

/// Functions that each displacement component of a piece is made of: 1, ξ, η, ζ and their products of two.
pub(super) const FORMS: usize = 10;
/// Coarse unknowns of a piece.
pub(super) const MODES: usize = 3 * FORMS;
/// Values of these functions at a vertex, times the piece's weight there.
pub(super) type Mode = [f64; FORMS];

/// One body within one subdomain, overlap included.
pub(super) struct Piece {
    pub vertices: Vec<u32>,
    /// Mean of its points.
    centre: Vec3,
    /// Root mean square of their distances from it, so that all modes have about the same size.
    radius: f64,
}

/// The pieces and the modes that they have.
pub(super) struct Space {
    pub pieces: Vec<Piece>,
    /// Pieces that each vertex belongs to.
    pub of_vertex: Vec<Vec<u32>>,
    places: Vec<Place>,
}

impl Space {
    /// The pieces of a `division` of the vertices of `pattern`, whose equations are at `places`.
    pub fn new(pattern: &Pattern, places: &[Place], division: &Division) -> Self {
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
        Self {
            pieces,
            of_vertex,
            places: places.to_vec(),
        }
    }

    /// Pairs of pieces that couple: where a vertex of one is a neighbour of a vertex of the other.
    pub fn coupled(&self, pattern: &Pattern) -> Vec<[u32; 2]> {
        (self.pieces.par_iter().enumerate())
            .flat_map_iter(|(index, piece)| {
                let near = (piece.vertices.iter())
                    .flat_map(|v| pattern.neighbours(*v as usize))
                    .flat_map(|v| &self.of_vertex[*v as usize]);
                ascending(near.copied())
                    .into_iter()
                    .map(move |other| [index as u32, other])
            })
            .filter(|pair| pair[0] != pair[1])
            .collect()
    }

    /// The axis of an equation; the first for a motion that many nodes share.
    pub fn axis(&self, equation: u32) -> usize {
        self.places[equation as usize].map_or(0, |p| p.1)
    }

    /// The functions of a piece at a vertex, times its weight there: the entries of Z.
    #[inline]
    pub fn mode(&self, piece: &Piece, v: u32, starts: &[u32]) -> Mode {
        let share = 1.0 / self.of_vertex[v as usize].len() as f64;
        match self.places[starts[v as usize] as usize] {
            None => std::array::from_fn(|form| if form == 0 { share } else { 0.0 }),
            Some((point, _)) => {
                let [x, y, z] = [0, 1, 2].map(|k| (point[k] - piece.centre[k]) / piece.radius);
                let forms = [1.0, x, y, z, x * x, y * y, z * z, x * y, y * z, z * x];
                forms.map(|form| share * form)
            }
        }
    }

    /// Zᵀ r: what a residual does on each mode.
    pub fn restrict(&self, pattern: &Pattern, r: &[f64]) -> Vec<f64> {
        let starts = &pattern.vertex_start;
        (self.pieces.par_iter())
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
            .collect()
    }

    /// Z c: the motion that the coefficients c of the modes make.
    pub fn prolong(&self, pattern: &Pattern, c: &[f64]) -> Vec<f64> {
        let starts = &pattern.vertex_start;
        let values = (0..starts.len() - 1).into_par_iter().flat_map_iter(|v| {
            let pieces = &self.of_vertex[v];
            let modes: Vec<_> = (pieces.iter())
                .map(|i| (*i, self.mode(&self.pieces[*i as usize], v as u32, starts)))
                .collect();
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
