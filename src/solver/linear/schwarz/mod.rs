//! Two-level overlapping Schwarz preconditioner, for models too large for one factor.
//!
//! Vertices are split into small subdomains, each extended by one layer of neighbours (`partition`). Applied
//! to a residual r it makes two corrections, one after the other:
//!
//! ```text
//! x₀ = Z (Zᵀ A Z)⁻¹ Zᵀ r                      coarse: motions of second order of all pieces (`coarse`)
//! x  = x₀ + Σᵢ R̃ᵢᵀ Aᵢ⁻¹ Rᵢ (r − A x₀)          local: each subdomain by itself (`local`)
//! ```
//!
//! Rᵢ picks the unknowns of subdomain i with its overlap, Aᵢ = Rᵢ A Rᵢᵀ is its part of the matrix, and R̃ᵢᵀ puts back
//! only those that it owns: restricted additive Schwarz (Cai and Sarkis, SIAM J. Sci. Comput. 21 (1999)
//! 792). The theory is in Toselli and Widlund, *Domain Decomposition Methods*, 2005, chapters 2 and 3.
//!
//! The map from r to x is linear but not symmetric. Work and memory grow with the number of unknowns, and only
//! what has changed since the last matrix is factored anew.

mod coarse;
mod local;
mod partition;
mod place;
mod space;
#[cfg(test)]
mod tests;

use super::cholesky::{Factor, FactorError};
use super::sparse::{Pattern, SymmetricMatrix};
use coarse::Coarse;
use local::{Local, LocalFactor};
pub use place::Place;
use rayon::prelude::*;

/// Subdomains and their structure, found once a pattern.
pub struct Schwarz {
    locals: Vec<Local>,
    coarse: Coarse,
}

/// The factors of one matrix.
pub struct SchwarzFactor {
    locals: Vec<LocalFactor>,
    coarse: Factor<f64>,
    /// Diagonal of the matrix that each equation's subdomains were factored for.
    diagonal: Vec<f64>,
}

/// Fewest and most vertices of a subdomain before it is extended. Smaller ones cost less each, but more of
/// them make a larger coarse system.
const SUBDOMAIN_SIZES: (usize, usize) = (200, 600);
/// How many subdomains there are where that lets their sizes be between these.
const SUBDOMAINS: usize = 100;

/// A subdomain is factored anew where an entry of its diagonal has changed by more than this share: within it the
/// old factor still preconditions about as well.
const STALE_CHANGE: f64 = 0.05;

impl Schwarz {
    /// Splits the graph of `pattern` across its weak couplings in the `elastic` matrix, which is without
    /// contact. Equations that hang together in it belong to one body.
    ///
    /// # Errors
    /// [`FactorError::Memory`].
    pub fn new(
        pattern: &Pattern,
        elastic: &SymmetricMatrix,
        places: &[Place],
    ) -> Result<Self, FactorError> {
        let vertices = pattern.vertex_start.len() - 1;
        let size = (vertices / SUBDOMAINS).clamp(SUBDOMAIN_SIZES.0, SUBDOMAIN_SIZES.1);
        let division = partition::divide(pattern, elastic, places, size);
        let coarse = Coarse::new(pattern, elastic, places, &division)?;
        let locals = (division.subdomains.par_iter().enumerate())
            .map(|(index, vertices)| {
                let owns = |v: u32| division.owner[v as usize] == index as u32;
                Local::new(pattern, vertices, owns)
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { locals, coarse })
    }

    /// Factors `matrix`, which contact and flow have made of the `elastic` one; of `old` what still holds is kept.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or a subdomain is not positive definite.
    pub fn factorise(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        elastic: &SymmetricMatrix,
        old: Option<SchwarzFactor>,
    ) -> Result<SchwarzFactor, FactorError> {
        let diagonal = pattern.diagonal(matrix);
        let Some(mut old) = old else {
            let make = |local: &Local| local.factorise(pattern, matrix);
            return Ok(SchwarzFactor {
                locals: self.locals.par_iter().map(make).collect::<Result<_, _>>()?,
                coarse: self.coarse.factorise(pattern, matrix, elastic, None)?,
                diagonal,
            });
        };
        let changed: Vec<bool> = (diagonal.iter().zip(&old.diagonal))
            .map(|(now, then)| (now - then).abs() > STALE_CHANGE * now.abs().min(then.abs()))
            .collect();
        (self.locals.par_iter())
            .zip(&mut old.locals)
            .filter(|(local, _)| local.equations.iter().any(|e| changed[*e as usize]))
            .try_for_each(|(local, factor)| {
                *factor = local.factorise(pattern, matrix)?;
                Ok(())
            })?;
        // The coarse system gets every change: next to stiff contact what is little beside an entry of the diagonal
        // may be much beside the stiffness of a whole motion.
        let coarse = (self.coarse).factorise(pattern, matrix, elastic, Some(old.coarse))?;
        for ((then, now), changed) in old.diagonal.iter_mut().zip(&diagonal).zip(&changed) {
            if *changed {
                *then = *now;
            }
        }
        Ok(SchwarzFactor { coarse, ..old })
    }

    /// Replaces `x` by the preconditioned x; `multiply(x, y)` sets y = A x.
    pub fn apply(
        &self,
        pattern: &Pattern,
        factor: &SchwarzFactor,
        multiply: impl Fn(&[f64], &mut [f64]),
        x: &mut [f64],
    ) {
        let smooth = self.coarse.solve(pattern, &factor.coarse, x);
        let mut product = vec![0.0; x.len()];
        multiply(&smooth, &mut product);
        x.iter_mut().zip(&product).for_each(|(x, p)| *x -= p);
        let residual = &*x;
        let parts: Vec<Vec<f32>> = (self.locals.par_iter())
            .zip(&factor.locals)
            .map(|(local, factor)| local.solve(factor, residual))
            .collect();
        x.copy_from_slice(&smooth);
        for (local, part) in self.locals.iter().zip(parts) {
            let own = local.equations.iter().zip(&local.own).zip(part);
            for ((e, _), value) in own.filter(|((_, own), _)| **own) {
                x[*e as usize] += f64::from(value);
            }
        }
    }

    /// Entries of all factors.
    pub fn factor_entries(&self) -> usize {
        let locals = self.locals.iter().map(Local::factor_entries);
        locals.sum::<usize>() + self.coarse.factor_entries()
    }
}
