//! The applied load of a scene, and what a force on the modelled part is for the whole.

use super::quad::{area, integrate};
use crate::ground::geometry::{add, dot, norm, scale};
use crate::model::mesh::quadrilateral::area_vector;
use crate::model::scene::{PlaneMotion, RigidPlane, Scene, Traction, TractionValue};
use crate::model::state::{PlaneField, State};
use std::iter;

/// How many times the modelled part makes the whole: each mirror doubles.
pub fn copies(scene: &Scene) -> f64 {
    times(&scene.mirrors)
}

/// The force on the whole, from the force on the modelled part: each mirror doubles it, and
/// cancels the component along the mirrored axis.
pub fn whole(scene: &Scene, modelled: [f64; 3]) -> [f64; 3] {
    whole_of(&scene.mirrors, modelled)
}

/// The mirrors that cut a body: the planes that it reaches. Its image across another one is another body.
pub fn cutting(scene: &Scene, body: usize) -> Vec<usize> {
    let elements = scene.mesh.bodies.get(body).map(|b| b.elements.clone());
    let hexes = elements.and_then(|elements| scene.mesh.hexes.get(elements));
    scene.mirrors_that_cut(hexes.into_iter().flatten().flatten().copied())
}

/// The mirrors that cut both bodies of a contact pair. A pair beside a plane has an image that is another pair, with
/// forces of its own.
pub fn cutting_pair(scene: &Scene, pair: usize) -> Vec<usize> {
    let sides = scene.contacts.get(pair).map(|c| [&c.upper, &c.lower]);
    let bodies = sides.into_iter().flatten();
    cutting_all(scene, bodies.filter_map(|side| side.body(&scene.mesh)))
}

/// The mirrors that cut all of some bodies.
pub fn cutting_all(scene: &Scene, bodies: impl Iterator<Item = usize>) -> Vec<usize> {
    bodies.fold(scene.mirrors.clone(), |mut axes, body| {
        let own = cutting(scene, body);
        axes.retain(|axis| own.contains(axis));
        axes
    })
}

/// How many times the modelled part of what `mirrors` cut makes the whole of it.
pub fn times(mirrors: &[usize]) -> f64 {
    mirrors.iter().fold(1.0, |copies, _| 2.0 * copies)
}

/// The force on the whole of what `mirrors` cut, from the force on its modelled part.
pub fn whole_of(mirrors: &[usize], modelled: [f64; 3]) -> [f64; 3] {
    let mut force = modelled.map(|f| f * times(mirrors));
    for &axis in mirrors.iter().filter(|axis| **axis < 3) {
        force[axis] = 0.0;
    }
    force
}

/// A force that a scene prescribes, at factor one: of a driven plane or a traction.
struct Load<'s> {
    name: &'s str,
    /// On the modelled part.
    force: [f64; 3],
    /// Sum of the sizes of what it is the resultant of: of the forces on single faces.
    gross: f64,
}

/// Of the sum of the sizes of all forces, the resultant below which they oppose each other: it says neither where the load goes nor
/// how far.
const OPPOSED: f64 = 0.1;

/// The prescribed forces of a scene: of the planes, then of the tractions.
fn loads(scene: &Scene) -> Vec<Load<'_>> {
    let planes = scene.rigid_planes.iter().map(|plane| {
        let force = plane.motion.map(|m| match m {
            PlaneMotion::Driven(force) => force,
            _ => 0.0,
        });
        Load {
            name: &plane.name,
            force,
            gross: norm(force),
        }
    });
    let tractions = scene.tractions.iter().map(|traction| {
        let faces = || face_forces(scene, traction);
        Load {
            name: &traction.name,
            force: faces().fold([0.0; 3], add),
            gross: faces().map(norm).sum(),
        }
    });
    planes.chain(tractions).collect()
}

/// Forces of a traction on its faces, on the modelled part.
fn face_forces<'a>(
    scene: &'a Scene,
    traction: &'a Traction,
) -> impl Iterator<Item = [f64; 3]> + 'a {
    let surface = scene.mesh.surface(&traction.surface);
    let faces = surface.into_iter().flat_map(|s| &s.faces);
    faces.map(|face| face_force(&traction.value, &face.corners(&scene.mesh)))
}

/// The sum of the sizes of all that acts on the whole, each prescribed force times `factor` of its name, and `moved` planes.
fn gross(
    scene: &Scene,
    factor: impl Fn(&str) -> f64,
    moved: impl Iterator<Item = [f64; 3]>,
) -> f64 {
    let loads = loads(scene).into_iter();
    let prescribed: f64 = loads.map(|load| load.gross * factor(load.name).abs()).sum();
    copies(scene) * (prescribed + moved.map(norm).sum::<f64>())
}

