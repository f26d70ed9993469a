//! Unilateral contact with Coulomb friction at one carrier node.
//!
//! *Normal*: a primal-dual active set (Hüeber and Wohlmuth 2005). Within an iteration a closed
//! node carries the augmented-Lagrange pressure λ + ε d in compression *or* tension, an open one
//! nothing; between iterations λ takes the pressure and the set is decided anew. When the set and λ
//! rest, the contact conditions hold exactly, whatever the penalty ε.
//!
//! *Tangential*: radial return of λ + ε_t d onto the disc of radius μ p, with p from the iteration
//! before. For a given bound that is the slope of a convex potential, so that the tangent is
//! symmetric and a line search is sound; the bound itself settles within a few iterations
//! (in equal steels pressure hardly feels shear at all).
//!
//! Components everywhere: normal (compression positive), two tangents. d is the closure beyond
//! the gap and the slip since the last increment.

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
    /// ε, pressure per closure.
    pub penalty: f64,
    /// ε_t, shear traction per slip.
    pub tangential_penalty: f64,
    /// Weight of d against λ where the active set is decided: the stiffness of the bodies there.
    pub stiffness: f64,
}

/// What changes from iteration to iteration at a node.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Node {
    pub closed: bool,
    /// λ: pressure and shear.
    pub multiplier: [f64; 3],
    /// Largest shear traction, μ p of the iteration before.
    pub bound: f64,
}

/// Traction and its derivative by d.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Answer {
    pub traction: [f64; 3],
    pub tangent: [[f64; 3]; 3],
    pub status: Status,
}

impl Law {
    /// Traction of a node at d.
    pub fn traction(&self, node: &Node, d: &[f64; 3]) -> Answer {
        let mut answer = Answer::default();
        if !node.closed {
            return answer;
        }
        answer.status = Status::Slip;
        answer.traction[0] = node.multiplier[0] + self.penalty * d[0];
        answer.tangent[0][0] = self.penalty;
        if self.friction == 0.0 {
            return answer;
        }
        let trial = [1, 2].map(|i| node.multiplier[i] + self.tangential_penalty * d[i]);
        let shear = trial[0].hypot(trial[1]);
        if shear <= node.bound {
            answer.status = Status::Stick;
            for i in 0..2 {
                answer.traction[1 + i] = trial[i];
                answer.tangent[1 + i][1 + i] = self.tangential_penalty;
            }
            return answer;
        }
        let e = trial.map(|t| t / shear);
        let turn = self.tangential_penalty * node.bound / shear;
        for i in 0..2 {
            answer.traction[1 + i] = node.bound * e[i];
            for j in 0..2 {
                let across = f64::from(u8::from(i == j)) - e[i] * e[j];
                answer.tangent[1 + i][1 + j] = turn * across;
            }
        }
        answer
    }

    /// Does the node press, given its pressure and d?
    pub fn presses(&self, pressure: f64, d: &[f64; 3]) -> bool {
        pressure + self.stiffness * d[0] > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: Law = Law {
        friction: 0.15,
        penalty: 1000.0,
        tangential_penalty: 100.0,
        stiffness: 10.0,
    };

    fn closed(multiplier: [f64; 3]) -> Node {
        Node {
            closed: true,
            multiplier,
            bound: 0.15 * multiplier[0],
        }
    }

    #[test]
    fn an_overloaded_node_slips_along_its_shear() {
        let answer = LAW.traction(&closed([10.0, 3.0, -4.0]), &[0.0; 3]);
        assert_eq!(answer.status, Status::Slip);
        let t = answer.traction;
        assert!((t[1] - 0.9).abs() < 1e-14 && (t[2] + 1.2).abs() < 1e-14);
    }

    #[test]
    fn the_tangent_is_the_derivative_of_the_traction() {
        for d in [[0.001, 0.002, 0.003], [0.001, 0.02, 0.03]] {
            let node = closed([10.0, 0.5, -0.5]);
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
    fn tension_opens_and_penetration_closes() {
        assert!(!LAW.presses(-1.0, &[1e-6, 0.0, 0.0]));
        assert!(LAW.presses(0.0, &[1e-6, 0.0, 0.0]));
    }
}
