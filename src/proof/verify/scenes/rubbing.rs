//! Two equal half cylinders pressed together, then pushed sideways.
//!
//! Equal bodies on mirrored meshes: the push shears both alike and opens no gap, so that pressure
//! and shear do not touch each other (Dundurs' β = 0, here exactly). The half discs of problem H
//! carry twice its load, so that the half-width is the same, a = R/48. Their cut faces do not turn.

use super::problem_h::{LOAD, POISSON, RADIUS, Sizes, YOUNG, full_twins, twin_contact};
use crate::analytic::hertz::LineContact;
use crate::model::material::Steel;
use crate::model::scene::{PlaneMotion, Scene, Step};
use crate::proof::verify::VerifyError;
use crate::proof::verify::kit;

/// How the upper cut face is pushed along +x once it carries the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Push {
    /// By a force per length.
    Force(f64),
    /// By a displacement.
    Travel(f64),
}

/// Load per length.
pub const NORMAL: f64 = 2.0 * LOAD;

/// The contact on half planes.
pub fn hertz() -> Result<LineContact, VerifyError> {
    let compliance = 2.0 * (1.0 - POISSON * POISSON) / YOUNG;
    Ok(LineContact::new(NORMAL, 0.5 * RADIUS, compliance)?)
}

/// First all of the load, then all of the push while the load stays.
pub fn scene(sizes: &Sizes, friction: f64, push: Push) -> Result<Scene, VerifyError> {
    let mesh = full_twins(sizes)?;
    let thickness = mesh.extent(2);
    let mut scene = Scene::bare("rubbing", mesh, Steel::elastic(YOUNG, POISSON));
    scene.contacts = vec![twin_contact(friction)];
    scene.supports = vec![
        kit::support("bottom", [Some(0.0); 3]),
        kit::held("back", 2),
        kit::held("front", 2),
    ];
    let sideways = match push {
        Push::Force(force) => {
            let per_area = [force / (2.0 * RADIUS), 0.0, 0.0];
            scene.tractions = vec![kit::traction("push", "top", per_area)];
            // All nodes alike; the force itself is that of the traction.
            PlaneMotion::Driven(0.0)
        }
        Push::Travel(travel) => {
            let mut support = kit::support("top", [Some(travel), None, None]);
            support.name = "push".into();
            scene.supports.push(support);
            PlaneMotion::Free
        }
    };
    let load = PlaneMotion::Driven(-NORMAL * thickness);
    let motion = [sideways, load, PlaneMotion::Free];
    scene.rigid_planes = vec![kit::plane("press", "top", motion)];
    let mut press = Step::to("press", 1.0);
    press.factors = vec![("push".into(), 0.0)];
    scene.steps = vec![press, Step::to("push", 1.0)];
    Ok(scene)
}
