//! Lengths of a scene: its size, what it is made to travel, and how far contact reaches.

use crate::model::scene::{PlaneMotion, PlaneTurn, Scene};
use crate::solver::solve::params::{FIRST_LIKELY_GAP, FIRST_REACH, REACH_OVER_TRAVEL};

/// Diagonal of the box around the model.
pub fn extent(scene: &Scene) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|axis| scene.mesh.extent(axis));
    x.hypot(y).hypot(z)
}

/// The initial gap up to which contact is integrated: a little more than bodies approach each other
/// in small-strain contact, and all that they are made to travel.
pub fn reach(scene: &Scene) -> f64 {
    scene.controls.contact_reach
        * (FIRST_REACH * extent(scene)).max(REACH_OVER_TRAVEL * travel(scene))
}

/// The initial gap, over the least one, up to which contact is likely to close.
pub fn likely_gap(scene: &Scene) -> f64 {
    scene.controls.contact_reach
        * (FIRST_LIKELY_GAP * extent(scene)).max(REACH_OVER_TRAVEL * travel(scene))
}

/// The largest displacement that is prescribed.
pub fn travel(scene: &Scene) -> f64 {
    let factors = |name: &str| {
        let factors = scene.steps.iter().map(|s| s.factor_of(name).abs());
        factors.fold(0.0, f64::max)
    };
    let supports = scene.supports.iter().flat_map(|s| {
        let factor = factors(&s.name);
        s.components.iter().flatten().map(move |v| v.abs() * factor)
    });
    let planes = scene.rigid_planes.iter().flat_map(|p| {
        let factor = factors(&p.name);
        let turned = p.turn.map(|turn| match turn {
            PlaneTurn::Held(angle) if angle != 0.0 => angle.abs() * extent(scene) * factor,
            _ => 0.0,
        });
        let moved = p.motion.map(|m| match m {
            PlaneMotion::Held(v) => v.abs() * factor,
            _ => 0.0,
        });
        moved.into_iter().chain(turned)
    });
    supports.chain(planes).fold(0.0, f64::max)
}
