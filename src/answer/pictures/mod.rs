//! What pictures of an answer show: strips, sections, maps of pressure. Made only where something is drawn.

mod fields;
mod patch;
mod pressure;
mod section;
mod strip;
mod views;

pub use patch::Patch;
pub use pressure::PressureMap;
pub use section::{Plane, Section};
pub use strip::{Curve, StripPicture};
pub use views::View;

use crate::answer::Answer;
use crate::answer::results::load::upright;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::Scene;
use crate::model::state::State;

/// What pictures of a state show.
#[derive(Debug, Clone, PartialEq)]
pub struct Pictures {
    /// The axis nearest to the load, which is drawn upright.
    pub upright: usize,
    pub strips: Vec<StripPicture>,
    pub views: Vec<View>,
    pub pressures: Vec<PressureMap>,
    /// Contact pressure and plastic strain at the points of the bodies ([`Recovered::points`]).
    pub pressure: Vec<f64>,
    pub plastic_strain: Vec<f64>,
}

impl Pictures {
    /// Of the state that `answer` is about.
    pub fn of(scene: &Scene, state: &State, recovered: &Recovered, answer: &Answer) -> Self {
        let strips = strip::strips(scene, state, recovered);
        Self {
            upright: upright(scene),
            views: views::views((scene, recovered), answer, &strips),
            strips,
            pressures: pressure::pressure_maps(scene, state),
            pressure: fields::pressure(scene, state, recovered),
            plastic_strain: fields::plastic_strain(state, recovered),
        }
    }
}
