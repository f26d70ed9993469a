//! Largest pressure, semi-axes and balance of a contact.

use crate::answer::results::strip::{Strip, half_width};
use crate::product::converge::contact_profile::carrier;
use crate::proof::verify::kit::SolvedScene;
use crate::proof::verify::{LadderClaim, VerifyError};

pub use crate::product::converge::contact_profile::{ContactPoint, field, integral, misfit, spots};

/// Largest nodal pressure and the undeformed position of its node.
pub fn peak_pressure(run: &SolvedScene) -> Result<(f64, [f64; 3]), VerifyError> {
    let field = field(run.state())?;
    let nodes = field.nodes.iter().zip(&field.pressure);
    let peak = nodes.max_by(|a, b| a.1.total_cmp(b.1));
    let (node, pressure) = peak.ok_or(VerifyError::Missing("contact pressure"))?;
    Ok((*pressure, run.scene.mesh.points[*node as usize]))
}

/// Semi-axis along `axis` of a contact ellipse about the origin: ∫ p x² = (a²/5) ∫ p.
pub fn semi_axis(run: &SolvedScene, axis: usize) -> Result<f64, VerifyError> {
    let mesh = &run.scene.mesh;
    let strip = Strip {
        middle: Some(0.0),
        ..Strip::across(axis)
    };
    let surface = carrier(&run.scene)?;
    // A strip's half-width is twice the root mean square distance; an ellipse's √5 times.
    half_width(mesh, surface, field(run.state())?, &strip)
        .map(|width| 0.5 * 5f64.sqrt() * width)
        .ok_or(VerifyError::Missing("contact pressure"))
}

/// The force that the contact passes along `axis`, against the load on the modelled part.
pub fn balance(run: &SolvedScene, axis: usize, load: f64) -> Result<LadderClaim, VerifyError> {
    let force: f64 = field(run.state())?.force.iter().map(|f| f[axis]).sum();
    let claim = LadderClaim::small("contact force / load − 1", (force / load - 1.0).abs(), 1e-6);
    Ok(run.claim(
        claim
            .from("equilibrium")
            .because("the residual is 1e-8 of the load"),
    ))
}
