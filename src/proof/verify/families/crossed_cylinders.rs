//! Two cylinders of 20 and 50 mm that cross at a right angle: contact over an ellipse.
//!
//! Two blocks with round faces, a quarter of each, 8 long semi-axes wide and deep. Reference:
//! Hertz for the gap x²/2R₂ + y²/2R₁, with exact elliptic integrals.

use crate::analytic::hertz::EllipticContact;
use crate::analytic::subsurface::EllipseField;
use crate::answer::results::recovery::recover;
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::scene::Scene;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::bumps::{Round, bump, upside_down};
use crate::proof::verify::scenes::profile::{balance, peak_pressure, semi_axis};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

const RADII: [f64; 2] = [20.0, 50.0];
const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
const LOAD: f64 = 10e3;

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let compliance = 2.0 * (1.0 - POISSON * POISSON) / YOUNG;
    let hertz = EllipticContact::crossed_cylinders(LOAD, RADII, compliance)?;
    let run = pressed(&hertz, 6.0)?;
    let (pressure, at) = peak_pressure(&run)?;
    let recovered = recover(&run.scene, run.state());
    let mises = recovered.mises_nodal.iter().copied().fold(0.0, f64::max);
    let deep = EllipseField::below(&hertz, POISSON)?.peak_mises_on_axis();
    let p0 = LadderClaim::relative(
        "cylinders R = 20 and 50 mm, h = a/6, b/6: p0, MPa",
        pressure,
        hertz.peak_pressure,
        0.015,
    );
    let mut claims =
        vec![
            run.claim(p0.from("Hertz; Johnson 4.24 to 4.32").because(
                "as for the sphere, and half of (b/R)² of 0.2 % for surfaces no paraboloids",
            )),
            run.claim(
                LadderClaim::small(
                    "distance of p0 from the centre / b",
                    at[0].hypot(at[1]) / hertz.semi_axes[1],
                    1e-9,
                )
                .from("symmetry")
                .because("a node lies in the centre"),
            ),
        ];
    for (axis, name) in [(0, "long"), (1, "short")] {
        let claim = LadderClaim::relative(
            format!("{name} semi-axis by the second moment of p, mm"),
            semi_axis(&run, axis)?,
            hertz.semi_axes[axis],
            0.01,
        );
        claims.push(
            run.claim(
                claim
                    .from("Hertz; Johnson 4.24 to 4.32")
                    .because("(h/a)² is 3 %; the moment sees the steep rim in part"),
            ),
        );
    }
    let mises = LadderClaim::relative(
        "peak nodal Mises below the surface, MPa",
        mises,
        deep.value,
        0.03,
    );
    claims.push(
        run.claim(
            mises
                .from("Johnson 3.69")
                .because("nodal averages of a peak that is 0.6 b deep err by some (h/b)²"),
        ),
    );
    claims.push(balance(&run, 2, -0.25 * LOAD)?);
    Ok(claims)
}

/// The quarter model with `across` elements across each semi-axis.
fn pressed(hertz: &EllipticContact, across: f64) -> Result<SolvedScene, VerifyError> {
    let [a, b] = hertz.semi_axes;
    let side = |name: &str, radius, curved| -> Result<Mesh, VerifyError> {
        let size = [a, b, b].map(|s| s / across);
        let fine = [1.15 * a, 1.15 * b, 0.9 * b];
        bump(
            name,
            Round::Cylinder(radius, curved),
            size,
            fine,
            [8.0 * a; 3],
            1.5,
        )
    };
    // Along x, the long axis, the cylinder of larger radius is curved.
    let upper = side("upper", RADII[0], 1)?.prefixed("upper_");
    let lower = upside_down(side("lower", RADII[1], 0)?).prefixed("lower_");
    let mesh = Mesh::join([lower, upper])?;
    let mut scene = Scene::bare("crossed cylinders", mesh, Steel::elastic(YOUNG, POISSON));
    scene.contacts = vec![kit::pair("upper-lower", "upper_z_min", "lower_z_min")];
    scene.supports = vec![kit::held("lower_z_max", 2)];
    for (face, axis) in [("x_min", 0), ("y_min", 1)] {
        for body in ["upper", "lower"] {
            scene
                .supports
                .push(kit::held(&format!("{body}_{face}"), axis));
        }
    }
    scene.rigid_planes = vec![kit::driven("press", "upper_z_max", 2, -0.25 * LOAD)];
    scene.mirrors = vec![0, 1];
    kit::run(scene)
}
