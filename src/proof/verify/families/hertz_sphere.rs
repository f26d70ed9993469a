//! A sphere on a rigid flat.
//!
//! A block with a spherical face, 10 contact radii wide and deep: what is left out softens the
//! body by the cube of 1/10. Reference: Hertz and Huber's field on the axis.

use crate::analytic::hertz::PointContact;
use crate::analytic::subsurface::SphereField;
use crate::answer::results::recovery::recover;
use crate::model::material::Steel;
use crate::model::scene::Scene;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::bumps::{Round, bump};
use crate::proof::verify::scenes::profile::{balance, peak_pressure, semi_axis};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

const RADIUS: f64 = 50.0;
const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
const LOAD: f64 = 1000.0;

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let hertz = hertz()?;
    let run = pressed(&hertz, 6.0)?;
    let (pressure, _) = peak_pressure(&run)?;
    let deep = peak_mises(&hertz)?;
    let recovered = recover(&run.scene, run.state());
    let nodal = recovered.mises_nodal.iter().copied().fold(0.0, f64::max);
    let p0 = LadderClaim::relative(
        "sphere on a rigid flat, h/a = 1/6: p0, MPa",
        pressure,
        hertz.peak_pressure,
        0.01,
    );
    let radius = LadderClaim::relative(
        "contact radius by the second moment of p, mm",
        semi_axis(&run, 0)?,
        hertz.contact_radius,
        0.01,
    );
    let mises = LadderClaim::relative("peak nodal Mises below the surface, MPa", nodal, deep, 0.03);
    Ok(vec![
        run.claim(
            p0.from("Hertz; Johnson 3.42")
                .because("(h/a)² is 3 %, of which the weighted nodal pressure sees a part"),
        ),
        run.claim(
            radius
                .from("Hertz; Johnson 3.42")
                .because("(h/a)² is 3 %; the moment sees the rim, where p falls steeply, in part"),
        ),
        run.claim(
            mises
                .from("Johnson 3.45")
                .because("nodal averages of a peak that is 0.5 a deep err by some (h/a)²"),
        ),
        balance(&run, 2, -0.25 * LOAD)?,
    ])
}

/// The contact.
pub(super) fn hertz() -> Result<PointContact, VerifyError> {
    let compliance = (1.0 - POISSON * POISSON) / YOUNG;
    Ok(PointContact::new(LOAD, RADIUS, compliance)?)
}

/// Largest Mises stress below the surface.
pub(super) fn peak_mises(hertz: &PointContact) -> Result<f64, VerifyError> {
    Ok(SphereField::below(hertz, POISSON)?
        .peak_mises_on_axis()
        .value)
}

/// The quarter model with `across` elements across the contact radius.
pub(super) fn pressed(hertz: &PointContact, across: f64) -> Result<SolvedScene, VerifyError> {
    pressed_on(hertz, across, 1.15, 1.5)
}

/// The same with elements of that size up to `reach` contact radii from the middle, which grow by `growth` beyond.
pub(super) fn pressed_on(
    hertz: &PointContact,
    across: f64,
    reach: f64,
    growth: f64,
) -> Result<SolvedScene, VerifyError> {
    let a = hertz.contact_radius;
    let fine = [reach * a, reach * a, 0.8 * a];
    let size = [a / across; 3];
    let mesh = bump(
        "sphere",
        Round::Sphere(RADIUS),
        size,
        fine,
        [10.0 * a; 3],
        growth,
    )?;
    let mut scene = Scene::bare("sphere", mesh, Steel::elastic(YOUNG, POISSON));
    scene.contacts = vec![kit::on_rigid_flat("z_min", 2)];
    scene.supports = vec![kit::held("x_min", 0), kit::held("y_min", 1)];
    scene.rigid_planes = vec![kit::driven("press", "z_max", 2, -0.25 * LOAD)];
    scene.mirrors = vec![0, 1];
    kit::run(scene)
}
