//! Cholesky factors of matrices small enough for the stack.

/// The factor L of a symmetric positive definite matrix, A = L Lᵀ.
#[derive(Debug, Clone, Copy)]
pub struct SmallCholesky<const N: usize> {
    lower: [[f64; N]; N],
}

impl<const N: usize> SmallCholesky<N> {
    /// Factors the matrix whose lower triangle is given; `None` where it is not positive definite.
    pub fn new(mut lower: [[f64; N]; N]) -> Option<Self> {
        for j in 0..N {
            for i in j..N {
                let mut sum = lower[i][j];
                for k in 0..j {
                    sum -= lower[i][k] * lower[j][k];
                }
                if i > j {
                    lower[i][j] = sum / lower[j][j];
                } else if sum > 0.0 && sum.is_finite() {
                    lower[j][j] = sum.sqrt();
                } else {
                    return None;
                }
            }
        }
        Some(Self { lower })
    }

    /// Replaces b by A⁻¹ b.
    pub fn solve(&self, b: &mut [f64; N]) {
        let l = &self.lower;
        for i in 0..N {
            for k in 0..i {
                b[i] -= l[i][k] * b[k];
            }
            b[i] /= l[i][i];
        }
        for i in (0..N).rev() {
            for k in i + 1..N {
                b[i] -= l[k][i] * b[k];
            }
            b[i] /= l[i][i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_small_system() {
        let a = [[4.0, 0.0, 0.0], [2.0, 5.0, 0.0], [1.0, -1.0, 3.0]];
        let x = [1.0, -2.0, 0.5];
        let full = |i: usize, j: usize| if i >= j { a[i][j] } else { a[j][i] };
        let mut b: [f64; 3] =
            std::array::from_fn(|i| (0..3).map(|j| full(i, j) * x[j]).sum::<f64>());
        SmallCholesky::new(a)
            .expect("positive definite")
            .solve(&mut b);
        for (found, exact) in b.iter().zip(x) {
            assert!((found - exact).abs() < 1e-14);
        }
    }

    #[test]
    fn an_indefinite_matrix_is_refused() {
        assert!(SmallCholesky::new([[1.0, 0.0], [2.0, 1.0]]).is_none());
    }
}
