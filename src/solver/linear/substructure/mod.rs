//! Static condensation: a sparse matrix seen from a few kept unknowns.
//!
//! With the inner unknowns I eliminated and B kept, K x = f becomes S x_B = g with
//! S = K_BB − K_BI K_II⁻¹ K_IB and g = f_B − K_BI K_II⁻¹ f_I (Guyan 1965; Przemieniecki 1968).
//! A supernodal Cholesky factor that ends before B gives all of it: S is what is left there, and half a triangular solve
//! is the reduction of f.

mod condensation;
mod reduced;

pub use condensation::Condensation;
pub use reduced::Substructure;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::linear::cholesky::Symbolic;
    use crate::solver::linear::cholesky::tests::{held, plate, threads};
    use crate::solver::linear::ordering::Block;
    use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};

    /// A chain of vertices with two equations each, tied down at one end.
    fn chain(n: u32) -> (Pattern, SymmetricMatrix) {
        let cliques: Vec<Vec<u32>> = (0..n - 1).map(|i| vec![i, i + 1]).collect();
        let starts = (0..=n).map(|i| 2 * i).collect();
        let pattern = Pattern::new(starts, cliques.iter().map(Vec::as_slice));
        let mut m = pattern.zeros();
        for c in &cliques {
            let equations = [2 * c[0], 2 * c[0] + 1, 2 * c[1], 2 * c[1] + 1];
            let k = [
                [2.0, 0.5, -2.0, -0.5],
                [0.5, 3.0, -0.5, -3.0],
                [-2.0, -0.5, 2.0, 0.5],
                [-0.5, -3.0, 0.5, 3.0],
            ];
            pattern.add_block(&mut m, &equations, |i, j| k[i][j]);
        }
        pattern.add_block(&mut m, &[0, 1], |i, j| if i == j { 1.0 } else { 0.0 });
        (pattern, m)
    }

    /// Condenses onto the vertices marked in `kept`, and compares what comes out of S, of reduction and of recovery with
    /// the solution of the whole.
    fn check(pattern: &Pattern, matrix: &SymmetricMatrix, kept: &[bool]) {
        let vertices = kept.len() as u32;
        let f: Vec<f64> = (0..pattern.len()).map(|i| (i as f64).sin()).collect();
        let mut exact = f.clone();
        let symbolic = Symbolic::new(pattern, &[Block::Sparse(0..vertices)]).unwrap();
        let factor = symbolic.factorise::<f64>(pattern, matrix, None).unwrap();
        symbolic.solve(&factor, &mut exact);
        let condensation = Condensation::new(pattern, kept).unwrap();
        let (part, schur) = condensation.eliminate(pattern, matrix).unwrap();
        let mut x = f;
        part.reduce(&mut x);
        let kept = part.condensation().kept_equations().to_vec();
        // S x_B = g with the exact x_B.
        for (i, row) in kept.iter().enumerate() {
            let entry = |j: usize| schur[i.max(j) + kept.len() * i.min(j)];
            let columns = kept.iter().enumerate();
            let product: f64 = columns.map(|(j, c)| entry(j) * exact[*c as usize]).sum();
            assert!((product - x[*row as usize]).abs() < 1e-10);
        }
        for equation in &kept {
            x[*equation as usize] = exact[*equation as usize];
        }
        part.recover(&mut x);
        assert!(x.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-10));
    }

    #[test]
    fn the_condensed_system_has_the_answer_of_the_whole() {
        let (pattern, matrix) = chain(40);
        let kept: Vec<bool> = (0..40).map(|v| [3, 17, 39].contains(&v)).collect();
        let condensation = Condensation::new(&pattern, &kept).unwrap();
        assert_eq!(condensation.kept_equations(), [6, 7, 34, 35, 78, 79]);
        check(&pattern, &matrix, &kept);
    }

    /// Elimination ends between supernodes, within one, before the first and after the last.
    #[test]
    fn any_vertices_may_be_kept_on_any_number_of_threads() {
        let (pattern, matrix) = plate(12, held);
        let edge = |v: usize| v < 12;
        let scattered = |v: usize| v % 7 == 3;
        let corner = |v: usize| v == 143;
        let half = |v: usize| v % 12 < 6;
        let marks: [&dyn Fn(usize) -> bool; 6] =
            [&edge, &scattered, &corner, &half, &|_| true, &|_| false];
        for mark in marks {
            let kept: Vec<bool> = (0..144).map(mark).collect();
            for count in 1..=3 {
                threads(count, || check(&pattern, &matrix, &kept));
            }
        }
    }

    /// What floats has no stiffness against a motion as a whole, seen from a few nodes as well.
    #[test]
    fn the_stiffness_of_what_floats_is_singular() {
        let loose = |i: usize, j: usize| match (i == j, i % 3 == j % 3) {
            (true, _) => 1.0,
            (false, true) => -1.0,
            _ => 0.0,
        };
        let (pattern, matrix) = plate(10, loose);
        let kept: Vec<bool> = (0..100).map(|v| v % 9 == 0).collect();
        let condensation = Condensation::new(&pattern, &kept).unwrap();
        let (part, schur) = condensation.eliminate(&pattern, &matrix).unwrap();
        let count = part.condensation().kept();
        for row in 0..count {
            let along = (row % 3..count).step_by(3);
            let sum: f64 = along
                .map(|column| schur[row.max(column) + count * row.min(column)])
                .sum();
            assert!(sum.abs() < 1e-13, "{sum:.1e}");
        }
    }
}
