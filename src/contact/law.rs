//! Unilateral contact with Coulomb friction at one carrier node.
//!
//! A primal-dual active-set law (Hüeber and Wohlmuth 2005; Gitterle et al. 2010). Within an
//! iteration the status of a node is fixed and its law is smooth: a closed node carries the
//! augmented-Lagrange traction λ + ε d, in compression *or* tension; a sticking one carries shear
//! likewise; a slipping one carries Coulomb's shear along its slip. Between iterations λ takes the traction and the status is decided anew. When statuses rest and λ does, the contact
//! conditions hold exactly, whatever the penalty ε.
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
    /// ε, traction per length.
    pub penalty: f64,
    /// Weight of d against λ where statuses are decided: the stiffness of the bodies there.
    pub stiffness: f64,
}

/// Traction and its derivative by d.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Answer {
    pub traction: [f64; 3],
    pub tangent: [[f64; 3]; 3],
}

impl Law {
    /// Traction of a node whose status is given.
    pub fn traction(&self, status: Status, multiplier: &[f64; 3], d: &[f64; 3]) -> Answer {
        let mut answer = Answer::default();
        if status == Status::Open {
            return answer;
        }
        let penalty = self.penalty;
        let normal = multiplier[0] + penalty * d[0];
        answer.traction[0] = normal;
        answer.tangent[0][0] = penalty;
        match status {
            Status::Stick => {
                for i in 1..3 {
                    answer.traction[i] = multiplier[i] + penalty * d[i];
                    answer.tangent[i][i] = penalty;
                }
            }
            Status::Slip => {
                let trial = self.trial(multiplier, d);
                let shear = trial[0].hypot(trial[1]);
                if self.friction == 0.0 || shear == 0.0 {
                    return answer;
                }
                let e = trial.map(|t| t / shear);
                let bound = self.friction * normal;
                // How fast the direction turns; never stiffer than sticking.
                let turn = self.stiffness * (bound / shear).clamp(0.0, 1.0);
                for i in 0..2 {
                    answer.traction[1 + i] = bound * e[i];
                    answer.tangent[1 + i][0] = self.friction * penalty * e[i];
                    for j in 0..2 {
                        let across = f64::from(u8::from(i == j)) - e[i] * e[j];
                        answer.tangent[1 + i][1 + j] = turn * across;
                    }
                }
            }
            Status::Open => {}
        }
        answer
    }

    /// The status that the multiplier and d ask for.
    pub fn decide(&self, multiplier: &[f64; 3], d: &[f64; 3]) -> Status {
        let pressure = multiplier[0] + self.stiffness * d[0];
        // Written so that a NaN does not pass for an open node.
        if pressure <= 0.0 {
            return Status::Open;
        }
        if self.friction == 0.0 {
            return Status::Slip;
        }
        let trial = self.trial(multiplier, d);
        if trial[0].hypot(trial[1]) <= self.friction * pressure { Status::Stick } else { Status::Slip }
    }

    /// The shear whose direction slip takes.
    fn trial(&self, multiplier: &[f64; 3], d: &[f64; 3]) -> [f64; 2] {
        [1, 2].map(|i| multiplier[i] + self.stiffness * d[i])
    }
}

impl Status {
    /// 0 open, 1 stick, 2 slip.
    pub fn code(&self) -> u8 {
        match self {
            Self::Open => 0,
            Self::Stick => 1,
            Self::Slip => 2,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: Law = Law { friction: 0.15, penalty: 1000.0, stiffness: 10.0 };

    #[test]
    fn a_sticking_node_that_overloads_starts_to_slip_along_its_shear() {
        assert_eq!(LAW.decide(&[10.0, 3.0, -4.0], &[0.0; 3]), Status::Slip);
        let t = LAW.traction(Status::Slip, &[10.0, 3.0, -4.0], &[0.0; 3]).traction;
        assert!((t[1] - 0.9).abs() < 1e-14 && (t[2] + 1.2).abs() < 1e-14);
    }

    #[test]
    fn a_slipping_node_that_turns_back_sticks() {
        // Shear at the bound, relative motion against it.
        assert_eq!(LAW.decide(&[10.0, 1.5, 0.0], &[0.0, -0.01, 0.0]), Status::Stick);
        assert_eq!(LAW.decide(&[10.0, 1.5, 0.0], &[0.0, 0.01, 0.0]), Status::Slip);
    }

    #[test]
    fn the_tangent_is_the_derivative_of_the_traction() {
        let (lambda, d) = ([10.0, 1.0, -1.5], [0.001, 0.02, 0.03]);
        for status in [Status::Stick, Status::Slip] {
            let base = LAW.traction(status, &lambda, &d);
            for j in 0..3 {
                let mut moved = d;
                moved[j] += 1e-7;
                let next = LAW.traction(status, &lambda, &moved);
                for i in 0..3 {
                    let slope = (next.traction[i] - base.traction[i]) / 1e-7;
                    assert!((slope - base.tangent[i][j]).abs() < 1e-3, "{status:?} {i}{j}");
                }
            }
        }
    }

    #[test]
    fn tension_opens_and_penetration_closes() {
        assert_eq!(LAW.decide(&[-1.0, 0.0, 0.0], &[1e-6, 0.0, 0.0]), Status::Open);
        assert_eq!(LAW.decide(&[0.0; 3], &[1e-6, 0.0, 0.0]), Status::Stick);
    }
}
