//! A symmetric system of half bandwidth two.

/// Symmetric matrix of half bandwidth two: its diagonal and the two below, and a right side.
pub(super) struct Banded {
    pub diagonals: [Vec<f64>; 3],
    pub right: Vec<f64>,
}

impl Banded {
    /// Of `size` unknowns, all zero.
    pub fn new(size: usize) -> Self {
        Self {
            diagonals: [0, 1, 2].map(|_| vec![0.0; size]),
            right: vec![0.0; size],
        }
    }

    /// LDLᵀ and substitution.
    pub fn solve(self) -> Vec<f64> {
        let Self {
            diagonals: [mut d, mut l1, mut l2],
            right: mut x,
        } = self;
        let size = x.len();
        for i in 0..size {
            let (below, next) = (l1[i], l2[i]);
            (l1[i], l2[i]) = (below / d[i], next / d[i]);
            if i + 1 < size {
                d[i + 1] -= l1[i] * below;
                l1[i + 1] -= l1[i] * next;
                x[i + 1] -= l1[i] * x[i];
            }
            if i + 2 < size {
                d[i + 2] -= l2[i] * next;
                x[i + 2] -= l2[i] * x[i];
            }
        }
        for i in (0..size).rev() {
            x[i] /= d[i];
            if i + 1 < size {
                x[i] -= l1[i] * x[i + 1];
            }
            if i + 2 < size {
                x[i] -= l2[i] * x[i + 2];
            }
        }
        x
    }
}
