//! Generalised conjugate residuals (GCR) for symmetric and unsymmetric systems.
//!
//! Minimises the true residual over the directions tried so far (Eisenstat, Elman, Schultz
//! 1983). With the current factor as preconditioner it ends after one direction; with a factor
//! that has aged, or where friction makes the tangent unsymmetric, after a few more.

use rayon::prelude::*;

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

/// Solves A x = b for positive definite A by conjugate directions with any preconditioner.
///
/// Minimises the energy of the error, ½ eᵀ A e, over the directions tried so far (flexible conjugate
/// gradients, Notay 2000, with all directions kept). A residual says little where a stiff contact
/// makes the largest forces and soft motions the largest errors: here the energy that the last few
/// directions gained says how far the solution is (Hestenes and Stiefel 1952). Stops where that
/// estimate of the error, as a share of x in the energy norm, is below `tolerance`, or the residual
/// below `floor`; `Outcome::residual` is that of the end, relative to |b|.
pub fn minimise(
    multiply: impl Fn(&[f64], &mut [f64]),
    precondition: impl Fn(&mut [f64]),
    b: &[f64],
    tolerance: f64,
    floor: f64,
    limit: usize,
) -> (Vec<f64>, Outcome) {
    /// Directions whose gain stands for what is still to be gained.
    const DELAY: usize = 4;
    let scale = norm(b);
    let mut x = vec![0.0; b.len()];
    let mut outcome = Outcome {
        iterations: 0,
        residual: if scale == 0.0 { 0.0 } else { 1.0 },
    };
    let mut residual = b.to_vec();
    let mut directions: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
    let (mut gains, mut total): (Vec<f64>, f64) = (Vec::new(), 0.0);
    while outcome.iterations < limit && outcome.residual > floor {
        let recent: f64 = gains.iter().rev().take(DELAY).sum();
        if gains.len() >= DELAY && recent <= tolerance * tolerance * total {
            break;
        }
        outcome.iterations += 1;
        let mut p = residual.clone();
        precondition(&mut p);
        let mut q = vec![0.0; b.len()];
        multiply(&p, &mut q);
        for (old_p, old_q) in &directions {
            let share = dot(old_p, &q);
            add_scaled(&mut q, -share, old_q);
            add_scaled(&mut p, -share, old_p);
        }
        let energy = dot(&p, &q);
        if !(energy > 0.0) {
            break;
        }
        let length = energy.sqrt();
        p.par_iter_mut().for_each(|v| *v /= length);
        q.par_iter_mut().for_each(|v| *v /= length);
        let step = dot(&residual, &p);
        add_scaled(&mut x, step, &p);
        add_scaled(&mut residual, -step, &q);
        outcome.residual = norm(&residual) / scale;
        gains.push(step * step);
        total += step * step;
        directions.push((p, q));
    }
    (x, outcome)
}

/// Entries that are worth a thread; sums come out the same on any number of threads.
const SHARE: usize = 1 << 14;

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let of = |(a, b): (&[f64], &[f64])| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    if a.len() <= SHARE {
        return of((a, b));
    }
    let shares: Vec<f64> = a
        .par_chunks(SHARE)
        .zip(b.par_chunks(SHARE))
        .map(of)
        .collect();
    shares.iter().sum()
}

pub fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

fn add_scaled(y: &mut [f64], factor: f64, x: &[f64]) {
    (y.par_chunks_mut(SHARE).zip(x.par_chunks(SHARE))).for_each(|(y, x)| {
        for (y, x) in y.iter_mut().zip(x) {
            *y += factor * x;
        }
    });
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
