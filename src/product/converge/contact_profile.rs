//! Pressure and traction along a contact surface, interpolated as the contact method does.

use super::error::Missing;
use crate::answer::results::quad::integrate;
use crate::model::mesh::Surface;
use crate::model::scene::Scene;
use crate::model::state::{ContactField, State};

/// What a quadrature point of a contact surface sees.
#[derive(Debug, Clone, Copy)]
pub struct ContactPoint {
    /// Undeformed position, on the facet.
    pub at: [f64; 3],
    pub pressure: f64,
    /// Tangential traction on the lower body along x.
    pub traction: f64,
    pub area: f64,
}

/// All quadrature points of the carrier (upper) surface of the first contact pair.
///
/// # Errors
/// [`Missing`] where there is no pair, or no such surface.
pub fn spots(scene: &Scene, state: &State) -> Result<Vec<ContactPoint>, Missing> {
    let field = field(state)?;
    let at_node =
        |values: &[f64], node: u32| field.nodes.binary_search(&node).map_or(0.0, |i| values[i]);
    let along_x: Vec<f64> = field.traction.iter().map(|t| t[0]).collect();
    let mut spots = Vec::new();
    for face in &carrier(scene)?.faces {
        let corners = face.corners(&scene.mesh);
        let nodal = |values: &[f64]| face.nodes.map(|n| at_node(values, n));
        let (pressure, traction) = (nodal(&field.pressure), nodal(&along_x));
        integrate(&corners, |shape, area| {
            let sum = |v: &[f64; 4]| shape.iter().zip(v).map(|(n, v)| n * v).sum::<f64>();
            spots.push(ContactPoint {
                at: [0, 1, 2].map(|i| sum(&corners.map(|c| c[i]))),
                pressure: sum(&pressure),
                traction: sum(&traction),
                area,
            });
        });
    }
    Ok(spots)
}

/// The field of the first contact pair.
///
/// # Errors
/// [`Missing`] where there is no pair.
pub fn field(state: &State) -> Result<&ContactField, Missing> {
    state.contacts.first().ok_or(Missing("contact pair"))
}

/// The upper surface of the first contact pair, which carries its pressure.
///
/// # Errors
/// [`Missing`] where there is none.
pub fn carrier(scene: &Scene) -> Result<&Surface, Missing> {
    let pair = scene.contacts.first().ok_or(Missing("carrier surface"))?;
    pair.upper.surface(&scene.mesh).ok_or(Missing("surface"))
}

/// Integral of `f` over the spots.
pub fn integral(spots: &[ContactPoint], f: impl Fn(&ContactPoint) -> f64) -> f64 {
    spots.iter().map(|s| f(s) * s.area).sum()
}

/// L2 norm of `value` less `exact` over that of `exact`.
///
/// # Errors
/// Those of `exact`.
pub fn misfit<E>(
    spots: &[ContactPoint],
    value: impl Fn(&ContactPoint) -> f64,
    exact: impl Fn(&ContactPoint) -> Result<f64, E>,
) -> Result<f64, E> {
    let (mut miss, mut norm) = (0.0, 0.0);
    for spot in spots {
        let exact = exact(spot)?;
        miss += spot.area * (value(spot) - exact).powi(2);
        norm += spot.area * exact * exact;
    }
    Ok((miss / norm).sqrt())
}
