//! What is read from a solution of problem H.

use super::limits::{HALF_WIDTH, LOAD, PRESSURE};
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::peaks::{BodyPeaks, Peak, peaks};
use crate::answer::results::recovery::recover;
use crate::answer::results::strip::{Strip, half_width};
use crate::ground::geometry::norm;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::product::converge::contact_profile::{misfit, spots};
use crate::product::converge::energy;
use crate::product::converge::error::Missing;

/// The three Mises peaks of a body, ksi.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Mises {
    pub centroid: f64,
    pub nodal: f64,
    pub integration_point: f64,
}

/// Scalars of a solution of problem H.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ProblemHReading {
    /// Largest nodal pressure, ksi, and the |x| where it is, in.
    pub pressure: f64,
    pub pressure_at: f64,
    /// 2 √(∫ p x² / ∫ p), in.
    pub half_width: f64,
    pub block: Mises,
    pub cylinder: Mises,
    /// Contact force over the load, less one.
    pub balance: f64,
    /// L2 norm of the pressure's distance from Hertz's half ellipse, over the ellipse's.
    pub profile: f64,
    /// Potential energy per thickness of the half model, kip.
    pub energy: f64,
    /// Largest tangential traction over the largest pressure.
    pub shear: f64,
}

/// Reads `state` of problem H, or of its twins.
///
/// # Errors
/// [`Missing`] where there is no contact pressure.
pub fn read(scene: &Scene, state: &State) -> Result<ProblemHReading, Missing> {
    let thickness = scene.mesh.extent(2);
    let field = &state.contacts[0];
    let surface = scene
        .mesh
        .surface("cylinder_contact")
        .ok_or(Missing("surface"))?;
    let top =
        (0..field.nodes.len()).max_by(|a, b| field.pressure[*a].total_cmp(&field.pressure[*b]));
    let top = top.ok_or(Missing("contact pressure"))?;
    let pressure = field.pressure[top];
    let strip = Strip {
        middle: Some(0.0),
        ..Strip::across(0)
    };
    let force: f64 = field.force.iter().map(|f| f[1]).sum();
    let hertz = |x: f64| PRESSURE * (1.0 - (x / HALF_WIDTH).powi(2)).max(0.0).sqrt();
    let profile = misfit(
        &spots(scene, state)?,
        |s| s.pressure,
        |s| Ok::<_, Missing>(hertz(s.at[0])),
    )?;
    let recovered = recover(scene, state);
    let bodies = peaks(
        (scene, state),
        &recovered,
        &SingularEdges::find(scene, state),
        &[],
    );
    let of = |name: &str| {
        bodies
            .iter()
            .find(|b| b.name == name)
            .map_or(Mises::default(), mises)
    };
    let shears = field.traction.iter().map(|t| norm(*t));
    Ok(ProblemHReading {
        pressure,
        pressure_at: scene.mesh.points[field.nodes[top] as usize][0].abs(),
        half_width: half_width(&scene.mesh, surface, field, &strip).ok_or(Missing("half-width"))?,
        block: of("block"),
        cylinder: of("cylinder"),
        balance: -force / (0.5 * LOAD * thickness) - 1.0,
        profile,
        energy: energy::potential(scene, state) / thickness,
        shear: shears.fold(0.0, f64::max) / pressure,
    })
}

fn mises(peaks: &BodyPeaks) -> Mises {
    let value = |peak: &Option<Peak>| peak.as_ref().map_or(0.0, |p| p.value);
    Mises {
        centroid: value(&peaks.centroid),
        nodal: value(&peaks.nodal),
        integration_point: value(&peaks.integration_point),
    }
}
