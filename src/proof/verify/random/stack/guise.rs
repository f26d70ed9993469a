//! The same stack turned, in other units, numbered otherwise, and solved in other ways.

use super::check::largest;
use super::draw::Stack;
use crate::ground::geometry::{Vec3, norm, scale, sub};
use crate::model::material::mises;
use crate::model::scene::{Scene, SolverKind, TractionValue};
use crate::model::state::State;
use nalgebra::{Rotation3, Unit, Vector3};

/// Largest relative difference between guises of the same equations, which rounding and the residual of 1e-8 make.
const ROUNDING_DIFFERENCE: f64 = 1e-6;

/// Largest relative difference where the same scene is solved in another way, so that iterations end elsewhere within
/// their tolerance.
pub const ROUTE_DIFFERENCE: f64 = 1e-5;

/// The same stack in another guise.
pub struct Guise {
    pub what: &'static str,
    pub scene: Scene,
    /// Its node in the place of each, and what becomes of a displacement.
    node: Box<dyn Fn(usize) -> usize>,
    element: Box<dyn Fn(usize) -> usize>,
    /// What becomes of a stress.
    stress: f64,
    back: Box<dyn Fn(Vec3) -> Vec3>,
    /// Relative difference that there may be.
    pub within: f64,
}

impl Guise {
    /// By how much `other`, of this guise, is off `state`: displacements, over the largest, and stresses, over the
    /// largest Mises stress. Only stresses where a body can slide with nothing that drives it.
    pub fn off(&self, stack: &Stack, state: &State, other: &State) -> f64 {
        let moved = largest(state.displacement.iter().map(|u| norm(*u)));
        let stress = |state: &State, element: usize| state.stress[element].map(|s| mises(&s));
        let elements = 0..stack.scene.mesh.hexes.len();
        let stressed = largest(elements.clone().flat_map(|e| stress(state, e)));
        let nodes = state.displacement.iter().enumerate();
        let apart = |(node, u): (usize, &Vec3)| {
            let there = (self.back)(other.displacement[(self.node)(node)]);
            norm(sub(there, *u))
        };
        let displaced = match stack.slides {
            true => 0.0,
            false => largest(nodes.map(apart)) / moved,
        };
        displaced.max(largest(elements.flat_map(|e| {
            let there = stress(other, (self.element)(e)).map(|s| s / self.stress);
            let here = stress(state, e);
            [0, 1, 2, 3, 4, 5, 6, 7].map(|i| (there[i] - here[i]).abs() / stressed)
        })))
    }
}

/// All guises in which a stack is solved again.
pub fn guises(scene: &Scene) -> [Guise; 6] {
    let penalised = |what, times| {
        let mut scene = scene.clone();
        let pairs = scene.contacts.iter_mut();
        pairs.for_each(|pair| pair.penalty_factor *= times);
        restated(what, scene, ROUTE_DIFFERENCE)
    };
    let mut divided = scene.clone();
    divided.controls.solver = SolverKind::Divided;
    [
        turned(scene),
        scaled(scene),
        renumbered(scene),
        penalised("with a hundredth of the penalty", 0.01),
        penalised("with a hundred times the penalty", 100.0),
        restated("divided", divided, ROUTE_DIFFERENCE),
    ]
}

/// A scene with the same nodes and elements, in the same axes and units.
pub fn restated(what: &'static str, scene: Scene, within: f64) -> Guise {
    Guise {
        what,
        scene,
        node: Box::new(|node| node),
        element: Box::new(|element| element),
        stress: 1.0,
        back: Box::new(|u| u),
        within,
    }
}

fn turned(scene: &Scene) -> Guise {
    let axis = Unit::new_normalize(Vector3::new(0.48, 0.6, 0.64));
    let rotation = Rotation3::from_axis_angle(&axis, 1.1);
    let turn = move |v: Vec3| (rotation * Vector3::from(v)).into();
    Guise {
        back: Box::new(move |u| (rotation.inverse() * Vector3::from(u)).into()),
        ..restated("turned", moved(scene, turn, turn), ROUNDING_DIFFERENCE)
    }
}

/// From metres and megapascals to micrometres and kilopascals.
fn scaled(scene: &Scene) -> Guise {
    const LENGTH: f64 = 1e6;
    const STRESS: f64 = 1e3;
    let mut scene = moved(scene, |p| scale(p, LENGTH), |t| scale(t, STRESS));
    for steel in &mut scene.materials {
        steel.youngs_modulus *= STRESS;
        steel.yield_stress *= STRESS;
        steel.hardening_modulus *= STRESS;
    }
    Guise {
        stress: STRESS,
        back: Box::new(|u| scale(u, 1.0 / LENGTH)),
        ..restated("in other units", scene, ROUNDING_DIFFERENCE)
    }
}

/// With other points and other tractions.
fn moved(scene: &Scene, point: impl Fn(Vec3) -> Vec3, traction: impl Fn(Vec3) -> Vec3) -> Scene {
    let mut scene = scene.clone();
    for p in &mut scene.mesh.points {
        *p = point(*p);
    }
    for load in &mut scene.tractions {
        if let TractionValue::Vector(t) = &mut load.value {
            *t = traction(*t);
        }
    }
    scene
}

/// Nodes, and elements within their bodies, from the last to the first.
fn renumbered(scene: &Scene) -> Guise {
    let mut scene = scene.clone();
    let mesh = &mut scene.mesh;
    let last = mesh.points.len() - 1;
    let node = move |node: u32| last as u32 - node;
    mesh.points.reverse();
    mesh.hexes.iter_mut().flatten().for_each(|n| *n = node(*n));
    let bodies = mesh.bodies.clone();
    for body in &bodies {
        mesh.hexes[body.elements.clone()].reverse();
    }
    let element = move |element: usize| {
        let body = bodies.iter().find(|b| b.elements.contains(&element));
        body.map_or(element, |b| b.elements.start + b.elements.end - 1 - element)
    };
    for face in mesh.surfaces.iter_mut().flat_map(|s| &mut s.faces) {
        face.nodes = face.nodes.map(node);
        face.element = element(face.element as usize) as u32;
    }
    Guise {
        node: Box::new(move |node| last - node),
        element: Box::new(element),
        ..restated("numbered otherwise", scene, ROUNDING_DIFFERENCE)
    }
}
