//! Pressure and traction along a contact surface, interpolated as the contact method does.

use super::kit::{Run, at_node, surface};
use super::{Claim, VerifyError};
use crate::analytic::DomainError;
use crate::answer::results::quad::integrate;
use crate::answer::results::strip::{Strip, half_width};
use crate::model::scene::{Partner, Scene};
use crate::model::state::{ContactField, State};

/// What a quadrature point of a contact surface sees.
#[derive(Debug, Clone, Copy)]
pub struct Spot {
    /// Undeformed position, on the facet.
    pub at: [f64; 3],
    pub pressure: f64,
    /// Tangential traction on the lower body along x.
    pub traction: f64,
    pub area: f64,
}

/// All quadrature points of the carrier (upper) surface of the first contact pair.
pub fn spots(scene: &Scene, state: &State) -> Result<Vec<Spot>, VerifyError> {
    let field = field(state)?;
    let along_x: Vec<f64> = field.traction.iter().map(|t| t[0]).collect();
    let mut spots = Vec::new();
    for face in &surface(&scene.mesh, carrier(scene)?)?.faces {
        let corners = face.corners(&scene.mesh);
        let nodal = |values: &[f64]| face.nodes.map(|n| at_node(field, values, n));
        let (pressure, traction) = (nodal(&field.pressure), nodal(&along_x));
        integrate(&corners, |shape, area| {
            let sum = |v: &[f64; 4]| shape.iter().zip(v).map(|(n, v)| n * v).sum::<f64>();
            spots.push(Spot {
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
pub fn field(state: &State) -> Result<&ContactField, VerifyError> {
    state
        .contacts
        .first()
        .ok_or(VerifyError::Missing("contact pair"))
}

fn carrier(scene: &Scene) -> Result<&str, VerifyError> {
    match scene.contacts.first().map(|pair| &pair.upper) {
        Some(Partner::Surface(name)) => Ok(name),
        _ => Err(VerifyError::Missing("carrier surface")),
    }
}

/// Integral of `f` over the spots.
pub fn integral(spots: &[Spot], f: impl Fn(&Spot) -> f64) -> f64 {
    spots.iter().map(|s| f(s) * s.area).sum()
}

/// L2 norm of `value` less `exact` over that of `exact`.
pub fn misfit(
    spots: &[Spot],
    value: impl Fn(&Spot) -> f64,
    exact: impl Fn(&Spot) -> Result<f64, DomainError>,
) -> Result<f64, VerifyError> {
    let (mut miss, mut norm) = (0.0, 0.0);
    for spot in spots {
        let exact = exact(spot)?;
        miss += spot.area * (value(spot) - exact).powi(2);
        norm += spot.area * exact * exact;
    }
    Ok((miss / norm).sqrt())
}

/// Largest nodal pressure and the undeformed position of its node.
pub fn peak_pressure(run: &Run) -> Result<(f64, [f64; 3]), VerifyError> {
    let field = field(run.state())?;
    let nodes = field.nodes.iter().zip(&field.pressure);
    let peak = nodes.max_by(|a, b| a.1.total_cmp(b.1));
    let (node, pressure) = peak.ok_or(VerifyError::Missing("contact pressure"))?;
    Ok((*pressure, run.scene.mesh.points[*node as usize]))
}

/// Semi-axis along `axis` of a contact ellipse about the origin: ∫ p x² = (a²/5) ∫ p.
pub fn semi_axis(run: &Run, axis: usize) -> Result<f64, VerifyError> {
    let mesh = &run.scene.mesh;
    let strip = Strip {
        middle: Some(0.0),
        ..Strip::across(axis)
    };
    let surface = surface(mesh, carrier(&run.scene)?)?;
    // A strip's half-width is twice the root mean square distance; an ellipse's √5 times.
    half_width(mesh, surface, field(run.state())?, &strip)
        .map(|width| 0.5 * 5f64.sqrt() * width)
        .ok_or(VerifyError::Missing("contact pressure"))
}

/// The force that the contact passes along `axis`, against the load on the modelled part.
pub fn balance(run: &Run, axis: usize, load: f64) -> Result<Claim, VerifyError> {
    let force: f64 = field(run.state())?.force.iter().map(|f| f[axis]).sum();
    let claim = Claim::small("contact force / load − 1", (force / load - 1.0).abs(), 1e-6);
    Ok(run.claim(
        claim
            .from("equilibrium")
            .because("the residual is 1e-8 of the load"),
    ))
}
