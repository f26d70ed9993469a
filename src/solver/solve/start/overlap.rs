//! By how much bodies overlap before any load, where they were moved into touch.

use crate::model::scene::{ContactPair, Partner, Scene, joined};
use crate::solver::solve::rows::contact_rows::sights_of;
use crate::solver::solve::start::extent::extent;
use crate::solver::solve::start::held_bodies::held_bodies;
use crate::solver::solve::start::load_direction::load_direction;

/// How far an overlap is looked for, of the size of the scene.
const DEEPEST: f64 = 0.01;

/// How deep the true surfaces of `pair` overlap where the least weighted gap vanishes, a length; zero where both sides were
/// held, and stand where they were drawn.
pub fn overlap_at_touch(scene: &Scene, pair: &ContactPair) -> f64 {
    let Some(direction) = load_direction(scene) else {
        return 0.0;
    };
    let (joined, held) = (joined(scene), held_bodies(scene, direction));
    let stands = |side: &Partner| {
        let Some(body) = side.body(&scene.mesh) else {
            return true;
        };
        (0..held.len()).any(|other| held[other] && joined[other] == joined[body])
    };
    if stands(&pair.upper) && stands(&pair.lower) {
        return 0.0;
    }
    let sights = sights_of(scene, pair, DEEPEST * extent(scene));
    let gaps = sights.into_iter().map(|sight| sight.gap);
    -gaps.fold(0.0, f64::min)
}
