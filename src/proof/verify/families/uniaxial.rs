//! The uniaxial curve of the reference study's steel, with unloading.

use crate::model::material::Steel;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{Scene, Step};
use crate::proof::closed_forms::steel::BilinearSteel;
use crate::proof::verify::kit;
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// The steel: E, ν, Y and E_t in ksi.
const YOUNG: f64 = 29500.0;
const YIELD: f64 = 100.0;
const TANGENT: f64 = 247.379;

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    const STRAIN: f64 = 0.05;
    let curve = BilinearSteel::new(YOUNG, YIELD, TANGENT)?;
    let steel = Steel {
        youngs_modulus: YOUNG,
        poissons_ratio: 0.3,
        yield_stress: YIELD,
        hardening_modulus: curve.hardening_modulus(),
    };
    let list = || uniform(0.0, 1.0, 2);
    let mesh = Block::new("cube", list(), list(), list()).build()?;
    let mut scene = Scene::bare("uniaxial", mesh, steel);
    scene.controls.residual = 1e-12;
    scene.supports = vec![
        kit::held("x_min", 0),
        kit::held("y_min", 1),
        kit::held("z_min", 2),
        kit::support("z_max", [None, None, Some(STRAIN)]),
    ];
    let residual = curve.residual_strain(STRAIN)?;
    let shares = [0.005, 0.01, 0.05, residual];
    scene.steps = shares.map(|e| Step::to("pull", e / STRAIN)).into();
    let run = kit::run(scene)?;
    let mut claims = Vec::new();
    for (strain, state) in shares.into_iter().zip(&run.solution.states) {
        let stress = state.stress[0][0][2];
        let claim = if strain == residual {
            LadderClaim::scaled(
                "stress, unloaded to the residual strain, ksi",
                stress,
                0.0,
                YIELD,
                1e-8,
            )
        } else {
            LadderClaim::relative(
                format!("stress at strain {strain}, ksi"),
                stress,
                curve.stress(strain)?,
                1e-8,
            )
        };
        claims.push(
            run.claim(
                claim
                    .from("bilinear curve, closed form")
                    .because("radial return is exact in proportional loading"),
            ),
        );
    }
    Ok(claims)
}
