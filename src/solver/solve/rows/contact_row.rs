//! One contact condition: the weighted gap of a carrier node with its law.
//!
//! The operator C of a row takes nodal displacements u to the relative displacement of the two sides,
//! d = Σ_A C_A u_A, weighted with the shape function of the row's node (mortar integrals, see
//! [`crate::solver::contact::mortar`]). Local components are (normal, first tangent, second tangent).

use crate::ground::geometry::dot;
use crate::model::scene::ContactPair;
use crate::solver::contact::law::Law;
use crate::solver::contact::mortar::Row;
use crate::solver::fem::dofs::{DofMap, FIXED};
use crate::solver::solve::params::{
    CONTACT_PENALTY, DIVIDED_CONTACT_PENALTY, SOFTEST_PENALTY, STIFFEST_PENALTY,
};

/// A contact row with its pair's law.
pub struct ContactRow {
    /// Weighted gap, area, normal, tangents, and the terms C_A.
    pub row: Row,
    /// Index of its pair in the scene.
    pub pair: usize,
    /// How it presses and rubs.
    pub law: Law,
}

/// The law of a row beside which the bodies have the given stiffness; `soft` where corrections are not exact.
pub fn law(pair: &ContactPair, stiffness: f64, soft: bool) -> Law {
    let soft = soft && pair.friction > 0.0;
    let automatic = if soft {
        DIVIDED_CONTACT_PENALTY
    } else {
        CONTACT_PENALTY
    };
    let wanted = (automatic * pair.penalty_factor).clamp(SOFTEST_PENALTY, STIFFEST_PENALTY);
    Law {
        friction: pair.friction,
        penalty: wanted * stiffness,
        firmest: wanted.max(automatic) * stiffness,
        stiffness,
    }
}

impl ContactRow {
    /// Local components (normal, two tangents) as a vector.
    pub fn global(&self, local: &[f64; 3]) -> [f64; 3] {
        let pressure = self.row.normal.map(|n| local[0] * n);
        let Some([s, t]) = self.row.tangents else {
            return pressure;
        };
        std::array::from_fn(|i| pressure[i] + local[1] * s[i] + local[2] * t[i])
    }

    /// Relative displacement of the two sides at the row, in local components; without friction
    /// only the first is sought.
    pub fn relative(&self, u: &[[f64; 3]]) -> [f64; 3] {
        self.relative_of(|node, axis| u[node][axis])
    }

    /// The same of the displacement that `u` has for a node and an axis.
    pub fn relative_of(&self, u: impl Fn(usize, usize) -> f64) -> [f64; 3] {
        let mut d = [0.0; 3];
        for (node, coefficient) in &self.row.terms {
            for axis in 0..3 {
                d[axis] += coefficient[axis] * u(*node as usize, axis);
            }
        }
        self.local(d)
    }

    /// What turns of rigid planes do to the relative displacement: equation, axis, share.
    pub fn further(&self, dofs: &DofMap) -> Vec<(u32, usize, f64)> {
        let terms = self.row.terms.iter().flat_map(|(node, coefficient)| {
            let further = dofs.further_of(*node).iter();
            further.map(|f| (f.equation, f.axis, coefficient[f.axis] * f.lever))
        });
        terms.filter(|(equation, ..)| *equation != FIXED).collect()
    }

    /// A vector in local components (normal, two tangents).
    pub fn local(&self, d: [f64; 3]) -> [f64; 3] {
        let [s, t] = (self.row.tangents).map_or([0.0; 2], |tangents| tangents.map(|t| dot(d, t)));
        [dot(d, self.row.normal), s, t]
    }
}
