//! Solving a stack, and looking at its answer from all sides.

use super::outcome::{self, Verdict};
use super::scene::{self, Stack};
use super::watch::Watch;
use crate::answer::certify::DOUBLING;
use crate::ground::geometry::{Vec3, add, norm, scale, sub};
use crate::model::material::mises;
use crate::model::scene::{Scene, SolverKind, TractionValue};
use crate::model::state::State;
use crate::product::converge::energy::strain_energy;
use crate::solver::solve::{self, SolveError};
use nalgebra::{Rotation3, Unit, Vector3};

/// Relative error of forces and energies in balance.
const BALANCED: f64 = 1e-6;

/// Relative difference of displacements of the same stack turned, in other units and with other numbers,
const SAME: f64 = 1e-6;
/// and of the same stack solved in another way.
const ALIKE: f64 = 1e-5;

/// Overlap that the meshes do not explain, over the largest displacement.
const OVERLAP: f64 = 1e-3;

/// Solves stack `number` of a seed, and the same in other guises.
pub fn solve(seed: u64, number: usize, watch: &mut Watch) -> Verdict {
    let stack = match scene::stack(seed, number) {
        Ok(stack) => stack,
        Err(error) => {
            let why = format!("not meshed: {error}");
            return Verdict::Unexplained { why };
        }
    };
    match solved(&stack.scene, watch) {
        Ok(Some(answer)) => {
            let state = &answer.state;
            let others = match check(&stack, state) {
                Some(failed) => Others {
                    differ: vec![failed],
                    ..Others::default()
                },
                None => others(&stack, &answer),
            };
            match others.unsolved.is_empty() || !others.differ.is_empty() {
                true => {
                    let failed = told(&others.differ);
                    outcome::solved(&stack.known, failed, overlap(&stack, state))
                }
                false => Verdict::Unexplained {
                    why: others.unsolved.join("; "),
                },
            }
        }
        Ok(None) => outcome::late(),
        Err(error) => outcome::refused(&stack.known, &error),
    }
}

/// The end of the last step.
struct Answer {
    state: State,
    /// The same in increments twice as large, where it depends on them.
    doubled: Option<State>,
    /// Ends of the increments.
    times: Vec<f64>,
}

/// `None` where it took too long.
fn solved(scene: &Scene, watch: &mut Watch) -> Result<Option<Answer>, SolveError> {
    let mut scene = scene.clone();
    let mut solution = solve::solve(&mut scene, watch)?;
    Ok(solution.complete.then(|| Answer {
        state: solution.last,
        doubled: solution.doubled.pop(),
        times: watch.times.clone(),
    }))
}

/// What does not hold of the answer.
fn check(stack: &Stack, state: &State) -> Option<String> {
    let size = norm(stack.force);
    for (pair, field) in stack.scene.contacts.iter().zip(&state.contacts) {
        let force = field.force.iter().fold([0.0; 3], |sum, f| add(sum, *f));
        let off = norm(sub(force, stack.force)) / size;
        if !(off <= BALANCED) {
            return Some(format!("{}: the force is off by {off:.1e}", pair.name));
        }
        let most = largest(field.pressure.iter().copied());
        let slips = field.traction.iter().zip(&field.pressure);
        let beyond = slips.map(|(t, p)| norm(*t) - pair.friction * p.max(0.0));
        let beyond = largest(beyond) / most;
        if !(beyond <= BALANCED) {
            return Some(format!(
                "{}: beyond Coulomb's law by {beyond:.1e}",
                pair.name
            ));
        }
    }
    let Some(energy) = state.energy else {
        return Some("its energy is not known".into());
    };
    let spent = energy.elastic + energy.plastic + energy.friction + energy.contact;
    let lost = (energy.work - spent).abs() / energy.turned_over;
    let stored = (strain_energy(&stack.scene, state) - energy.elastic).abs() / energy.turned_over;
    let worst = lost.max(stored);
    (!(worst <= BALANCED)).then(|| format!("energy is off by {worst:.1e}"))
}

