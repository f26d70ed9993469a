//! Krylov methods that keep all their directions: conjugate residuals and conjugate directions.
//!
//! Every matrix that comes here is symmetric, that of a frictional contact too (see
//! [`contact::law`](crate::solver::contact::law)). Preconditioners need not be: an aged factor
//! that is brought up to date for contact, a factor in single precision or restricted Schwarz is none, or is
//! not quite the same linear map each time. So nothing is built on symmetry by short recurrences. Each new
//! direction is made orthogonal to all before it, which also keeps rounding out; directions are few.

use rayon::prelude::*;

/// How a solve went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KrylovOutcome {
    /// Directions tried.
    pub iterations: usize,
    /// Norm of the residual relative to that of the right-hand side.
    pub residual: f64,
}

/// Solves A x = b by generalised conjugate residuals (GCR; Eisenstat, Elman and Schultz, SIAM J. Numer.
/// Anal. 20 (1983) 345). `multiply(x, y)` sets y = A x; `precondition(x)` replaces x by M⁻¹x.
///
/// It minimises the residual |b − A x| over the directions tried so far. A need not be symmetric. With a factor
/// of A itself as preconditioner it ends after one direction, with one that has aged after a few more.
///
/// Stops at `tolerance` (relative to |b|) or after `limit` directions; returns the best x.
pub fn solve(
    mut multiply: impl FnMut(&[f64], &mut [f64]),
    mut precondition: impl FnMut(&mut [f64]),
    b: &[f64],
    tolerance: f64,
    limit: usize,
) -> (Vec<f64>, KrylovOutcome) {
    let scale = norm(b);
    let mut x = vec![0.0; b.len()];
    let mut outcome = KrylovOutcome {
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
/// Minimises the energy of the error, ½ eᵀ A e with e = A⁻¹ b − x, over the directions tried so far
/// (flexible conjugate gradients with all directions kept; Notay, SIAM J. Sci. Comput. 22 (2000) 1444).
///
/// A residual says little where a stiff contact makes the largest forces and soft motions make the largest
/// errors. Here the energy that the last few directions gained tells how much energy the error still has
/// (Hestenes and Stiefel, J. Res. NBS 49 (1952) 409, theorem 6:1). Stops where that estimate of the error
/// in the energy norm, √(eᵀ A e), is below `tolerance` times that of x, or the residual is below
/// `floor`, or after `limit` directions. `KrylovOutcome::residual` is that of the end, relative to |b|.
pub fn minimise(
    multiply: impl Fn(&[f64], &mut [f64]),
    precondition: impl Fn(&mut [f64]),
    b: &[f64],
    tolerance: f64,
    floor: f64,
    limit: usize,
) -> (Vec<f64>, KrylovOutcome) {
    /// The gain of so many last directions stands for what is still to be gained: one alone may gain little by
    /// chance.
    const DELAY: usize = 4;
    let scale = norm(b);
    let mut x = vec![0.0; b.len()];
    let mut outcome = KrylovOutcome {
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

/// Entries of a vector that are worth a task of their own. Sums are cut here whatever the number of threads, so
/// that they come out the same on any.
const CHUNK: usize = 1 << 14;

/// Scalar product, the same on any number of threads.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let of = |(a, b): (&[f64], &[f64])| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    if a.len() <= CHUNK {
        return of((a, b));
    }
    let shares: Vec<f64> = a
        .par_chunks(CHUNK)
        .zip(b.par_chunks(CHUNK))
        .map(of)
        .collect();
    shares.iter().sum()
}

/// Euclidean norm.
pub fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

fn add_scaled(y: &mut [f64], factor: f64, x: &[f64]) {
    (y.par_chunks_mut(CHUNK).zip(x.par_chunks(CHUNK))).for_each(|(y, x)| {
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
