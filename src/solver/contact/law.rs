//! Unilateral contact with Coulomb friction at one carrier node.
//!
//! *Normal*: a primal-dual active set (Hüeber and Wohlmuth 2005). Within an iteration a closed
//! node carries the augmented-Lagrange pressure λ + ε d in compression *or* tension, an open one
//! nothing; between iterations λ takes the pressure and the set is decided anew. When the set and λ
//! rest, the contact conditions hold exactly, whatever the penalty ε.
//!
//! *Tangential*: the same with stick and slip (Hüeber, Stadler and Wohlmuth 2008). Within an
//! iteration a sticking node carries λ + ε d, whatever Coulomb says; a slipping one carries Newton's
//! linearisation of
//! ```text
//! |λ + c d| λ = μ p (λ + c d)
//! ```
//! about where it stood, with p of the iteration before (in equal steels pressure hardly feels shear
//! at all, and the bound settles quickly) and without what would make the tangent unsymmetric or
//! indefinite. As the shear turns with λ, not with d alone, a node that moves back within an
//! iteration does not throw its shear about. Between iterations a node sticks where |λ + c d| is
//! within the bound, and slips otherwise.
//!
//! Where these sets do not settle, at a node between stick and slip or under a body that only
//! friction holds, nodes are treated with *caution*: radial return of λ + ε_t d onto the disc of
//! radius μ p with a soft ε_t, stick and slip within one iteration, so that a line search always
//! finds its way (Simo and Laursen 1992); λ takes the shear only when all is in balance.
//!
//! Components everywhere: normal (compression positive), two tangents. d is the closure beyond
//! the gap and the slip since the last increment.

use serde::{Deserialize, Serialize};

/// State of a carrier node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Status {
    #[default]
    Open,
    Stick,
    /// Sliding; without friction every closed node does.
    Slip,
}

/// What a node's law depends on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Coulomb's coefficient.
    pub friction: f64,
    /// ε, traction per closure and per slip of a sticking node,
    pub penalty: f64,
    /// and the most that it is raised to.
    pub firmest: f64,
    /// c, weight of d against λ where the sets are decided: the stiffness of the bodies there.
    pub stiffness: f64,
}

/// What changes from iteration to iteration at a node.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Node {
    pub closed: bool,
    pub sticks: bool,
    /// λ: pressure and shear.
    pub multiplier: [f64; 3],
    /// Largest shear traction, μ p of the iteration before.
    pub bound: f64,
    /// A slipping node's shear is λ + `slope` (d − `origin`), tangential.
    pub origin: [f64; 2],
    pub slope: [[f64; 2]; 2],
    /// Radial return in place of sets?
    pub cautious: bool,
    /// How often it changed between stick and slip in this increment.
    pub switches: u8,
    /// By how many powers of ten ε_t has been raised, because λ came nearer too slowly, or because sets have settled.
    pub raised: u8,
    /// By how many powers of ten ε has been raised, because contact closed too slowly.
    pub firmer: u8,
    /// What λ was off when it was taken last, as a length.
    pub missed: f64,
}

/// Traction and its derivative by d.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Answer {
    pub traction: [f64; 3],
    pub tangent: [[f64; 3]; 3],
    pub status: Status,
}

/// Over the stiffness of the bodies: ε_t of cautious nodes, and the most that holds a slipping node
/// across its slip.
const SOFT: f64 = 30.0;

/// The most that ε_t is raised.
pub const MOST_RAISED: u8 = 2;

impl Law {
    /// ε of a node.
    fn penalty(&self, node: &Node) -> f64 {
        let raised = self.penalty * f64::powi(10.0, i32::from(node.firmer));
        raised.min(self.firmest)
    }

    /// ε_t of a cautious node.
    fn soft(&self, node: &Node) -> f64 {
        SOFT * self.stiffness * f64::powi(10.0, i32::from(node.raised))
    }

    /// λ of a closed cautious node takes the shear, so that the node loses its elastic slip. Where λ comes nearer
    /// too slowly, as under a pattern of shear that the bodies hardly give way to, ε_t is raised (Bertsekas 1982).
    pub fn take_shear(&self, node: &mut Node, answer: &Answer) {
        const TOO_LITTLE: f64 = 0.5;
        let missed = self.violation(node, answer);
        if missed > TOO_LITTLE * node.missed && node.missed > 0.0 && node.raised < MOST_RAISED {
            node.raised += 1;
        }
        node.missed = missed;
        (node.multiplier[1], node.multiplier[2]) = (answer.traction[1], answer.traction[2]);
    }