/// Overlap that the meshes do not explain, where it is too much.
fn overlap(stack: &Stack, state: &State) -> Option<String> {
    let pairs = stack.scene.contacts.iter().zip(&state.contacts);
    let moved = largest(state.displacement.iter().map(|u| norm(*u)));
    let overlaps = pairs.map(|(pair, field)| (field.unexplained / moved, &pair.name));
    let (worst, name) = overlaps.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (!(worst <= OVERLAP)).then(|| format!("{name}: an overlap of {worst:.1e}"))
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

/// The same stack in another guise.
struct Guise {
    what: &'static str,
    scene: Scene,
    /// Its node in the place of each, and what becomes of a displacement.
    node: Box<dyn Fn(usize) -> usize>,
    element: Box<dyn Fn(usize) -> usize>,
    /// What becomes of a stress.
    stress: f64,
    back: Box<dyn Fn(Vec3) -> Vec3>,
    /// Relative difference that there may be.
    within: f64,
}

impl Guise {
    /// By how much `other`, of this guise, is off `state`: displacements, over the largest, and stresses, over the
    /// largest Mises stress. Only stresses where a body can slide with nothing that drives it.
    fn off(&self, stack: &Stack, state: &State, other: &State) -> f64 {
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

/// What came of the other guises.
#[derive(Default)]
struct Others {
    /// Those with another answer,
    differ: Vec<String>,
    /// and those with none.
    unsolved: Vec<String>,
}

/// Solves the other guises. Where one was cut back and the other was not, the two answers are off by what increments do
/// to them: no more than twice what that is said to be.
fn others(stack: &Stack, answer: &Answer) -> Others {
    let scene = &stack.scene;
    let guises = [
        turned(scene),
        scaled(scene),
        renumbered(scene),
        penalised("with a hundredth of the penalty", scene, 0.01),
        penalised("with a hundred times the penalty", scene, 100.0),
        divided(scene),
    ];
    let same = otherwise("as it is", scene.clone());
    let doubled = answer.doubled.as_ref();
    let of_increments = doubled.map_or(0.0, |d| 2.0 * DOUBLING * same.off(stack, &answer.state, d));
    let mut others = Others::default();
    for guise in &guises {
        let mut watch = Watch::start();
        let what = guise.what;
        match solved(&guise.scene, &mut watch) {
            Ok(Some(other)) => {
                let off = guise.off(stack, &answer.state, &other.state);
                let more = match other.times == answer.times {
                    true => 0.0,
                    false => of_increments,
                };
                if !(off <= guise.within + more) {
                    (others.differ).push(format!("{what}: the answer differs by {off:.1e}"));
                }
            }
            Ok(None) => others.unsolved.push(format!("{what}: {}", outcome::LATE)),
            Err(error) => others.unsolved.push(format!("{what}: {error}")),
        }
    }
    others
}

fn told(what: &[String]) -> Option<String> {
    (!what.is_empty()).then(|| what.join("; "))
}

fn turned(scene: &Scene) -> Guise {
    let axis = Unit::new_normalize(Vector3::new(0.48, 0.6, 0.64));
    let rotation = Rotation3::from_axis_angle(&axis, 1.1);
    let turn = move |v: Vec3| (rotation * Vector3::from(v)).into();
    Guise {
        what: "turned",
        scene: moved(scene, turn, turn),
        node: Box::new(|node| node),
        element: Box::new(|element| element),
        stress: 1.0,
        back: Box::new(move |u| (rotation.inverse() * Vector3::from(u)).into()),
        within: SAME,
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
        what: "in other units",
        scene,
        node: Box::new(|node| node),
        element: Box::new(|element| element),
        stress: STRESS,
        back: Box::new(|u| scale(u, 1.0 / LENGTH)),
        within: SAME,
    }
}

fn penalised(what: &'static str, scene: &Scene, times: f64) -> Guise {
    let mut scene = scene.clone();
    let pairs = scene.contacts.iter_mut();
    pairs.for_each(|pair| pair.penalty_factor *= times);
    otherwise(what, scene)
}

fn divided(scene: &Scene) -> Guise {
    let mut scene = scene.clone();
    scene.controls.solver = SolverKind::Divided;
    otherwise("divided", scene)
}

/// The same scene, solved in another way.
fn otherwise(what: &'static str, scene: Scene) -> Guise {
    Guise {
        what,
        scene,
        node: Box::new(|node| node),
        element: Box::new(|element| element),
        stress: 1.0,
        back: Box::new(|u| u),
        within: ALIKE,
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
        what: "numbered otherwise",
        scene,
        node: Box::new(move |node| last - node),
        element: Box::new(element),
        stress: 1.0,
        back: Box::new(|u| u),
        within: SAME,
    }
}
