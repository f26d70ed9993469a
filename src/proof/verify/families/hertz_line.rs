//! Line contact: a half cylinder on a block, [problem H](crate::proof::verify::scenes::problem_h).
//!
//! Hertz for pressure and half-width, which the finite bodies change by at most 0.15 %; for the
//! peaks of the Mises stress, which they change by 2 %, the limits of fine meshes. Nested meshes
//! at h/a = 1/4, 1/8 and 1/16. The tolerances at integration points fall with the first power of
//! h, elsewhere nearly with the second: the errors that other mortar methods show on such meshes,
//! 0.8 to 1.4 % at the points at h/a = 1/8, and some room for where the points lie.

use crate::analytic::hertz::LineContact;
use crate::analytic::subsurface::LineField;
use crate::answer::results::hex::centre;
use crate::answer::results::tensor::{mean, mises};
use crate::model::scene::ElementKind;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::problem_h::{
    self, HALF_WIDTH, MISES_BLOCK, MISES_CYLINDER, PRESSURE, ProblemHReading, Sizes, read,
};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

const HERTZ: &str = "Hertz; Johnson 4.43 to 4.45";
const LIMITS: &str = problem_h::MISES_SOURCE;
const BAR: &str = "B-bar";

/// What is allowed on a mesh.
struct Rung {
    level: u32,
    element: ElementKind,
    name: &'static str,
    pressure: f64,
    half_width: f64,
    centroid: f64,
    nodal: f64,
    point: f64,
}

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let rung = |level, name, [pressure, half_width, centroid, nodal, point]: [f64; 5]| Rung {
        level,
        element: ElementKind::Bbar,
        name,
        pressure,
        half_width,
        centroid,
        nodal,
        point,
    };
    const SHOWN: f64 = f64::INFINITY;
    let coarse = rung(1, BAR, [0.013, 0.03, SHOWN, SHOWN, SHOWN]);
    let middle = rung(2, BAR, [0.003, 0.01, 0.006, 0.013, 0.015]);
    let bending = Rung {
        element: ElementKind::Enhanced,
        ..rung(2, "enhanced", [0.003, 0.01, 0.006, 0.013, 0.025])
    };
    let fine = rung(3, BAR, [0.003, 0.004, 0.006, 0.005, 0.01]);
    let mut claims = Vec::new();
    for rung in [coarse, middle, bending, fine] {
        let (run, reading) = solved(&rung)?;
        claims.extend(figures(&run, &rung, &reading));
        if rung.level == 3 {
            claims.extend(fields(&run, &reading)?);
        }
    }
    Ok(claims)
}

fn solved(rung: &Rung) -> Result<(SolvedScene, ProblemHReading), VerifyError> {
    let mut scene = problem_h::scene(&Sizes::nested(rung.level))?;
    scene.controls.element = rung.element;
    let run = kit::run(scene)?;
    let reading = read(&run.scene, run.state())?;
    Ok((run, reading))
}

fn figures(run: &SolvedScene, rung: &Rung, reading: &ProblemHReading) -> Vec<LadderClaim> {
    let cells = 2 << rung.level;
    let of = |what: &str| format!("h/a = 1/{cells}, {}: {what}", rung.name);
    let mut claims = vec![
        LadderClaim::relative(of("p0, ksi"), reading.pressure, PRESSURE, rung.pressure)
            .from(HERTZ)
            .because("second order in h, and 0.15 % for finite bodies"),
        LadderClaim::relative(
            of("half-width, in"),
            reading.half_width,
            HALF_WIDTH,
            rung.half_width,
        )
        .from(HERTZ)
        .because("second order in h: a third to a half of (h/a)²; 0.15 % for finite bodies"),
    ];
    let bodies = [
        ("block", reading.block, MISES_BLOCK),
        ("cylinder", reading.cylinder, MISES_CYLINDER),
    ];
    for (body, mises, limit) in bodies {
        let readings = [
            ("centroid", mises.centroid, rung.centroid),
            ("nodal", mises.nodal, rung.nodal),
            ("integration point", mises.integration_point, rung.point),
        ];
        for (place, value, tolerance) in readings {
            let what = of(&format!("Mises, {body}, {place}, ksi"));
            let claim = LadderClaim::relative(what, value, limit, tolerance).from(LIMITS);
            claims.push(claim.because("what mortar methods reach at this h; see the family"));
        }
    }
    claims.into_iter().map(|claim| run.claim(claim)).collect()
}

/// Where the peak is, the pressure profile, and Mises along the axis.
fn fields(run: &SolvedScene, reading: &ProblemHReading) -> Result<Vec<LadderClaim>, VerifyError> {
    let hertz = LineContact::at_peak_pressure(
        PRESSURE,
        problem_h::RADIUS,
        2.0 * (1.0 - problem_h::POISSON.powi(2)) / problem_h::YOUNG,
    )?;
    let mut claims = vec![
        LadderClaim::small("|x| of p0 / a", reading.pressure_at / HALF_WIDTH, 1e-9)
            .from("symmetry")
            .because("a node lies there"),
        LadderClaim::small("p(x) in L2, relative, h/a = 1/16", reading.profile, 0.03)
            .from(HERTZ)
            .because("first order in h, from the root at the edge: some h/3a"),
        LadderClaim::small("contact force / load − 1", reading.balance.abs(), 1e-6)
            .from("equilibrium")
            .because("the residual is 1e-8 of the load"),
    ];
    for (body, tolerance) in [("block", 0.025), ("cylinder", 0.01)] {
        let what = format!("Mises on the axis, {body}, 0.2 to 2 a: rms error / peak");
        claims.push(
            LadderClaim::small(what, along_axis(run, body, &hertz)?, tolerance)
                .from("McEwen; Johnson 4.49")
                .because("finite bodies: 2 % in the block, 0.4 % in the cylinder; h/a = 1/16"),
        );
    }
    Ok(claims.into_iter().map(|claim| run.claim(claim)).collect())
}

/// Mises stress of the element means next to the axis against McEwen's field at their centres.
fn along_axis(run: &SolvedScene, body: &str, hertz: &LineContact) -> Result<f64, VerifyError> {
    let exact = LineField::below(hertz, problem_h::POISSON)?;
    let mesh = &run.scene.mesh;
    let body = mesh.body(body).ok_or(VerifyError::Missing("body"))?;
    let a = hertz.half_width;
    let (mut miss, mut count) = (0.0, 0usize);
    for e in mesh.bodies[body].elements.clone() {
        let corners = mesh.corners(e);
        let [x, y, _] = centre(&corners);
        let on_axis = corners.iter().any(|p| p[0].abs() < 1e-9 * a);
        if !on_axis || !(0.2 * a..=2.0 * a).contains(&y.abs()) {
            continue;
        }
        let value = mises(&mean(&run.state().stress[e]));
        miss += (value - exact.stress(x, y.abs())?.mises()).powi(2);
        count += 1;
    }
    if count == 0 {
        return Err(VerifyError::Missing("element on the axis"));
    }
    Ok((miss / count as f64).sqrt() / exact.peak_mises().value)
}