/// Total of the prescribed forces on the whole, each times `factor` of its name.
fn driven(scene: &Scene, factor: impl Fn(&str) -> f64) -> [f64; 3] {
    let forces = loads(scene).into_iter();
    let sum = forces.fold([0.0; 3], |sum, load| {
        add(sum, scale(load.force, factor(load.name)))
    });
    whole(scene, sum)
}

/// Total force of driven planes and tractions on the whole, every factor being one.
pub fn full(scene: &Scene) -> [f64; 3] {
    driven(scene, |_| 1.0)
}

/// Is there a prescribed force along each axis?
fn driven_axes(scene: &Scene) -> [bool; 3] {
    let mut axes = [false; 3];
    for load in loads(scene) {
        // Rounding leaves a little across a traction.
        let noise = 1e-9 * norm(load.force);
        (0..3).for_each(|i| axes[i] |= load.force[i].abs() > noise);
    }
    axes
}

/// Force of a plane along the axes along which it is moved, where `counts` holds; modelled part.
fn moving_force(plane: &RigidPlane, field: &PlaneField, counts: [bool; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| match plane.motion[i] {
        PlaneMotion::Held(u) if u != 0.0 && counts[i] => field.force[i],
        _ => 0.0,
    })
}

/// Sum of the prescribed motions at factor one: of the planes, and where none is moved of the supports.
fn held(scene: &Scene) -> [f64; 3] {
    let of_planes = scene.rigid_planes.iter().map(|plane| {
        plane.motion.map(|motion| match motion {
            PlaneMotion::Held(u) => u,
            _ => 0.0,
        })
    });
    let of_planes = of_planes.fold([0.0; 3], add);
    if of_planes != [0.0; 3] {
        return of_planes;
    }
    let supports = scene.supports.iter();
    let of_supports = supports.map(|s| s.components.map(|u| u.unwrap_or(0.0)));
    of_supports.fold([0.0; 3], add)
}

/// Unit vector along which the scene is loaded when every factor is one: of the resultant of driven
/// planes and tractions, where these oppose each other of the largest, else of the prescribed motion of planes or supports, else straight down.
pub fn direction(scene: &Scene) -> [f64; 3] {
    let (force, gross) = (full(scene), gross(scene, |_| 1.0, iter::empty()));
    let along = if norm(force) > OPPOSED * gross {
        force
    } else {
        let forces = loads(scene).into_iter().map(|load| load.force);
        largest(scene, forces, gross).unwrap_or_else(|| held(scene))
    };
    let length = norm(along);
    if length > 0.0 {
        along.map(|x| x / length)
    } else {
        [0.0, 0.0, -1.0]
    }
}

/// Of forces that oppose each other, on the modelled part, the largest on the whole, and the first of those that are as large;
/// `None` where none is large beside their `gross` sum.
fn largest(scene: &Scene, forces: impl Iterator<Item = [f64; 3]>, gross: f64) -> Option<[f64; 3]> {
    /// By how much another has to be larger.
    const LARGER: f64 = 1.01;
    let forces = forces.map(|force| whole(scene, force));
    let large = forces.filter(|force| norm(*force) > OPPOSED * gross);
    large.reduce(|most, force| match norm(force) > LARGER * norm(most) {
        true => force,
        false => most,
    })
}

/// The axis next to the load.
pub fn upright(scene: &Scene) -> usize {
    let along = direction(scene).map(f64::abs);
    (0..3)
        .max_by(|a, b| along[*a].total_cmp(&along[*b]))
        .unwrap_or(2)
}

/// That axis, and the sign against the load.
pub fn upward(scene: &Scene) -> (usize, f64) {
    let up = upright(scene);
    (up, -direction(scene)[up].signum())
}

/// Total of the prescribed forces that act on the whole in `state`.
pub fn prescribed(scene: &Scene, state: &State) -> [f64; 3] {
    driven(scene, |name| scene.factor(name, state.step, state.time))
}

/// The load that acts on the whole in `state`: the prescribed forces at that moment, and, along axes
/// without any, the forces that moved planes exert.
pub fn resultant(scene: &Scene, state: &State) -> [f64; 3] {
    let prescribed = prescribed(scene, state);
    let moved = moved(scene, state).fold([0.0; 3], add);
    if moved == [0.0; 3] {
        return prescribed;
    }
    let least = rounding(scene);
    let moved = moved.map(|f| if f.abs() > least { f } else { 0.0 });
    add(prescribed, whole(scene, moved))
}

