//! The parameters of a node's law: friction, penalties, stiffness.

use super::node::{Node, NodeResponse, Status};

/// What the law of a node depends on, the same in all iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// μ, Coulomb's coefficient, without unit.
    pub friction: f64,
    /// ε, stress per length,
    pub penalty: f64,
    /// and the most that it is raised to.
    pub firmest: f64,
    /// c, stress per length: the stiffness of the bodies at the node. It weighs a length d against
    /// a stress λ where the sets are decided.
    pub stiffness: f64,
}

/// ε_t of a cautious node over the stiffness c of the bodies, before it is raised. Also the steepest
/// that a slipping node's shear turns with its slip, over c.
const TANGENTIAL_PENALTY: f64 = 30.0;

/// The most powers of ten that ε_t is raised by.
pub const MOST_RAISED: u8 = 2;

impl Law {
    /// ε of a node, raised as it asks for.
    pub(super) fn penalty(&self, node: &Node) -> f64 {
        let raised = self.penalty * f64::powi(10.0, i32::from(node.firmer));
        raised.min(self.firmest)
    }

    /// ε_t of a cautious node, raised as it asks for.
    pub(super) fn tangential_penalty(&self, node: &Node) -> f64 {
        TANGENTIAL_PENALTY * self.stiffness * f64::powi(10.0, i32::from(node.raised))
    }

    /// μ p: the largest shear that friction bears under `traction`; none under tension.
    pub fn bound(&self, traction: &[f64; 3]) -> f64 {
        self.friction * traction[0].max(0.0)
    }

    /// What a traction of a node is known to, with d known to `closure`.
    pub fn rounding(&self, node: &Node, closure: f64) -> f64 {
        self.penalty(node) * closure
    }

    /// How far the shear of a cautious node still is from λ, as a length, whether it sticks or slips.
    pub(super) fn shear_missed(&self, node: &Node, answer: &NodeResponse) -> f64 {
        let miss = |i: usize| answer.traction[i] - node.multiplier[i];
        miss(1).hypot(miss(2)) / self.tangential_penalty(node)
    }

    /// How far λ still is from the traction, as a length: the closure, and where the node sticks also
    /// its elastic slip. Zero where the contact conditions hold.
    pub fn violation(&self, node: &Node, answer: &NodeResponse) -> f64 {
        /// A cautious node's elastic slip counts by this factor only: it moves no pressure.
        const SLIP_WEIGHT: f64 = 0.1;
        let miss = |i: usize| answer.traction[i] - node.multiplier[i];
        let closure = miss(0).abs() / self.penalty(node);
        if answer.status != Status::Stick {
            return closure;
        }
        closure.max(match node.cautious {
            true => SLIP_WEIGHT * self.shear_missed(node, answer),
            false => miss(1).hypot(miss(2)) / self.penalty(node),
        })
    }
}