    /// Traction of a node at d.
    pub fn traction(&self, node: &Node, d: &[f64; 3]) -> Answer {
        let mut answer = Answer::default();
        if !node.closed {
            return answer;
        }
        answer.status = Status::Slip;
        let penalty = self.penalty(node);
        answer.traction[0] = node.multiplier[0] + penalty * d[0];
        answer.tangent[0][0] = penalty;
        if self.friction == 0.0 {
            return answer;
        }
        if !node.cautious && !node.sticks {
            for i in 0..2 {
                let [s, t] = node.slope[i];
                let moved = s * (d[1] - node.origin[0]) + t * (d[2] - node.origin[1]);
                answer.traction[1 + i] = node.multiplier[1 + i] + moved;
                answer.tangent[1 + i][1..].copy_from_slice(&node.slope[i]);
            }
            return answer;
        }
        let soft = self.soft(node);
        let stick = if node.cautious { soft } else { penalty };
        let elastic = [1, 2].map(|i| node.multiplier[i] + stick * d[i]);
        let shear = elastic[0].hypot(elastic[1]);
        if !node.cautious || shear <= node.bound {
            answer.status = Status::Stick;
            for i in 0..2 {
                answer.traction[1 + i] = elastic[i];
                answer.tangent[1 + i][1 + i] = stick;
            }
            return answer;
        }
        let e = elastic.map(|t| t / shear);
        let turn = soft * node.bound / shear;
        for i in 0..2 {
            answer.traction[1 + i] = node.bound * e[i];
            for j in 0..2 {
                let across = f64::from(u8::from(i == j)) - e[i] * e[j];
                answer.tangent[1 + i][1 + j] = turn * across;
            }
        }
        answer
    }

    /// Largest shear traction under the traction of an iteration.
    pub fn bound(&self, traction: &[f64; 3]) -> f64 {
        self.friction * traction[0].max(0.0)
    }

    /// How far λ still is from the traction, as a length: closure, and slip of a sticking node.
    pub fn violation(&self, node: &Node, answer: &Answer) -> f64 {
        // Elastic slip counts by this share: it moves no pressure.
        const SLIP_SHARE: f64 = 0.1;
        let miss = |i: usize| answer.traction[i] - node.multiplier[i];
        let closure = miss(0).abs() / self.penalty(node);
        if answer.status != Status::Stick {
            return closure;
        }
        let slip = miss(1).hypot(miss(2));
        closure.max(match node.cautious {
            true => SLIP_SHARE * slip / self.soft(node),
            false => slip / self.penalty(node),
        })
    }

    /// What decides whether a node is closed: its pressure. That of an open one is what its overlap would give. What
    /// a closed node is off its gap is only what λ was off: of no account, however much.
    pub fn presses(&self, node: &Node, traction: &[f64; 3], d: &[f64; 3]) -> f64 {
        match node.closed {
            true => traction[0],
            false => self.stiffness * d[0],
        }
    }

    /// What decides whether a node slips: by how much |λ + c d| is beyond the bound.
    pub fn beyond(&self, traction: &[f64; 3], d: &[f64; 3], bound: f64) -> f64 {
        let trial = [1, 2].map(|i| traction[i] + self.stiffness * d[i]);
        trial[0].hypot(trial[1]) - bound
    }

