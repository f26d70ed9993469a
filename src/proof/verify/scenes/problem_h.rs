//! The scenes of problem H and of its twins.

use crate::model::material::Steel;
use crate::model::mesh::family::problem_h::{half, twins};
use crate::model::scene::{ContactPair, Scene};
use crate::proof::verify::VerifyError;
use crate::proof::verify::kit;

pub use crate::model::mesh::family::problem_h::{DEPTH, RADIUS, Sizes, full_twins};
pub use crate::product::converge::problem_h::{
    HALF_WIDTH, LOAD, MISES_BLOCK, MISES_CYLINDER, MISES_SOURCE, POISSON, PRESSURE,
    ProblemHReading, YOUNG, read,
};

/// The half model, ready to be solved.
pub fn scene(sizes: &Sizes) -> Result<Scene, VerifyError> {
    let mut scene = Scene::bare("problem H", half(sizes)?, Steel::elastic(YOUNG, POISSON));
    scene.contacts = vec![kit::pair(
        "cylinder-block",
        "cylinder_contact",
        "block_contact",
    )];
    scene.supports = vec![
        kit::support("base", [Some(0.0); 3]),
        kit::held("symmetry", 0),
        kit::held("back", 2),
        kit::held("front", 2),
    ];
    scene.tractions = vec![kit::pressure("top", LOAD / (2.0 * RADIUS))];
    scene.mirrors = vec![0];
    Ok(scene)
}

/// Contact of the twins.
pub(super) fn twin_contact(friction: f64) -> ContactPair {
    ContactPair {
        friction,
        ..kit::pair("cylinder-lower", "cylinder_contact", "lower_contact")
    }
}

/// Two identical half cylinders on mirrored meshes, pressed together by moving their cut faces
/// towards each other by `approach` in all, with Coulomb's coefficient `friction`.
pub fn twin_scene(sizes: &Sizes, approach: f64, friction: f64) -> Result<Scene, VerifyError> {
    let mut scene = Scene::bare("twins", twins(sizes)?, Steel::elastic(YOUNG, POISSON));
    scene.contacts = vec![twin_contact(friction)];
    scene.supports = vec![
        kit::support("top", [None, Some(-0.5 * approach), None]),
        kit::support("bottom", [None, Some(0.5 * approach), None]),
        kit::held("symmetry", 0),
        kit::held("back", 2),
        kit::held("front", 2),
    ];
    scene.mirrors = vec![0];
    Ok(scene)
}
