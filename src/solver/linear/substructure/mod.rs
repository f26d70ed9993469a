//! Static condensation: a sparse matrix seen from a few kept unknowns.
//!
//! With the inner unknowns I eliminated and B kept, K x = f becomes S x_B = g with
//! S = K_BB − K_BI K_II⁻¹ K_IB and g = f_B − K_BI K_II⁻¹ f_I (Guyan 1965; Przemieniecki 1968).
//! A supernodal Cholesky factor with B last gives all of it: the trailing block L_BB is a factor
//! of S, and half a triangular solve is the reduction of f.

mod condensation;
mod reduced;

pub use condensation::Condensation;
pub use reduced::Substructure;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::linear::cholesky::Symbolic;
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

    #[test]
    fn the_condensed_system_has_the_answer_of_the_whole() {
        let (pattern, matrix) = chain(40);
        let f: Vec<f64> = (0..80).map(|i| f64::from(i).sin()).collect();
        let mut exact = f.clone();
        let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..40)]).unwrap();
        let factor = symbolic.factorise::<f64>(&pattern, &matrix, None).unwrap();
        symbolic.solve(&factor, &mut exact);

        let mut kept = vec![false; 40];
        for vertex in [3, 17, 39] {
            kept[vertex] = true;
        }
        let condensation = Condensation::new(&pattern, &kept).unwrap();
        assert_eq!(condensation.kept_equations(), [6, 7, 34, 35, 78, 79]);
        let (part, schur) = condensation.eliminate(&pattern, matrix).unwrap();
        let mut x = f;
        part.reduce(&mut x);
        let kept = part.condensation().kept_equations().to_vec();
        // S x_B = g with the exact x_B.
        for (i, row) in kept.iter().enumerate() {
            let product: f64 = kept
                .iter()
                .enumerate()
                .map(|(j, c)| schur[(i.max(j), i.min(j))] * exact[*c as usize])
                .sum();
            assert!((product - x[*row as usize]).abs() < 1e-11);
        }
        for equation in &kept {
            x[*equation as usize] = exact[*equation as usize];
        }
        part.recover(&mut x);
        assert!(x.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-11));
    }
}