    /// The node after an iteration that ended with `traction` at d: multipliers take the tractions, sets are
    /// decided anew, shear is bounded by `bound`.
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
            self.slip(&mut next, [s, t], [d[1], d[2]]);
        }
        next
    }

    /// The shear of a slipping node and how it changes with d, linearised about the `shear` and d
    /// of now.
    ///
    /// With b = |λ + c d|, n = (λ + c d) / b and a = λ·n within 0 and μ p, the slope is
    /// μ p c / (b − μ p) across n and c (μ p − a) / (b − μ p + a) along n. A node that slips steadily
    /// has a = μ p: its shear turns by μ p / |d|, and grows no more.
    fn slip(&self, node: &mut Node, shear: [f64; 2], d: [f64; 2]) {
        let (c, bound) = (self.stiffness, node.bound);
        node.origin = d;
        let clip = |v: [f64; 2]| {
            let size = v[0].hypot(v[1]);
            let share = if size > bound { bound / size } else { 1.0 };
            v.map(|v| share * v)
        };
        let old = clip(shear);
        let trial = [0, 1].map(|i| old[i] + c * d[i]);
        let b = trial[0].hypot(trial[1]);
        if b == 0.0 {
            (node.multiplier[1], node.multiplier[2]) = (0.0, 0.0);
            return;
        }
        let n = trial.map(|v| v / b);
        let excess = (b - bound).max(bound * c / self.soft(node));
        let along = (old[0] * n[0] + old[1] * n[1]).clamp(0.0, bound);
        let slip_along = d[0] * n[0] + d[1] * n[1];
        let across = bound * c / excess;
        let forward = c * (bound - along) / (excess + along).max(f64::MIN_POSITIVE);
        let next = clip([0, 1].map(|i| bound * n[i] + across * (d[i] - slip_along * n[i])));
        for i in 0..2 {
            node.multiplier[1 + i] = next[i];
            for j in 0..2 {
                let nn = n[i] * n[j];
                node.slope[i][j] = across * (f64::from(u8::from(i == j)) - nn) + forward * nn;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: Law = Law {
        friction: 0.15,
        penalty: 1000.0,
        firmest: 1000.0,
        stiffness: 10.0,
    };

    fn closed(multiplier: [f64; 3], sticks: bool) -> Node {
        Node {
            closed: true,
            sticks,
            multiplier,
            bound: 0.15 * multiplier[0],
            ..Node::default()
        }
    }

    #[test]
    fn an_overloaded_node_slips_along_its_shear() {
        let node = closed([10.0, 3.0, -4.0], true);
        let traction = LAW.traction(&node, &[0.0; 3]).traction;
        assert_eq!(traction, [10.0, 3.0, -4.0]);
        let next = LAW.decide(&node, &traction, &[0.0; 3], LAW.bound(&traction));
        assert!(!next.sticks);
        let answer = LAW.traction(&next, &[0.0; 3]);
        assert_eq!(answer.status, Status::Slip);
        let t = answer.traction;
        assert!((t[1] - 0.9).abs() < 1e-14 && (t[2] + 1.2).abs() < 1e-14);
    }

    #[test]
    fn a_slipping_node_that_moves_back_sticks() {
        let node = closed([10.0, 1.5, 0.0], false);
        let back = [0.0, -0.01, 0.0];
        let traction = LAW.traction(&node, &back).traction;
        assert!(
            LAW.decide(&node, &traction, &back, LAW.bound(&traction))
                .sticks
        );
        let on = [0.0, 0.01, 0.0];
        let traction = LAW.traction(&node, &on).traction;
        assert!(
            !LAW.decide(&node, &traction, &on, LAW.bound(&traction))
                .sticks
        );
    }

    #[test]
    fn the_tangent_is_the_derivative_of_the_traction() {
        for sticks in [true, false] {
            let d = [0.001, 0.03, 0.02];
            let mut node = closed([10.0, 0.5, -0.2], sticks);
            if !sticks {
                LAW.slip(&mut node, [0.5, -0.2], [0.025, 0.02]);
                assert!(node.slope[0][0] > 1.0);
            }
            let base = LAW.traction(&node, &d);
            for j in 0..3 {
                let mut moved = d;
                moved[j] += 1e-7;
                let next = LAW.traction(&node, &moved);
                for i in 0..3 {
                    let slope = (next.traction[i] - base.traction[i]) / 1e-7;
                    assert!((slope - base.tangent[i][j]).abs() < 1e-3, "{i}{j}");
                }
            }
        }
    }

    #[test]
    fn a_slipping_shear_settles_on_the_bound_along_the_slip() {
        let d = [0.0, 0.3, 0.4];
        let mut node = closed([10.0, -1.5, 0.0], false);
        for _ in 0..6 {
            let traction = LAW.traction(&node, &d).traction;
            node = LAW.decide(&node, &[10.0, traction[1], traction[2]], &d, 1.5);
        }
        assert!(!node.sticks);
        let [_, s, t] = LAW.traction(&node, &d).traction;
        assert!((s - 0.9).abs() < 1e-6 && (t - 1.2).abs() < 1e-6, "{s} {t}");
        // It turns with the slip and grows no more.
        let [_, s, t] = LAW
            .traction(&node, &[0.0, 0.3 - 0.004, 0.4 + 0.003])
            .traction;
        assert!(
            (s - 0.9 + 1.5 * 0.004 / 0.5).abs() < 1e-6
                && (t - 1.2 - 1.5 * 0.003 / 0.5).abs() < 1e-6
        );
        let [_, s, t] = LAW.traction(&node, &[0.0, 0.33, 0.44]).traction;
        assert!((s - 0.9).abs() < 1e-6 && (t - 1.2).abs() < 1e-6);
    }

    #[test]
    fn caution_returns_to_the_disc_within_the_iteration() {
        let node = Node {
            cautious: true,
            ..closed([10.0, 0.0, 0.0], true)
        };
        assert_eq!(
            LAW.traction(&node, &[0.0, 0.004, 0.0]).status,
            Status::Stick
        );
        let answer = LAW.traction(&node, &[0.0, 0.03, -0.04]);
        assert_eq!(answer.status, Status::Slip);
        assert!((answer.traction[1] - 0.9).abs() < 1e-14);
        assert!((answer.traction[2] + 1.2).abs() < 1e-14);
    }

    #[test]
    fn a_soft_penalty_is_raised_as_far_as_the_automatic_one() {
        let law = Law {
            penalty: 20.0,
            ..LAW
        };
        let pressure = |firmer| {
            let node = Node {
                firmer,
                ..closed([10.0, 0.0, 0.0], true)
            };
            law.traction(&node, &[0.01, 0.0, 0.0]).traction[0]
        };
        assert_eq!([0, 1, 9].map(pressure), [10.2, 12.0, 20.0]);
    }

    #[test]
    fn tension_opens_and_penetration_closes() {
        let node = closed([10.0, 0.0, 0.0], false);
        let d = [1e-6, 0.0, 0.0];
        assert!(!LAW.decide(&node, &[-1.0, 0.0, 0.0], &d, 0.0).closed);
        assert!(LAW.decide(&Node::default(), &[0.0; 3], &d, 0.0).closed);
        // λ was far too large: d says so, and nothing else.
        let d = [-0.5, 0.0, 0.0];
        assert!(LAW.decide(&node, &[1e-6, 0.0, 0.0], &d, 0.0).closed);
    }
}
