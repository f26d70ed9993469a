//! Figures of ties.

use super::named::Named;
use super::results::load::{cutting_all, times, whole_of};
use crate::ground::geometry::{add, norm};
use crate::model::scene::{Scene, Tie};
use crate::model::state::{State, TieField};
use serde::Serialize;

/// What a tie carries; forces and areas are those of the whole of its two bodies.
#[derive(Debug, Clone, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TieFigures {
    /// The two surfaces, in the order of the scene.
    pub surfaces: [String; 2],
    /// The one of them whose nodes follow the other one.
    pub follows: String,
    /// Of the first surface on the second one.
    pub force: [f64; 3],
    /// Integral of the normal stress; compression positive.
    pub pressure_integral: f64,
    /// Largest normal stress of a node, compression positive,
    pub max_pressure: f64,
    /// the largest the other way, tension positive,
    pub max_tension: f64,
    /// and the largest shear stress.
    pub max_shear: f64,
    /// Where the largest of these three is, undeformed.
    pub at: Option<[f64; 3]>,
    /// Area that is joined.
    pub area: f64,
    /// Share of the surface that follows which the other one covers.
    pub covered: f64,
    /// The largest distance that is bridged, a length.
    pub distance: f64,
}

/// The figures of every tie of `scene`, by name.
pub fn ties(scene: &Scene, state: &State) -> Named<TieFigures> {
    let both = scene.ties.iter().zip(&state.ties);
    let of = both.map(|(tie, field)| {
        let figures = TieFigures {
            surfaces: tie.surfaces.clone(),
            follows: tie.surfaces[field.follows].clone(),
            ..figures(scene, tie, field)
        };
        (tie.name.clone(), figures)
    });
    Named(of.collect())
}

fn figures(scene: &Scene, tie: &Tie, field: &TieField) -> TieFigures {
    let modelled = field.force.iter().fold([0.0; 3], |sum, f| add(sum, *f));
    // A tie beside a mirror plane has an image that is another tie.
    let surfaces = tie.surfaces.iter();
    let bodies = surfaces.filter_map(|name| scene.mesh.surface(name)?.body(&scene.mesh));
    let mirrors = cutting_all(scene, bodies);
    let times = times(&mirrors);
    let carried = field.pressure.iter().zip(&field.area);
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let size = |at: usize| field.pressure[at].abs().max(norm(field.shear[at]));
    let peak = (0..field.nodes.len()).max_by(|a, b| size(*a).total_cmp(&size(*b)));
    TieFigures {
        force: whole_of(&mirrors, modelled),
        pressure_integral: times * carried.map(|(p, a)| p * a).sum::<f64>(),
        max_pressure: most(&mut field.pressure.iter().copied()),
        max_tension: most(&mut field.pressure.iter().map(|p| -p)),
        max_shear: most(&mut field.shear.iter().map(|s| norm(*s))),
        at: peak.and_then(|at| Some(*scene.mesh.points.get(field.nodes[at] as usize)?)),
        area: times * field.area.iter().sum::<f64>(),
        covered: field.covered,
        distance: field.distance,
        ..TieFigures::default()
    }
}
