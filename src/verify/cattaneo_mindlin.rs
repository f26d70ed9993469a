//! Partial slip: the middle of a contact sticks while its edges slide.
//!
//! Two equal half cylinders (see [`rubbing`](super::rubbing)), μ = 0.3, h/a = 1/16, load P, then
//! the push Q = μP/2. Reference: Cattaneo and Mindlin on half planes. The moment of Q over the
//! height of the finite bodies and their round sides bend u_x of the surfaces by some (a/R)² of
//! 0.04 % against what the traction itself does: nothing to be seen here.

use super::kit;
use super::problem_h::Sizes;
use super::profile::{integral, misfit, spots};
use super::rubbing::{self, NORMAL, Push};
use super::{Claim, Extent, VerifyError};
use crate::analytic::friction::CattaneoMindlin;

const FRICTION: f64 = 0.3;

pub fn claims(_: Extent) -> Result<Vec<Claim>, VerifyError> {
    let hertz = rubbing::hertz()?;
    let push = 0.5 * FRICTION * NORMAL;
    let exact = CattaneoMindlin::new(hertz, push, FRICTION)?;
    let run = kit::run(rubbing::scene(
        &Sizes::with(16),
        FRICTION,
        Push::Force(push),
    )?)?;
    let spots = spots(&run.scene, run.state())?;
    let thickness = kit::extent(&run.scene.mesh, 2);
    let total = integral(&spots, |s| s.traction) / thickness;
    // What a sliding strip would carry beyond this traction: half an ellipse of half-width c.
    let spare = |s: &super::profile::Spot| FRICTION * s.pressure - s.traction;
    let second = integral(&spots, |s| spare(s) * s.at[0] * s.at[0]);
    let stick = 2.0 * (second / integral(&spots, spare)).sqrt();
    let traction = misfit(&spots, |s| s.traction, |s| exact.traction(s.at[0]))?;
    let claims = [
        Claim::relative("Q/μP = 0.5, h/a = 1/16: ∫ q, kip/in", total, push, 1e-4)
            .from("equilibrium")
            .because("the residual, and tractions on chords of the round face, (h/R)²"),
        Claim::relative(
            "half-width c of the sticking strip / a",
            stick / hertz.half_width,
            exact.stick_half_width / hertz.half_width,
            0.02,
        )
        .from("Cattaneo, Mindlin; Johnson 7.2(d)")
        .because("half the gain of a nodal resolution of h/c = 1/11 at both edges"),
        Claim::small("q(x) in L2, relative", traction, 0.04)
            .from("Cattaneo, Mindlin; Johnson 7.2(d)")
            .because("as p(x), 2 % at this h from the root at the edge; q has two such edges"),
    ];
    Ok(claims.map(|claim| run.claim(claim)).into())
}
