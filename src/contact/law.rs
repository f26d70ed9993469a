//! Unilateral contact with Coulomb friction at one carrier node, in augmented-Lagrange form.
//!
//! With the multiplier λ and the relative displacement d (normal: closure beyond the gap,
//! tangential: slip since the last increment), the traction is the projection of λ + ε d onto
//! Coulomb's cone (Alart and Curnier 1991). At a fixed point z = λ the contact conditions hold
//! exactly, whatever the penalty ε. Components: normal (compression positive), two tangents.

/// State of a carrier node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Status {
    #[default]
    Open,
    Stick,
    Slip,
}

/// Traction and its derivative by d.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    pub traction: [f64; 3],
    pub status: Status,
    pub tangent: [[f64; 3]; 3],
}

/// Projects `multiplier + penalty * d` onto the cone of `friction`.
pub fn traction(friction: f64, penalty: f64, multiplier: &[f64; 3], d: &[f64; 3]) -> Answer {
    let trial: [f64; 3] = std::array::from_fn(|i| multiplier[i] + penalty * d[i]);
    let mut answer =
        Answer { traction: [0.0; 3], status: Status::Open, tangent: [[0.0; 3]; 3] };
    // A NaN must not pass for an open node.
    if trial[0] <= 0.0 {
        return answer;
    }
    answer.traction[0] = trial[0];
    answer.tangent[0][0] = penalty;
    answer.status = Status::Slip;
    if friction == 0.0 {
        return answer;
    }
    let (shear, bound) = (trial[1].hypot(trial[2]), friction * trial[0]);
    if shear <= bound {
        answer.status = Status::Stick;
        answer.traction = trial;
        answer.tangent[1][1] = penalty;
        answer.tangent[2][2] = penalty;
        return answer;
    }
    let e = [trial[1] / shear, trial[2] / shear];
    for i in 0..2 {
        answer.traction[1 + i] = bound * e[i];
        answer.tangent[1 + i][0] = friction * penalty * e[i];
        for j in 0..2 {
            let projector = f64::from(u8::from(i == j)) - e[i] * e[j];
            answer.tangent[1 + i][1 + j] = bound / shear * penalty * projector;
        }
    }
    answer
}

/// The traction of a node that is glued for one predictor step.
pub fn glued(friction: f64, penalty: f64, multiplier: &[f64; 3], d: &[f64; 3]) -> Answer {
    let mut answer = Answer {
        traction: std::array::from_fn(|i| multiplier[i] + penalty * d[i]),
        status: Status::Stick,
        tangent: [[penalty, 0.0, 0.0], [0.0, penalty, 0.0], [0.0, 0.0, penalty]],
    };
    if friction == 0.0 {
        answer.traction = [answer.traction[0], 0.0, 0.0];
        answer.tangent[1][1] = 0.0;
        answer.tangent[2][2] = 0.0;
    }
    answer
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tangent_is_the_derivative_in_every_regime() {
        let lambda = [10.0, 1.0, -0.5];
        for d in [[0.01, 0.001, 0.002], [0.01, 0.3, -0.2], [-0.2, 0.0, 0.0]] {
            let base = traction(0.15, 100.0, &lambda, &d);
            for j in 0..3 {
                let mut moved = d;
                moved[j] += 1e-7;
                let next = traction(0.15, 100.0, &lambda, &moved);
                for i in 0..3 {
                    let slope = (next.traction[i] - base.traction[i]) / 1e-7;
                    assert!((slope - base.tangent[i][j]).abs() < 1e-3, "{i}{j} {:?}", base.status);
                }
            }
        }
    }

    #[test]
    fn shear_never_exceeds_coulomb() {
        let answer = traction(0.15, 100.0, &[10.0, 0.0, 0.0], &[0.0, 5.0, 5.0]);
        assert_eq!(answer.status, Status::Slip);
        assert!((answer.traction[1].hypot(answer.traction[2]) - 1.5).abs() < 1e-14);
    }
}
