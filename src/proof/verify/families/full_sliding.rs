//! Full sliding: every node slips, and the traction is μ times the pressure.
//!
//! Two equal half cylinders (see [`rubbing`](crate::proof::verify::scenes::rubbing)), μ = 0.3, h/a = 1/16, load P, then
//! displaced sideways until all slides. Reference: McEwen's field and that of the traction, and the
//! stress w/πR along the surface, 1 % of p0, that the round side of a disc adds to a half plane
//! (Timoshenko and Goodier, the disc under two opposite forces; the cut face is its symmetry).

use std::f64::consts::PI;

use crate::analytic::hertz::LineContact;
use crate::analytic::subsurface::LineField;
use crate::answer::results::hex::centre;
use crate::answer::results::tensor::{mean, mises};
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::problem_h::{POISSON, RADIUS, Sizes};
use crate::proof::verify::scenes::profile::{field, misfit, peak_pressure, spots};
use crate::proof::verify::scenes::rubbing::{self, NORMAL, Push};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

const FRICTION: f64 = 0.3;
/// Sideways travel of the cut face, in: more than the bodies shear before they slide.
const TRAVEL: f64 = 4e-3;

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let hertz = rubbing::hertz()?;
    let run = kit::run(rubbing::scene(
        &Sizes::with(16),
        FRICTION,
        Push::Travel(TRAVEL),
    )?)?;
    let spots = spots(&run.scene, run.state())?;
    let (peak, _) = peak_pressure(&run)?;
    let [stress, mises] = below(&run, &hertz)?;
    let pressure = misfit(&spots, |s| s.pressure, |s| hertz.pressure(s.at[0]))?;
    let claims = [
        LadderClaim::small("largest |q − μp| / μp0", off_limit(&run, peak)?, 1e-6)
            .from("Coulomb")
            .because("the bound is settled to the tolerance of the increment"),
        LadderClaim::relative(
            "tangential force / μP",
            run_force(&run)? / (NORMAL * run.scene.mesh.extent(2)),
            FRICTION,
            1e-3,
        )
        .from("Coulomb")
        .because("tractions lean by x/R about the mean normal"),
        LadderClaim::relative("p0 while sliding, ksi", peak, hertz.peak_pressure, 0.003)
            .from("Hertz; Dundurs' β = 0")
            .because("as in problem H without friction"),
        LadderClaim::small("p(x) in L2, relative", pressure, 0.03)
            .from("Hertz; Johnson 4.44")
            .because("first order in h from the root at the edge: 2 % at h/a = 1/16"),
        LadderClaim::small("stress 0.25 to 1.5 a deep, rms error / rms", stress, 0.02)
            .from("McEwen; Johnson 4.49 and 7.8")
            .because("finite bodies beyond w/πR, and element means near the edges of the contact"),
        LadderClaim::small("Mises there, largest error / p0", mises, 0.02)
            .from("McEwen; Johnson 4.49 and 7.8")
            .because("finite bodies beyond w/πR, and element means near the edges of the contact"),
    ];
    Ok(claims.map(|claim| run.claim(claim)).into())
}

/// Largest distance of the traction in +x from μ p at a node, over μ p0.
fn off_limit(run: &SolvedScene, peak: f64) -> Result<f64, VerifyError> {
    let field = field(run.state())?;
    let nodes = field.traction.iter().zip(&field.pressure);
    let off = nodes.map(|(q, p)| {
        let size = q.iter().map(|c| c * c).sum::<f64>().sqrt();
        (size.copysign(q[0]) - FRICTION * p).abs()
    });
    Ok(off.fold(0.0, f64::max) / (FRICTION * peak))
}

/// Force on the lower body along +x.
fn run_force(run: &SolvedScene) -> Result<f64, VerifyError> {
    Ok(field(run.state())?.force.iter().map(|f| f[0]).sum())
}

/// Stress in the elements of the lower body next to the contact, against the field at their
/// centres: root mean square distance over root mean square, and the largest distance of the
/// Mises stresses over p0.
fn below(run: &SolvedScene, hertz: &LineContact) -> Result<[f64; 2], VerifyError> {
    let exact = LineField::below(hertz, POISSON)?.sliding(FRICTION)?;
    let mesh = &run.scene.mesh;
    let body = mesh.body("lower").ok_or(VerifyError::Missing("body"))?;
    let a = hertz.half_width;
    let round = NORMAL / (PI * RADIUS);
    let (mut miss, mut norm, mut worst) = (0.0, 0.0, 0.0f64);
    for e in mesh.bodies[body].elements.clone() {
        let at = centre(&mesh.corners(e));
        let depth = -at[1];
        if at[0].abs() > 1.5 * a || !(0.25 * a..=1.5 * a).contains(&depth) {
            continue;
        }
        let (value, mut s) = (mean(&run.state().stress[e]), exact.stress(at[0], depth)?);
        s.xx += round;
        s.yy += POISSON * round;
        // The field's z points into the body, against y here.
        let there = [s.xx, s.zz, s.yy, -s.zx];
        for (v, t) in [value[0], value[1], value[2], value[3]].iter().zip(there) {
            miss += (v - t).powi(2);
            norm += t * t;
        }
        worst = worst.max((mises(&value) - s.mises()).abs());
    }
    Ok([(miss / norm).sqrt(), worst / hertz.peak_pressure])
}
