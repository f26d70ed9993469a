//! Vectors between all unknowns and the kept ones: reduction of forces and recovery of displacements.

use crate::solver::linear::substructure::Substructure;
use crate::solver::solve::condensed::static_condensation::CondensedBodies;
use rayon::prelude::*;

impl CondensedBodies {
    /// Eliminates inner unknowns from a vector of forces.
    pub fn reduce(&self, forces: &mut [f64]) {
        self.locally(forces, Substructure::reduce);
    }

    /// Kept entries of a vector.
    pub fn restrict(&self, full: &[f64]) -> Vec<f64> {
        self.kept.iter().map(|e| full[*e as usize]).collect()
    }

    /// All unknowns from the kept ones and the reduced forces, in place of the latter.
    pub fn recover(&self, x: &[f64], reduced: &mut [f64]) {
        for (equation, value) in self.kept.iter().zip(x) {
            reduced[*equation as usize] = *value;
        }
        self.locally(reduced, Substructure::recover);
    }

    fn locally(&self, vector: &mut [f64], work: fn(&Substructure, &mut [f64])) {
        let done: Vec<Vec<f64>> = self
            .parts
            .par_iter()
            .map(|part| {
                let entries = part.equations.iter().map(|e| vector[*e as usize]);
                let mut local: Vec<f64> = entries.collect();
                work(&part.substructure, &mut local);
                local
            })
            .collect();
        for (part, local) in self.parts.iter().zip(done) {
            for (equation, value) in part.equations.iter().zip(local) {
                vector[*equation as usize] = value;
            }
        }
    }
}
