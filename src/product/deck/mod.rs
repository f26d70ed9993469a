//! From a scene to what a deck for another program needs to know of it: the faces that may touch, springs until they
//! do, and tractions as forces on nodes. [`inp`](crate::render::inp) writes it.

mod bounds;
mod driven;
mod error;
mod heat;
mod pairs;
mod springs;
mod ties;
mod tractions;
mod turning;

pub use error::InpError;

use crate::model::scene::Scene;
use crate::render::inp::{Deck, Names, Settings};
use driven::{driven, held};
use pairs::{default_stiffness, pairs};
use springs::{LOAD_SHARE, springs};
use tractions::nodal_forces;

/// Makes sure that `scene` can be expressed, its bodies in touch.
///
/// # Errors
/// [`InpError`] names what cannot be expressed.
pub fn check<'a>(scene: &'a Scene, settings: &'a Settings) -> Result<Deck<'a>, InpError> {
    let positive = |what, value: Option<f64>| match value {
        Some(value) if !(value > 0.0 && value.is_finite()) => {
            Err(InpError::NotPositive { what, value })
        }
        _ => Ok(()),
    };
    positive("the contact stiffness", settings.contact_stiffness)?;
    positive("the closing motion", settings.closing)?;
    positive("the first increment", settings.increment)?;
    if !scene.mesh.hanging.is_empty() {
        let nodes = scene.mesh.hanging.len();
        return Err(InpError::Hanging { nodes });
    }
    let mut names = Names::new(&scene.mesh);
    let pairs = pairs(scene, &mut names)?;
    let ties = ties::ties(scene, &mut names)?;
    let mut held = held(scene)?;
    let mut driven = driven(scene, &mut held)?;
    let turning = turning::turning(scene, &mut names, &mut driven, &mut held)?;
    let springs = springs(scene, &mut names);
    let nodal_forces = (scene.steps.iter())
        .map(|step| nodal_forces(scene, step))
        .collect();
    let stiffness = settings.contact_stiffness;
    Ok(Deck {
        stiffness: stiffness.unwrap_or_else(|| default_stiffness(scene, &pairs)),
        scene,
        settings,
        names,
        pairs,
        ties,
        driven,
        turning,
        springs,
        spring_share: LOAD_SHARE,
        nodal_forces,
        heat: heat::heat(scene)?,
    })
}
