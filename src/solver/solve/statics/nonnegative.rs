//! Least squares with unknowns that are not negative.
//!
//! The active-set method of Lawson and Hanson, *Solving Least Squares Problems* (1974), chapter 23.

use crate::solver::solve::params::{NONNEGATIVE_ROUNDING, NONNEGATIVE_ROUNDS};
use nalgebra::{DMatrix, DVector};

/// The nearest to balance that contact can come.
pub struct Nearest {
    /// Contact forces, by edge of a cone.
    pub forces: Vec<(usize, f64)>,
    /// What is left of the load.
    pub left: DVector<f64>,
}

/// Forces on `edges`, none negative, whose sum is nearest to `load`; `None` where rounding hinders it.
pub fn nearest(edges: &[DVector<f64>], load: &DVector<f64>) -> Option<Nearest> {
    let mut forces: Vec<(usize, f64)> = Vec::new();
    let mut left = load.clone();
    let solve = |chosen: &[(usize, f64)]| {
        let columns: Vec<_> = chosen
            .iter()
            .map(|(edge, _)| edges[*edge].clone())
            .collect();
        let svd = DMatrix::from_columns(&columns).svd(true, true);
        svd.solve(load, NONNEGATIVE_ROUNDING).ok()
    };
    for _ in 0..NONNEGATIVE_ROUNDS {
        let gains = edges.iter().map(|edge| left.dot(edge) / edge.norm());
        let best = gains
            .enumerate()
            .filter(|(edge, gain)| gain.is_finite() && forces.iter().all(|(e, _)| e != edge))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((edge, _)) = best.filter(|(_, gain)| *gain > 1e-10 * load.norm()) else {
            return Some(Nearest { forces, left });
        };
        forces.push((edge, 0.0));
        // Back to where no force is negative.
        loop {
            let wanted = solve(&forces)?;
            let blocked = |((_, now), then): (&(usize, f64), &f64)| {
                (*then <= 0.0).then(|| now / (now - then).max(f64::MIN_POSITIVE))
            };
            let share = forces.iter().zip(wanted.iter()).filter_map(blocked);
            let share = share.fold(1.0, f64::min);
            for ((_, now), then) in forces.iter_mut().zip(wanted.iter()) {
                *now += share * (then - *now);
            }
            if share >= 1.0 {
                break;
            }
            let most = forces.iter().fold(0.0f64, |most, f| most.max(f.1));
            forces.retain(|(_, force)| *force > NONNEGATIVE_ROUNDING * most);
            if forces.is_empty() {
                break;
            }
        }
        let before = left.norm();
        left = load.clone();
        for (edge, force) in &forces {
            left -= *force * &edges[*edge];
        }
        // Rounding is all that is gained.
        if left.norm() >= (1.0 - NONNEGATIVE_ROUNDING) * before {
            return Some(Nearest { forces, left });
        }
    }
    None
}
