//! The shear of a slipping node, linearised.

use super::node::Node;
use super::parameters::Law;

impl Law {
    /// Sets the linearised shear of a slipping node, λ + `slope` (d − `origin`), from the `shear` and d of now.
    ///
    /// Wanted is λ with |λ + c d| λ = μ p (λ + c d): the shear has the size μ p and the direction of
    /// λ + c d. With
    ///
    /// ```text
    /// b = |λ + c d|                 size of the trial shear; more than μ p where the node slips on
    /// n = (λ + c d) / b             its direction
    /// a = λ · n, within 0 and μ p   what λ already has along n
    /// ```
    ///
    /// Newton's linearisation, without its unsymmetric parts, makes the slope
    ///
    /// ```text
    /// across n:  c μ p / (b − μ p)               the shear turns with the slip
    /// along n:   c (μ p − a) / (b − μ p + a)     the shear grows until a = μ p
    /// ```
    ///
    /// A node that slips steadily has a = μ p and b − μ p = c |d|: its shear turns by μ p / |d| and grows
    /// no more. Where b hardly exceeds μ p, the slope across is cut off at ε_t.
    ///
    /// A slip along n alone makes the shear μ p n: that is λ here, and the slip along n of now is the origin. (λ of now, cut
    /// off at μ p, asks a node that hardly slips for a slip across that it cannot have.)
    ///
    /// λ is the shear cut off at μ p. A node whose shear was far larger may stick by that though it slips: there λ is the
    /// shear itself, or the shear would turn against a slope as steep as ε_t, by next to nothing in each iteration.
    pub(super) fn linearise_slip(&self, node: &mut Node, shear: [f64; 2], d: [f64; 2]) {
        let (c, bound) = (self.stiffness, node.bound);
        let size = shear[0].hypot(shear[1]);
        let old = match size > bound {
            true => shear.map(|s| bound / size * s),
            false => shear,
        };
        let trial = |shear: [f64; 2]| {
            let trial = [0, 1].map(|i| shear[i] + c * d[i]);
            (trial, trial[0].hypot(trial[1]))
        };
        let slips = |(_, b): &([f64; 2], f64)| *b >= bound;
        let (trial, b) = Some(trial(old))
            .filter(slips)
            .unwrap_or_else(|| trial(shear));
        if b == 0.0 {
            (node.multiplier[1], node.multiplier[2]) = (0.0, 0.0);
            return;
        }
        let n = trial.map(|v| v / b);
        // b − μ p, but no less than makes the slope across ε_t.
        let excess = (b - bound).max(bound * c / self.tangential_penalty(node));
        let along = (old[0] * n[0] + old[1] * n[1]).clamp(0.0, bound);
        let slip_along = d[0] * n[0] + d[1] * n[1];
        let across = bound * c / excess;
        let forward = c * (bound - along) / (excess + along).max(f64::MIN_POSITIVE);
        node.origin = n.map(|n| slip_along * n);
        for i in 0..2 {
            node.multiplier[1 + i] = bound * n[i];
            for j in 0..2 {
                let nn = n[i] * n[j];
                node.slope[i][j] = across * (f64::from(u8::from(i == j)) - nn) + forward * nn;
            }
        }
    }
}
