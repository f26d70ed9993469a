//! Partial slip: the middle of a contact sticks while its edges slide.
//!
//! Two equal half cylinders (see [`rubbing`](crate::proof::verify::scenes::rubbing)), μ = 0.3, load P, then the push
//! Q = μP/2. Reference: Cattaneo and Mindlin on half planes. The moment of Q over the height of the
//! finite bodies and their round sides bend u_x of the surfaces by some (a/R)² of 0.04 % against
//! what the traction itself does: nothing to be seen here.
//!
//! How well nodal values can follow q(x), which has the edges of two half ellipses: linear pieces
//! through its exact values miss it by 8.9, 5.4 and 2.2 % in L2 at h/a = 1/8, 1/16 and 1/32, the
//! best linear pieces by 6.2, 3.9 and 1.5 %.

use crate::proof::closed_forms::friction::CattaneoMindlin;
use crate::proof::verify::kit;
use crate::proof::verify::scenes::problem_h::Sizes;
use crate::proof::verify::scenes::profile::{ContactPoint, integral, misfit, spots};
use crate::proof::verify::scenes::rubbing::{self, NORMAL, Push};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

const FRICTION: f64 = 0.3;

pub fn claims(extent: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = at(16, 0.02, 0.08)?;
    if extent == Extent::All {
        claims.extend(at(8, 0.04, 0.13)?);
        claims.extend(at(32, 0.01, 0.04)?);
    }
    Ok(claims)
}

/// With `across` elements across the half-width, and the tolerances of c/a and q(x).
fn at(across: usize, stick: f64, profile: f64) -> Result<Vec<LadderClaim>, VerifyError> {
    let hertz = rubbing::hertz()?;
    let push = 0.5 * FRICTION * NORMAL;
    let exact = CattaneoMindlin::new(hertz, push, FRICTION)?;
    let sizes = Sizes::with(across);
    let mut scene = rubbing::scene(&sizes, FRICTION, Push::Force(push))?;
    // The usual tolerance lets nodes creep that should stick: 0.4 % of μp0 in their traction.
    scene.controls.penetration = 1e-8;
    let run = kit::run(scene)?;
    let spots = spots(&run.scene, run.state())?;
    let thickness = run.scene.mesh.extent(2);
    let total = integral(&spots, |s| s.traction) / thickness;
    // What a sliding strip would carry beyond this traction: half an ellipse of half-width c.
    let spare = |s: &ContactPoint| FRICTION * s.pressure - s.traction;
    let second = integral(&spots, |s| spare(s) * s.at[0] * s.at[0]);
    let half_width = 2.0 * (second / integral(&spots, spare)).sqrt();
    let traction = misfit(&spots, |s| s.traction, |s| exact.traction(s.at[0]))?;
    let of = |what: &str| format!("Q/μP = 0.5, h/a = 1/{across}: {what}");
    let claims = [
        LadderClaim::relative(of("∫ q, kip/in"), total, push, 1e-4)
            .from("equilibrium")
            .because("the residual, and tractions on chords of the round face, (h/R)²"),
        LadderClaim::relative(
            of("c/a of the sticking strip"),
            half_width / hertz.half_width,
            exact.stick_half_width / hertz.half_width,
            stick,
        )
        .from("Cattaneo, Mindlin; Johnson 7.2(d)")
        .because("a quarter of h/c: the strip ends between two nodes"),
        LadderClaim::small(of("q(x) in L2, relative"), traction, profile)
            .from("Cattaneo, Mindlin; Johnson 7.2(d)")
            .because("up to twice what linear pieces through the exact values miss"),
    ];
    Ok(claims.map(|claim| run.claim(claim)).into())
}
