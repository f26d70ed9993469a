//! Generalised conjugate residuals (GCR) for symmetric and unsymmetric systems.
//!
//! Minimises the true residual over the directions tried so far (Eisenstat, Elman, Schultz
//! 1983). With the current factor as preconditioner it ends after one direction; with a factor
//! that has aged, or where friction makes the tangent unsymmetric, after a few more.

/// How a solve went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    pub iterations: usize,
    /// Norm of the residual relative to that of the right-hand side.
    pub residual: f64,
}

/// Solves A x = b. `multiply(x, y)` sets y = A x; `precondition(x)` replaces x by M⁻¹x.
///
/// Stops at `tolerance` (relative to |b|) or after `limit` directions; returns the best x.
pub fn solve(
    mut multiply: impl FnMut(&[f64], &mut [f64]),
    mut precondition: impl FnMut(&mut [f64]),
    b: &[f64],
    tolerance: f64,
    limit: usize,
) -> (Vec<f64>, Outcome) {
    let scale = norm(b);
    let mut x = vec![0.0; b.len()];
    let mut outcome = Outcome {
        iterations: 0,
        residual: 0.0,
    };
    if scale == 0.0 {
        return (x, outcome);
    }
    let mut residual = b.to_vec();
    let mut directions: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
    outcome.residual = 1.0;
    while outcome.iterations < limit && outcome.residual > tolerance {
        outcome.iterations += 1;
        let mut p = residual.clone();
        precondition(&mut p);
        let mut q = vec![0.0; b.len()];
        multiply(&p, &mut q);
        for (old_p, old_q) in &directions {
            let share = dot(old_q, &q);
            add_scaled(&mut q, -share, old_q);
            add_scaled(&mut p, -share, old_p);
        }
        let length = norm(&q);
        if length.is_nan() || length <= f64::MIN_POSITIVE {
            break;
        }
        p.iter_mut().for_each(|v| *v /= length);
        q.iter_mut().for_each(|v| *v /= length);
        let step = dot(&residual, &q);
        add_scaled(&mut x, step, &p);
        add_scaled(&mut residual, -step, &q);
        outcome.residual = norm(&residual) / scale;
        directions.push((p, q));
    }
    (x, outcome)
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

fn add_scaled(y: &mut [f64], factor: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unsymmetric_system_is_solved_with_a_rough_preconditioner() {
        let n = 30;
        let row = |i: usize, j: usize| match j as isize - i as isize {
            0 => 3.0,
            1 => -1.5,
            -1 => -0.5,
            _ => 0.0,
        };
        let multiply = |x: &[f64], y: &mut [f64]| {
            for (i, y) in y.iter_mut().enumerate() {
                *y = (0..n).map(|j| row(i, j) * x[j]).sum();
            }
        };
        let exact: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
        let mut b = vec![0.0; n];
        multiply(&exact, &mut b);
        let halve = |x: &mut [f64]| x.iter_mut().for_each(|v| *v /= 3.0);
        let (x, outcome) = solve(multiply, halve, &b, 1e-12, 30);
        assert!(outcome.residual <= 1e-12, "{outcome:?}");
        assert!(x.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-11));
    }
}
