//! Hill's problem: a thick tube under internal pressure, yielding from the bore outwards, in plane
//! strain.
//!
//! a = 100, b = 200 mm, E = 210, Y = 0.24 GPa. No closed form exists for Mises' criterion and
//! ν = 0.3: the reference solves the radial equation with 100 quadratic elements
//! ([`tube_mises`]), good to 4e-5 at the loads here. Hill's formula, exact for a Tresca-type
//! criterion, stands beside it. With ν = 0.4999 and hardening his closed form is Mises' own.
//!
//! The limit pressure, (2Y/√3) ln b/a, is approached by moving the bore outward to twenty times
//! its displacement at first yield; the pressure is the work of the stresses over the bore's.

use std::f64::consts::FRAC_PI_2;

use crate::model::material::Steel;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{ElementKind, Scene, Step, Support};
use crate::proof::closed_forms::steel::BilinearSteel;
use crate::proof::closed_forms::tube::Tube;
use crate::proof::closed_forms::tube_mises;
use crate::proof::verify::kit::{self, NamedElement, SolvedScene};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

const INNER: f64 = 100.0;
const OUTER: f64 = 200.0;
const LAYER: f64 = 10.0;
const YOUNG: f64 = 210.0;
const YIELD: f64 = 0.24;
const POISSON: f64 = 0.3;
/// Tangent modulus of the steel that hardens.
const TANGENT: f64 = 5.0;
/// Equal steps of pressure in the reference.
const STEPS: usize = 400;

/// Layers of the wall; errors of the increments, which hid a third of that of 24 layers, are 1e-5.
const LAYERS: usize = 28;

const FINE: &str = "28 layers: (h/a)² / 2 is 6e-4; the reference is good to 4e-5";

pub fn claims(extent: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = Vec::new();
    let cells: &[usize] = match extent {
        Extent::Fast => &[24],
        Extent::All => &[12, 24, 48],
    };
    for kind in kit::ELEMENTS {
        claims.extend(perfect(kind)?);
        claims.extend(hardening(kind)?);
        claims.push(incompressible(kind)?);
        for cells in cells {
            claims.push(limit(*cells, kind)?);
        }
    }
    Ok(claims)
}

fn tube(tangent: f64) -> Result<Tube, VerifyError> {
    let steel = BilinearSteel::new(YOUNG, YIELD, tangent)?;
    Ok(Tube::new(INNER, OUTER, steel)?)
}

/// A quarter of one layer, `cells` through the wall and around.
fn scene(tube: &Tube, poisson: f64, cells: usize, kind: ElementKind) -> Result<Scene, VerifyError> {
    let mesh = Block::new(
        "tube",
        uniform(INNER, OUTER, cells),
        uniform(0.0, FRAC_PI_2, cells),
        uniform(0.0, LAYER, 1),
    )
    .mapped(kit::quarter)
    .build()?;
    let steel = Steel {
        youngs_modulus: YOUNG,
        poissons_ratio: poisson,
        yield_stress: YIELD,
        hardening_modulus: tube.steel().hardening_modulus(),
    };
    let mut scene = Scene::bare("tube", mesh, steel);
    scene.controls.element = kind;
    scene.supports = kit::quarter_supports();
    Ok(scene)
}

/// Outward displacement of the bore and of the outer wall at each of `pressures`.
fn expand(
    mut scene: Scene,
    pressures: &[f64],
) -> Result<(SolvedScene, Vec<[f64; 2]>), VerifyError> {
    scene.tractions = vec![kit::pressure("x_min", 1.0)];
    scene.steps = pressures.iter().map(|p| Step::to("expand", *p)).collect();
    let run = kit::run(scene)?;
    let mut walls = Vec::new();
    for state in &run.solution.states {
        let at = |r: f64| kit::displacement_at(&run.scene.mesh, state, [r, 0.0, 0.0]);
        walls.push([at(INNER)?[0], at(OUTER)?[0]]);
    }
    Ok((run, walls))
}