/// Forces with which what is moved resists, along axes without a prescribed force, plane by plane; modelled part.
fn moved<'a>(scene: &'a Scene, state: &'a State) -> impl Iterator<Item = [f64; 3]> + 'a {
    let others = driven_axes(scene).map(|driven| !driven);
    let planes = scene.rigid_planes.iter().zip(&state.planes);
    planes.map(move |(plane, field)| moving_force(plane, field, others))
}

/// Do the loads that act in `state` oppose each other, so that next to nothing of them is left for the whole? Then there is no travel
/// along their resultant, and no interface that all of it passes.
pub fn oppose(scene: &Scene, state: &State) -> bool {
    norm(resultant(scene, state)) < OPPOSED * gross_now(scene, state)
}

fn gross_now(scene: &Scene, state: &State) -> f64 {
    let now = |name: &str| scene.factor(name, state.step, state.time);
    gross(scene, now, moved(scene, state))
}

/// Unit vector along the load that acts in `state`; where next to none does, where loads oppose each other, or planes are moved
/// along one axis only, that of [`direction`].
pub fn along(scene: &Scene, state: &State) -> [f64; 3] {
    let force = if oppose(scene, state) {
        largest_now(scene, state)
    } else {
        Some(resultant(scene, state)).filter(|force| norm(*force) > least(scene))
    };
    force.map_or_else(|| direction(scene), |force| force.map(|f| f / norm(force)))
}

/// Unit vector along the largest single load that acts in `state`, what others push across it; that of [`along`] where none is large.
pub fn main_direction(scene: &Scene, state: &State) -> [f64; 3] {
    let force = largest_now(scene, state).filter(|force| norm(*force) > least(scene));
    force.map_or_else(
        || along(scene, state),
        |force| scale(force, 1.0 / norm(force)),
    )
}

/// Of the loads that act in `state` the [`largest`].
fn largest_now(scene: &Scene, state: &State) -> Option<[f64; 3]> {
    let now = |load: Load| scale(load.force, scene.factor(load.name, state.step, state.time));
    let forces = loads(scene).into_iter().map(now).chain(moved(scene, state));
    largest(scene, forces, gross_now(scene, state))
}

/// Size of a resultant that has a direction. Below it a reaction is what the residual leaves.
fn least(scene: &Scene) -> f64 {
    let prescribed = gross(scene, |_| 1.0, iter::empty());
    if prescribed > 0.0 {
        return 1e-6 * prescribed;
    }
    match held(scene).iter().filter(|u| **u != 0.0).count() {
        // Against the motion it is negative: something pulls.
        0 | 1 => f64::INFINITY,
        _ => rounding(scene),
    }
}

/// Below this a reaction is what rounding leaves: a trillionth of the force of a block as large as the
/// model, strained by the motions over its length.
fn rounding(scene: &Scene) -> f64 {
    let stiffest = scene.materials.iter().map(|s| s.youngs_modulus);
    let extent = (0..3).map(|axis| scene.mesh.extent(axis));
    let motions = scene.rigid_planes.iter().flat_map(|plane| plane.motion);
    let motion = motions.map(|m| match m {
        PlaneMotion::Held(u) => u.abs(),
        _ => 0.0,
    });
    let size = stiffest.fold(0.0, f64::max) * motion.sum::<f64>() * extent.fold(0.0, f64::max);
    1e-12 * size
}

/// Load on the whole in `state`: the size of [`resultant`], by its component along [`along`].
pub fn applied(scene: &Scene, state: &State) -> f64 {
    dot(resultant(scene, state), along(scene, state))
}

/// Travel along [`along`] of what loads the scene: of the rigid plane that is driven or moved. Where
/// several load it, or planes and tractions do, the work of the forces that act on these travels over
/// the load. Under tractions alone, of their surfaces, weighted by the tractions. `None` where nothing
/// loads the scene, and where loads oppose each other.
pub fn descent(scene: &Scene, state: &State) -> Option<f64> {
    if oppose(scene, state) {
        return None;
    }
    let along = along(scene, state);
    let loads = |m: &PlaneMotion| match m {
        PlaneMotion::Driven(x) | PlaneMotion::Held(x) => *x != 0.0,
        PlaneMotion::Free => false,
    };
    let planes = scene.rigid_planes.iter().zip(&state.planes);
    let mut planes = planes.filter(|(plane, _)| plane.motion.iter().any(loads));
    let Some((_, first)) = planes.next() else {
        return travel_of_tractions(scene, state, along);
    };
    let first = dot(first.travel, along);
    if scene.tractions.is_empty() && planes.next().is_none() {
        return Some(first);
    }
    let size = norm(resultant(scene, state));
    Some(match size.is_finite() && size > 0.0 {
        true => work(scene, state).iter().sum::<f64>() / size,
        false => first,
    })
}

