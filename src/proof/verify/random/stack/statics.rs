//! What statics tells of a stack without solving it.
//!
//! All forces pass through every interface: the resultant has to lie within the cone of friction and to pass
//! through the area where the two blocks face each other.

use super::block::StackBlock;
use crate::ground::geometry::{Vec3, dot, norm, scale, sub};
use crate::model::material::Steel;
use crate::proof::verify::random::known::BalanceLimit;

/// Shares of a force or of a length below this are rounding errors.
const NEGLIGIBLE: f64 = 1e-9;

/// Where the force passes an interface.
pub struct PassedInterface {
    /// Force across it, and along it.
    pressed: f64,
    shear: f64,
    /// Of the area where the two blocks face each other: half of its widths,
    half: [f64; 2],
    /// and how far from its middle the line of force passes.
    off: [f64; 2],
}

pub fn interfaces(parts: &[StackBlock], force: Vec3) -> Vec<PassedInterface> {
    let top = &parts[parts.len() - 1];
    let middle = [0, 1].map(|i| 0.5 * (top.low[i] + top.high[i]));
    let centre = [middle[0], middle[1], top.faces[1].at(middle)];
    let between = |pair: &[StackBlock]| {
        let face = pair[0].faces[1];
        let normal = face.normal();
        let pressed = -dot(force, normal);
        // Where the line of force meets the interface.
        let origin = [0.0, 0.0, face.height];
        let way = dot(sub(origin, centre), normal) / dot(force, normal);
        let bears = [0, 1].map(|i| {
            let low = pair[0].low[i].max(pair[1].low[i]);
            let high = pair[0].high[i].min(pair[1].high[i]);
            let at = centre[i] + way * force[i];
            (0.5 * (high - low), (at - 0.5 * (low + high)).abs())
        });
        PassedInterface {
            pressed,
            shear: norm(sub(force, scale(normal, -pressed))),
            half: bears.map(|(half, _)| half),
            off: bears.map(|(_, off)| off),
        }
    };
    parts.windows(2).map(between).collect()
}

/// What every interface needs.
pub fn limits(
    parts: &[StackBlock],
    frictions: &[f64],
    interfaces: &[PassedInterface],
) -> Vec<BalanceLimit> {
    let mut limits = Vec::new();
    for ((pair, friction), at) in parts.windows(2).zip(frictions).zip(interfaces) {
        let PassedInterface { pressed, shear, .. } = *at;
        if shear > NEGLIGIBLE * pressed {
            limits.push(BalanceLimit::about(
                "friction",
                *friction,
                shear / pressed,
                0.02,
            ));
        }
        for i in 0..2 {
            // Pressure at the very edge of the area takes nodes there: its middle is known to a third of a cell.
            let cell = |part: &StackBlock| (part.high[i] - part.low[i]) / part.cells[i] as f64;
            let half = at.half[i];
            limits.push(BalanceLimit::about(
                "half of the width that bears",
                half,
                at.off[i].max(NEGLIGIBLE),
                cell(&pair[0]).max(cell(&pair[1])) / (3.0 * half.abs()),
            ));
        }
    }
    limits
}

/// About by how much the uppermost block turns, in radians. Where the force passes an interface beyond the kern of
/// its area, pressure grows from nothing to twice its mean over three times the distance of the force from the edge;
/// the blocks beside give way as columns would.
pub fn turn(parts: &[StackBlock], steels: &[Steel], interfaces: &[PassedInterface]) -> f64 {
    let mut all = 0.0;
    for ((pair, steels), at) in parts.windows(2).zip(steels.windows(2)).zip(interfaces) {
        for i in 0..2 {
            let half = at.half[i];
            let bears = (3.0 * (half - at.off[i])).min(2.0 * half).max(NEGLIGIBLE);
            let uneven = (3.0 * at.off[i] / half).min(1.0);
            let edge = uneven * 2.0 * at.pressed / (bears * 2.0 * at.half[1 - i]);
            for (part, steel) in pair.iter().zip(steels) {
                let height = part.faces[1].height - part.faces[0].height;
                let strain = match edge > steel.yield_stress {
                    true => (edge - steel.yield_stress) / steel.hardening_modulus,
                    false => edge / steel.youngs_modulus,
                };
                all += strain * height / bears;
            }
        }
    }
    all
}
