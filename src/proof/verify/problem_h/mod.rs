//! Problem H: a half cylinder pressed on a block, the yardstick of error against time.
//!
//! Half cylinder R = 1.5 in on a block 1.5 in deep and 3 in wide, both of E = 29500 ksi and
//! ν = 0.3, plane strain, 8.125 kip/in as uniform pressure on the cut face, frictionless. The gap
//! is taken along the contact normal on the undeformed geometry.

mod reading;

pub use crate::model::mesh::family::problem_h::{
    DEPTH, HALF_WIDTH, RADIUS, Sizes, full, full_twins, half, twins,
};
pub use reading::{Reading, read};

use super::VerifyError;
use super::kit;
use crate::model::material::Steel;
use crate::model::scene::Scene;

/// Load per length, kip/in.
pub const LOAD: f64 = 8.125;
/// Young's modulus, ksi, and Poisson's ratio.
pub const YOUNG: f64 = 29500.0;
pub const POISSON: f64 = 0.3;

/// Limits of fine meshes, ksi: the largest pressure is Hertz's; the peaks of Mises stress are
/// 1.8 % above and 0.4 % below Hertz's 93.20 ksi because the bodies are finite.
///
/// The Mises limits depend on which way the pressure leans, by up to x/R. Those of an independent
/// solver are 94.98 and 92.69 for a vertical gap, 94.80 and 92.90 along the cylinder's normal.
/// Brinell takes the normal of the block, which is flat.
pub const PRESSURE: f64 = 167.17;
pub const MISES_BLOCK: f64 = 94.98;
pub const MISES_CYLINDER: f64 = 92.69;

/// The half model, ready to be solved.
pub fn scene(sizes: &Sizes) -> Result<Scene, VerifyError> {
    let mut scene = kit::scene("problem H", half(sizes)?, Steel::elastic(YOUNG, POISSON));
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

/// Two identical half cylinders on mirrored meshes, pressed together by moving their cut faces
/// towards each other by `approach` in all, with Coulomb's coefficient `friction`.
pub fn twin_scene(sizes: &Sizes, approach: f64, friction: f64) -> Result<Scene, VerifyError> {
    let mut scene = kit::scene("twins", twins(sizes)?, Steel::elastic(YOUNG, POISSON));
    let mut pair = kit::pair("cylinder-lower", "cylinder_contact", "lower_contact");
    pair.friction = friction;
    scene.contacts = vec![pair];
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