/// Is the [`descent`] of what is moved, and not loaded, a mean over motions that differ, which the forces weigh with which they are resisted? Along a
/// single axis it is what is prescribed.
pub fn is_mean_of_motions(scene: &Scene, state: &State) -> bool {
    let planes = scene.rigid_planes.iter();
    let mut moved = planes.flat_map(|plane| {
        let share = scene.factor(&plane.name, state.step, state.time);
        let motions = plane.motion.iter().enumerate();
        motions.filter_map(move |(axis, motion)| match motion {
            PlaneMotion::Held(u) if *u != 0.0 => Some((axis, u * share)),
            _ => None,
        })
    });
    let first = moved.next();
    moved.any(|other| Some(other) != first)
}

/// Of the work on the [`descent`], the share that prescribed forces do, and not prescribed motions.
pub fn forced_share(scene: &Scene, state: &State) -> f64 {
    let [forced, moved] = work(scene, state).map(f64::abs);
    if moved == 0.0 {
        1.0
    } else {
        forced / (forced + moved)
    }
}

/// Work of the forces that act in `state`, as they are now, on the travels of what they act on, of the whole: of
/// prescribed forces, and of those with which what is moved resists. A traction acts by its resultant on the mean of its
/// surface.
fn work(scene: &Scene, state: &State) -> [f64; 2] {
    let now = |name: &str| scene.factor(name, state.step, state.time);
    let others = driven_axes(scene).map(|driven| !driven);
    let loads = loads(scene);
    let (of_planes, of_tractions) = loads.split_at(scene.rigid_planes.len());
    let mut work = [0.0; 2];
    for ((plane, field), load) in (scene.rigid_planes.iter().zip(&state.planes)).zip(of_planes) {
        let given = scale(load.force, now(load.name));
        let forces = [given, moving_force(plane, field, others)];
        for (work, force) in work.iter_mut().zip(forces) {
            *work += dot(whole(scene, force), field.travel);
        }
    }
    for (traction, load) in scene.tractions.iter().zip(of_tractions) {
        let force = whole(scene, scale(load.force, now(load.name)));
        work[0] += dot(force, mean_travel(scene, state, traction));
    }
    work
}

/// Mean displacement of the surface of a traction.
fn mean_travel(scene: &Scene, state: &State, traction: &Traction) -> [f64; 3] {
    let (mut sum, mut total) = ([0.0; 3], 0.0);
    let surface = scene.mesh.surface(&traction.surface);
    for face in surface.into_iter().flat_map(|s| &s.faces) {
        let corners = face.corners(&scene.mesh);
        let moved = face.nodes.map(|n| state.displacement[n as usize]);
        integrate(&corners, |shape, weight| {
            let here = shape.iter().zip(moved);
            let here = here.fold([0.0; 3], |u, (n, at)| add(u, scale(at, *n)));
            sum = add(sum, scale(here, weight));
            total += weight;
        });
    }
    sum.map(|u| if total > 0.0 { u / total } else { 0.0 })
}

/// Displacement along `along`, averaged over the surfaces under traction with its component along
/// it as weight.
fn travel_of_tractions(scene: &Scene, state: &State, along: [f64; 3]) -> Option<f64> {
    let (mut work, mut load) = (0.0, 0.0);
    let now = |name: &str| scene.factor(name, state.step, state.time);
    // With all of the load taken off, its surfaces count as under all of it.
    let none = scene.tractions.iter().all(|t| now(&t.name) == 0.0);
    for traction in &scene.tractions {
        let factor = if none { 1.0 } else { now(&traction.name) };
        let surface = scene.mesh.surface(&traction.surface)?;
        for face in &surface.faces {
            let corners = face.corners(&scene.mesh);
            let moved = face
                .nodes
                .map(|n| dot(state.displacement[n as usize], along));
            let force = factor * dot(face_force(&traction.value, &corners), along);
            integrate(&corners, |shape, weight| {
                let travel: f64 = shape.iter().zip(moved).map(|(n, u)| n * u).sum();
                work += force / area(&corners) * travel * weight;
            });
            load += force;
        }
    }
    (load > 0.0).then(|| work / load)
}

/// Force of a traction on a face.
fn face_force(traction: &TractionValue, corners: &[[f64; 3]; 4]) -> [f64; 3] {
    match traction {
        TractionValue::Pressure(p) => area_vector(corners).map(|a| -p * a),
        TractionValue::Vector(t) => t.map(|t| t * area(corners)),
    }
}
