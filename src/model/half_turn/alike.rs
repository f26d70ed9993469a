//! Are loads, supports and contact pairs of a scene each other's images?

use super::image::Images;
use super::reason::NoHalfTurn;
use crate::model::mesh::Surface;
use crate::model::scene::{ContactPair, Partner, PlaneMotion, RigidPlane, Scene, Side, Support};

/// Asks for one plane that a force drives along z and nothing else that loads or moves.
pub fn loads(scene: &Scene) -> Result<(), NoHalfTurn> {
    if !scene.controls.half_turn {
        return Err(NoHalfTurn::NotWanted);
    }
    if !scene.ties.is_empty() {
        return Err(NoHalfTurn::Tie);
    }
    if !scene.mesh.hanging.is_empty() {
        return Err(NoHalfTurn::Hanging);
    }
    let straight = |plane: &RigidPlane| {
        let [x, y, z] = plane.motion;
        let stays = |motion| matches!(motion, PlaneMotion::Held(0.0) | PlaneMotion::Free);
        stays(x) && stays(y) && matches!(z, PlaneMotion::Driven(_)) && !plane.turns()
    };
    let moves = |support: &Support| {
        let components = support.components.iter().flatten();
        components
            .chain(support.gradient.as_flattened())
            .any(|v| *v != 0.0)
    };
    let one = matches!(scene.rigid_planes.as_slice(), [plane] if straight(plane));
    let sides = scene.mirrors.iter().all(|axis| *axis < 2) && scene.mirrors.len() != 1;
    let even = scene.temperatures.is_empty();
    match one && sides && even && scene.tractions.is_empty() && !scene.supports.iter().any(moves) {
        true => Ok(()),
        false => Err(NoHalfTurn::Load),
    }
}

/// Asks for a fixed surface that is the image of the loaded one, and for an image of every other support. Gives the index
/// of the support that is the image of the load.
pub fn supports(scene: &Scene, images: &Images) -> Result<usize, NoHalfTurn> {
    let surface = |name: &str| scene.mesh.surface(name);
    let (Some(plane), count) = (scene.rigid_planes.first(), scene.supports.len()) else {
        return Err(NoHalfTurn::Load);
    };
    let held = |axis: usize| plane.motion[axis] != PlaneMotion::Free;
    let opposite = [held(1), held(0), true];
    let image = |own: Option<&Surface>, components: [bool; 3], candidate: &usize| {
        let other = &scene.supports[*candidate];
        let same = other.components.map(|c| c.is_some()) == components;
        let pair = own.zip(surface(&other.surface));
        same && pair.is_some_and(|(own, other)| images.are_images(own, other))
    };
    let bottom = (0..count).find(|c| image(surface(&plane.surface), opposite, c));
    let bottom = bottom.ok_or(NoHalfTurn::Load)?;
    for (index, support) in scene.supports.iter().enumerate() {
        let [x, y, z] = support.components.map(|c| c.is_some());
        let own = surface(&support.surface);
        if index != bottom && !(0..count).any(|c| image(own, [y, x, z], &c)) {
            return Err(NoHalfTurn::Support {
                support: support.name.clone(),
            });
        }
    }
    Ok(bottom)
}

/// The image of each contact pair: what is above turns below, and what carries goes on carrying.
pub fn contacts(scene: &Scene, images: &Images) -> Result<Vec<usize>, NoHalfTurn> {
    let are = |a: &Partner, b: &Partner| {
        let pair = a.surface(&scene.mesh).zip(b.surface(&scene.mesh));
        pair.is_some_and(|(a, b)| images.are_images(a, b))
    };
    let alike = |own: &ContactPair, other: &ContactPair| {
        let turned = match own.carrier {
            Side::Upper => Side::Lower,
            Side::Lower => Side::Upper,
        };
        other.carrier == turned
            && other.friction == own.friction
            && other.penalty_factor == own.penalty_factor
            && other.true_geometry == own.true_geometry
            && are(&own.upper, &other.lower)
            && are(&own.lower, &other.upper)
    };
    let image = |own: &ContactPair| {
        let found = scene.contacts.iter().position(|other| alike(own, other));
        found.ok_or_else(|| NoHalfTurn::Contact {
            pair: own.name.clone(),
        })
    };
    scene.contacts.iter().map(image).collect()
}
