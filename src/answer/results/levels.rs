//! The force that passes from level to level of a stack, where contact pairs side by side share it.
//!
//! Level 0 is what is held along the load, level k + 1 what touches level k. All pairs between two levels carry together
//! what acts above them.

use super::interface::Interface;
use super::load::{along, cutting_pair, times};
use crate::model::scene::{Partner, PlaneMotion, RigidPlane, Scene, Support, joined};
use crate::model::state::State;
use std::collections::BTreeMap;

/// Of the load, a part along an axis which is none: what holds a body along it takes nothing that counts.
const LEAST_PART: f64 = 1e-4;

/// The forces along the load that balance says are the whole load: of every level that all of it passes. A pair that no
/// support is reached from stands for itself.
pub fn passing(scene: &Scene, state: &State, measured: &[Interface]) -> Vec<f64> {
    let along = along(scene, state);
    let sides: Vec<[Option<usize>; 2]> = (scene.contacts.iter())
        .map(|pair| [pair.lower.body(&scene.mesh), pair.upper.body(&scene.mesh)])
        .collect();
    let levels = levels(scene, along, &sides);
    let level = |side: Option<usize>| match side {
        Some(body) => levels[body],
        // A plane in space.
        None => Some(0),
    };
    let beside = |mirrors: &[usize]| -> Vec<usize> {
        let axis = main_axis(along);
        mirrors.iter().copied().filter(|m| *m != axis).collect()
    };
    let loaded = loaded_bodies(scene, along);
    let lowest_load = loaded.into_iter().filter_map(|body| levels[body]).min();
    let mut sums: BTreeMap<usize, f64> = BTreeMap::new();
    let mut alone = Vec::new();
    for (index, interface) in measured.iter().enumerate() {
        let [Some(a), Some(b)] = sides[index].map(level) else {
            alone.push(interface.normal_force);
            continue;
        };
        let upper = a.max(b);
        if a == b || lowest_load.is_some_and(|lowest| lowest < upper) {
            continue;
        }
        // What lies beside a mirror stands for its image too.
        let images = times(&beside(&scene.mirrors)) / times(&beside(&cutting_pair(scene, index)));
        *sums.entry(upper).or_default() += images * interface.normal_force;
    }
    sums.into_values().chain(alone).collect()
}

/// How many contacts each body is away from what is held along `along`; `None` where no chain of contacts leads there.
/// Bodies that are joined are as far away.
fn levels(scene: &Scene, along: [f64; 3], sides: &[[Option<usize>; 2]]) -> Vec<Option<usize>> {
    let mut levels = vec![None; scene.mesh.bodies.len()];
    for body in held_bodies(scene, along) {
        levels[body] = Some(0);
    }
    for (pair, sides) in scene.contacts.iter().zip(sides) {
        let on_plane = [&pair.lower, &pair.upper].map(|p| matches!(p, Partner::Plane { .. }));
        if on_plane.contains(&true) {
            for body in sides.iter().flatten() {
                levels[*body] = levels[*body].or(Some(1));
            }
        }
    }
    let joined = joined(scene);
    for next in 1..=levels.len() {
        pass_on(&mut levels, &joined);
        for sides in sides {
            let [Some(a), Some(b)] = *sides else { continue };
            for [from, to] in [[a, b], [b, a]] {
                if levels[from] == Some(next - 1) && levels[to].is_none() {
                    levels[to] = Some(next);
                }
            }
        }
    }
    levels
}

/// Gives bodies of one group the lowest level of it.
fn pass_on(levels: &mut [Option<usize>], joined: &[usize]) {
    for body in 0..levels.len() {
        let group = (0..levels.len()).filter(|other| joined[*other] == joined[body]);
        levels[body] = levels[body].or(group.filter_map(|other| levels[other]).min());
    }
}

fn bodies_of<'s>(scene: &'s Scene, surface: &str) -> impl Iterator<Item = usize> + use<'s> {
    let surface = scene.mesh.surface(surface).into_iter();
    surface.flat_map(|surface| surface.bodies(&scene.mesh))
}

/// The axis that the load acts along, mostly.
fn main_axis(along: [f64; 3]) -> usize {
    let size = |axis: &usize| along[*axis].abs();
    (0..3).fold(0, |best, axis| {
        if size(&axis) > size(&best) {
            axis
        } else {
            best
        }
    })
}

/// Bodies that a support or a plane holds, where they are, along an axis that the load has a part along.
fn held_bodies(scene: &Scene, along: [f64; 3]) -> Vec<usize> {
    let takes = |axis: usize| along[axis].abs() > LEAST_PART;
    let axes: Vec<usize> = (0..3).filter(|axis| takes(*axis)).collect();
    let supports = scene.supports.iter();
    let supports = supports.filter(|support| axes.iter().any(|axis| stays(support, *axis)));
    let planes = scene.rigid_planes.iter();
    let holds = |plane: &&RigidPlane| {
        axes.iter()
            .any(|axis| plane.motion[*axis] == PlaneMotion::Held(0.0))
    };
    let planes = planes.filter(holds);
    let surfaces = supports
        .map(|s| &s.surface)
        .chain(planes.map(|p| &p.surface));
    surfaces.flat_map(|name| bodies_of(scene, name)).collect()
}

/// Is that a support that moves nothing along `axis`?
fn stays(support: &Support, axis: usize) -> bool {
    support.components[axis] == Some(0.0) && support.gradient[axis] == [0.0; 3]
}

/// Bodies that a force acts on, or that something moves along the load.
fn loaded_bodies(scene: &Scene, along: [f64; 3]) -> Vec<usize> {
    let axis = main_axis(along);
    let moves = |motion: PlaneMotion| match motion {
        PlaneMotion::Driven(force) => force != 0.0,
        PlaneMotion::Held(travel) => travel != 0.0,
        PlaneMotion::Free => false,
    };
    let planes = scene.rigid_planes.iter();
    let planes = planes
        .filter(|plane| moves(plane.motion[axis]))
        .map(|p| &p.surface);
    let supports = scene.supports.iter();
    let supports = supports.filter(|s| s.components[axis].is_some() && !stays(s, axis));
    let supports = supports.map(|s| &s.surface);
    let tractions = scene.tractions.iter().map(|t| &t.surface);
    let surfaces = planes.chain(supports).chain(tractions);
    surfaces.flat_map(|name| bodies_of(scene, name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_of_ties_is_of_one_level() {
        let mut levels = [Some(0), None, None, None];
        pass_on(&mut levels, &[0, 0, 0, 3]);
        assert_eq!(levels, [Some(0), Some(0), Some(0), None]);
    }
}
