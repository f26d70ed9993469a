//! The message that rigid bodies cannot be in balance.

use crate::ground::geometry::Vec3;
use std::fmt;

/// Of a unit in the last digit that is told.
const ROUNDING: f64 = 1e-6;

/// Rigid bodies cannot be in balance under the loads of a step, whatever the solution tries.
#[derive(Debug, Clone, PartialEq)]
pub struct NoBalance {
    /// Name of the step.
    pub step: String,
    /// Share of the step beyond which there is none, in percent.
    pub percent: f64,
    /// The body that moves.
    pub body: String,
    /// Does it turn, whatever the friction?
    pub tips: bool,
    /// Unit vector along which it slides, or about which it turns.
    pub along: Vec3,
    /// The contact pair that it bears on most, and where.
    pub bears: Option<(String, Vec3)>,
    /// The least coefficient of friction with which the bodies stand, if any does.
    pub friction: Option<f64>,
}

impl fmt::Display for NoBalance {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let vector = |v: Vec3| {
            let [x, y, z] = v.map(|c| if c.abs() < 5e-4 { 0.0 } else { c });
            format!("({x:.3}, {y:.3}, {z:.3})")
        };
        let how = match (self.tips, self.friction) {
            (true, _) => "tips or rolls, turning about",
            (false, Some(_)) => "slides along",
            (false, None) => "moves off along",
        };
        write!(
            f,
            "there is no balance beyond {:.3} % of step `{}`: body `{}` {how} {}",
            self.percent,
            self.step,
            self.body,
            vector(self.along)
        )?;
        if let Some((pair, [x, y, z])) = &self.bears {
            write!(
                f,
                "; it bears on `{pair}` about ({x:.4e}, {y:.4e}, {z:.4e})"
            )?;
        }
        write!(
            f,
            ". So says the statics of rigid bodies, without any solution"
        )
    }
}

impl NoBalance {
    pub(in crate::solver::solve) fn remedy(&self) -> String {
        match self.friction {
            Some(friction) => {
                // Rounded up: what is told is enough.
                let enough = (friction * 1e4 - ROUNDING).ceil() / 1e4;
                format!(
                    "the bodies, as they are meshed, stand with a coefficient of friction of {enough:.4} or more, or with less \
                     slope or offset"
                )
            }
            None => "no friction helps, as the bodies are meshed. Coarse faces let a round body roll where its true shape stands, \
                     as on both sides of a V: a finer mesh there. Else bring the load nearer to the middle of what carries it \
                     (less offset), or support the body; what rolls resists no force across its axis, and one that comes to \
                     rest farther on is to be meshed where it does"
                .to_owned(),
        }
    }
}
