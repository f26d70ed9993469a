//! A hub shrunk onto a hollow shaft: contact all around, of surfaces that are round alike.
//!
//! Shaft from 50 to 100 mm, hub to 150 mm, plane strain, E = 210 GPa, ν = 0.3, α = 12e-6 / K, the shaft 60 K warmer; the
//! hub as stiff, and a tenth as stiff. A quarter whose meshes do not match: the nodes of one side lie anywhere on the facets
//! of the other. Without friction the pressure is Lamé's: (1 + ν) α T over the sum of what a unit of it strains
//! both walls by (Timoshenko and Goodier, Theory of Elasticity, section 28).

use super::certificate::{certified, judged};
use crate::answer::certify::Quantity;
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{Scene, Temperature};
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};
use std::f64::consts::FRAC_PI_2;

const BORE: f64 = 50.0;
const FIT: f64 = 100.0;
const OUTER: f64 = 150.0;
const LAYER: f64 = 5.0;
/// GPa.
const YOUNG: f64 = 210.0;
const POISSON: f64 = 0.3;
const EXPANSION: f64 = 12e-6;
const WARMER: f64 = 60.0;

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = Vec::new();
    for share in [1.0, 0.1] {
        let hub = Steel::elastic(share * YOUNG, POISSON);
        let shaft = Steel::elastic(YOUNG, POISSON);
        let strain = -strain_of(&shaft, [BORE, FIT]) + strain_of(&hub, [OUTER, FIT]);
        let exact = (1.0 + POISSON) * EXPANSION * WARMER / strain;
        for around in [[6, 8], [12, 17]] {
            let run = fitted([shaft, hub], around)?;
            let certificate = certified(&run)?;
            let problem = format!(
                "hub {share} times as stiff, {} and {} facets on a quarter",
                around[0], around[1]
            );
            let pressures = &run.state().contacts[0];
            let force = (pressures.pressure.iter().zip(&pressures.area)).map(|(p, a)| p * a);
            let mean = force.sum::<f64>() / pressures.area.iter().sum::<f64>();
            // Walls of as many elements have as good displacements.
            let tolerance = (FRAC_PI_2 / f64::from(around[0])).powi(2);
            let claim = format!("{problem}: mean pressure, GPa");
            claims.push(
                run.claim(LadderClaim::relative(claim, mean, exact, tolerance))
                    .from("Lamé's tubes in plane strain")
                    .because(
                        "errors of second order, for facets that subtend an angle of its root",
                    ),
            );
            let known = [(Quantity::PeakPressure, "fit", exact)];
            claims.extend(judged(&problem, &run, &certificate, &known));
        }
    }
    Ok(claims)
}

/// Hoop strain at the radius `at` of a wall that ends at the radius `free`, under a unit of pressure there: negative inside.
fn strain_of(steel: &Steel, [free, at]: [f64; 2]) -> f64 {
    let (e, nu) = (steel.youngs_modulus, steel.poissons_ratio);
    (1.0 + nu) / e * ((1.0 - 2.0 * nu) * at * at + free * free) / (free * free - at * at)
}

/// A quarter of one layer, with `around` facets on either side of the fit.
fn fitted(steels: [Steel; 2], around: [u32; 2]) -> Result<SolvedScene, VerifyError> {
    let wall = |name: &str, radii: [f64; 2], facets: u32| -> Result<Mesh, VerifyError> {
        let cells = facets as usize;
        let block = Block::new(
            name,
            uniform(radii[0], radii[1], cells / 2),
            uniform(0.0, FRAC_PI_2, cells),
            uniform(0.0, LAYER, 1),
        );
        let mut mesh = block.mapped(kit::quarter).build()?;
        for surface in &mut mesh.surfaces {
            surface.name = format!("{name}_{}", surface.name);
        }
        Ok(mesh)
    };
    let shaft = wall("shaft", [BORE, FIT], around[0])?;
    let hub = wall("hub", [FIT, OUTER], around[1])?;
    let mut scene = Scene::bare("press fit", Mesh::join([shaft, hub])?, steels[0]);
    scene.materials = steels.into();
    scene.contacts = vec![kit::pair("fit", "shaft_x_max", "hub_x_min")];
    for wall in ["shaft", "hub"] {
        let supports = kit::quarter_supports().into_iter().map(|mut support| {
            support.surface = format!("{wall}_{}", support.surface);
            support.name = format!("{wall}_{}", support.name);
            support
        });
        scene.supports.extend(supports);
    }
    scene.temperatures = vec![Temperature {
        name: "warm".into(),
        body: "shaft".into(),
        expansion: EXPANSION,
        value: WARMER,
        gradient: [0.0; 3],
    }];
    kit::run(scene)
}
