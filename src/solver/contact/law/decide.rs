//! Between iterations: which nodes are closed, stick or slip, and what their multipliers become.

use super::node::{Node, NodeResponse};
use super::parameters::{Law, MOST_RAISED};

impl Law {
    /// What decides whether a node is closed: it is where this is positive. The pressure of a closed node;
    /// of an open one the pressure c d that its overlap would make. By how much a closed node is off its
    /// gap says only how far λ was off, and decides nothing.
    pub fn presses(&self, node: &Node, traction: &[f64; 3], d: &[f64; 3]) -> f64 {
        match node.closed {
            true => traction[0],
            false => self.stiffness * d[0],
        }
    }

    /// What decides whether a node slips: by how much |λ + c d|, tangential, is beyond the `bound` μ p.
    pub fn beyond(&self, traction: &[f64; 3], d: &[f64; 3], bound: f64) -> f64 {
        let trial = [1, 2].map(|i| traction[i] + self.stiffness * d[i]);
        trial[0].hypot(trial[1]) - bound
    }

    /// The node after an iteration that ended with `traction` at d: its sets are decided anew, its
    /// multiplier takes the traction, its shear is bounded by `bound`.
    pub fn decide(&self, node: &Node, traction: &[f64; 3], d: &[f64; 3], bound: f64) -> Node {
        let [pressure, s, t] = *traction;
        if self.presses(node, traction, d) <= 0.0 {
            return Node {
                cautious: node.cautious,
                switches: node.switches,
                raised: node.raised,
                firmer: node.firmer,
                ..Node::default()
            };
        }
        let mut next = Node {
            closed: true,
            multiplier: [pressure, s, t],
            bound,
            cautious: node.cautious,
            switches: node.switches,
            raised: node.raised,
            firmer: node.firmer,
            missed: node.missed,
            ..Node::default()
        };
        if self.friction == 0.0 {
            return next;
        }
        if node.cautious {
            (next.multiplier[1], next.multiplier[2]) = (node.multiplier[1], node.multiplier[2]);
            return next;
        }
        // A node that has just closed may have moved far: it sticks only once it is known to.
        next.sticks = node.closed && self.beyond(traction, d, bound) <= 0.0;
        next.switches += u8::from(node.closed && next.sticks != node.sticks);
        if !next.sticks {
            self.linearise_slip(&mut next, [s, t], [d[1], d[2]]);
        }
        next
    }

    /// The multiplier of a closed cautious node takes the shear, which leaves the node without elastic
    /// slip. Where λ comes nearer too slowly, as under a pattern of shear that the bodies hardly give way
    /// to, or at a node that slips by next to nothing, ε_t is raised (a rule of Bertsekas, *Constrained
    /// Optimization and Lagrange Multiplier Methods*, 1982).
    pub fn take_shear(&self, node: &mut Node, answer: &NodeResponse) {
        /// What may be left of the distance after λ took the shear; with more left, ε_t is raised.
        const MOST_LEFT: f64 = 0.5;
        let missed = self.shear_missed(node, answer);
        if missed > MOST_LEFT * node.missed && node.missed > 0.0 && node.raised < MOST_RAISED {
            node.raised += 1;
        }
        node.missed = missed;
        (node.multiplier[1], node.multiplier[2]) = (answer.traction[1], answer.traction[2]);
    }
}