/// Claims on both walls at each of `pressures` (with its tolerance) against [`tube_mises`], and Hill's formula for the
/// bore where there is one.
fn against_mises(
    tube: &Tube,
    points: &[(f64, f64, &'static str)],
    what: &str,
    (kind, name): NamedElement,
) -> Result<Vec<LadderClaim>, VerifyError> {
    let pressures: Vec<f64> = points.iter().map(|p| p.0).collect();
    let (run, walls) = expand(scene(tube, POISSON, LAYERS, kind)?, &pressures)?;
    let mut claims = Vec::new();
    for ((p, tolerance, why), [inner, outer]) in points.iter().zip(walls) {
        let exact = tube_mises::expand(tube, POISSON, *p, STEPS)?;
        let pairs = [
            ("bore", inner, exact.inner),
            ("outside", outer, exact.outer),
        ];
        for (wall, value, exact) in pairs {
            let claim = format!("{what}, p = {p:.4} GPa, {name}: displacement of the {wall}");
            claims.push(
                run.claim(LadderClaim::relative(claim, value, exact, *tolerance))
                    .from("radial equation with Mises' criterion, 100 quadratic elements: `src/proof/closed_forms/tube_mises` of this version")
                    .because(why),
            );
        }
        if tube.steel().tangent_modulus() == 0.0 {
            let hill = tube.displacement_compressible(tube.front(*p)?, POISSON, INNER)?;
            let claim = format!("the same bore beside Hill's formula, {name}");
            claims.push(
                run.claim(LadderClaim::shown(claim, inner, hill))
                    .from("Hill 1950, ch. V; exact for a Tresca-type criterion"),
            );
        }
    }
    Ok(claims)
}

fn perfect(kind: NamedElement) -> Result<Vec<LadderClaim>, VerifyError> {
    let tube = tube(0.0)?;
    let points = [0.14, 0.18, 0.95 * tube.limit_pressure()].map(|p| (p, 0.002, FINE));
    against_mises(&tube, &points, "no hardening", kind)
}

fn hardening(kind: NamedElement) -> Result<Vec<LadderClaim>, VerifyError> {
    let tube = tube(TANGENT)?;
    const FLOWING: &str = "the wall flows: d ln u / d ln p is 9, twice that at 95 % of the limit";
    let points = [
        (0.95 * tube.limit_pressure(), 0.002, FINE),
        (0.197, 0.004, FLOWING),
    ];
    against_mises(&tube, &points, "E_t = 5 GPa", kind)
}

/// With hardening and hardly compressible: Hill's closed form, front at 1.6 a.
fn incompressible((kind, name): NamedElement) -> Result<LadderClaim, VerifyError> {
    const FRONT: f64 = 160.0;
    let tube = tube(TANGENT)?;
    let pressure = tube.pressure_at_front(FRONT)?;
    let (run, walls) = expand(scene(&tube, 0.4999, 24, kind)?, &[pressure])?;
    let claim = LadderClaim::relative(
        format!("E_t = 5 GPa, ν = 0.4999, p = {pressure:.4} GPa, {name}: bore"),
        walls[0][0],
        tube.displacement_incompressible(FRONT, INNER)?,
        0.002,
    );
    Ok(run.claim(
        claim
            .from("Hill 1950, ch. V, with linear hardening, ν = 0.5")
            .because("24 layers: (h/a)² / 2 is 1e-3; ν = 0.4999 for 0.5 is 5e-5"),
    ))
}

/// The pressure on the bore when it has moved twenty times as far as at first yield.
fn limit(cells: usize, (kind, name): NamedElement) -> Result<LadderClaim, VerifyError> {
    let tube = tube(0.0)?;
    let mut scene = scene(&tube, POISSON, cells, kind)?;
    let first = tube.first_yield_pressure_mises(POISSON)?;
    let far = 20.0 * tube.elastic_displacement(first, POISSON, INNER)? / INNER;
    scene.supports.push(Support {
        gradient: [[far, 0.0, 0.0], [0.0, far, 0.0], [0.0; 3]],
        ..kit::support("x_min", [Some(0.0), Some(0.0), None])
    });
    scene.controls.first_increment = 0.05;
    let run = kit::run(scene)?;
    // Work on u = (x, y): twice the pressure times the area of the bore's polygon.
    let stress = kit::stress_integral(&run.scene.mesh, run.state());
    let part = FRAC_PI_2 / cells as f64;
    let bore = 0.5 * INNER * INNER * part.sin() * cells as f64 * LAYER;
    let pressure = (stress[0] + stress[1]) / (2.0 * bore);
    let claim = LadderClaim::relative(
        format!("limit pressure, {cells} layers, {name}, GPa"),
        pressure,
        tube.limit_pressure(),
        0.005,
    );
    Ok(run.claim(
        claim
            .from("Hill 1950, ch. V: (2Y/√3) ln b/a")
            .because("limit loads of elements that do not lock lie above by some h²"),
    ))
}
