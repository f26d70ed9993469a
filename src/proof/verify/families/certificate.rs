//! Estimated errors beside true ones, on problem H, on a sphere, at the bores of tubes and of strips that bend.
//!
//! A bar holds where the true error is no larger. How wide bars are beside true errors is asked of many
//! bearings, by the coverage suite.

use super::hertz_sphere;
use crate::analytic::ring::PolarStress;
use crate::answer::certify::{Figure, Quantity, figure};
use crate::answer::results::load::descent;
use crate::answer::results::recovery::recover;
use crate::answer::{Answer, AnswerInputs};
use crate::model::material::Steel;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{ElementKind, Scene, Step};
use crate::proof::closed_forms::steel::BilinearSteel;
use crate::proof::closed_forms::tube::Tube;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::problem_h::{self, Sizes};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};
use std::f64::consts::{FRAC_PI_2, PI};

/// Of the tubes.
const POISSON: f64 = 0.3;
/// Along tubes, of the hoop stress at the bore.
const PULLS: [f64; 5] = [-1.5, -0.5, 0.5, 1.1, 3.0];

/// A figure of which the truth is known: what, where, and the truth.
type KnownTruth<'a> = (Quantity, &'a str, f64);

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = plane()?;
    claims.extend(sphere()?);
    claims.extend(tubes()?);
    claims.extend(pulled_tubes()?);
    claims.extend(strips()?);
    Ok(claims)
}

/// Problem H on nested meshes.
fn plane() -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = Vec::new();
    for (kind, name) in kit::ELEMENTS {
        let mut levels = Vec::new();
        for level in 0..4 {
            let mut scene = problem_h::scene(&Sizes::nested(level))?;
            scene.controls.element = kind;
            let run = kit::run(scene)?;
            let certificate = certified(&run)?;
            levels.push((2 << level, run, certificate));
        }
        // Energies converge with the square of the element size.
        let descents = levels.iter().map(|(_, run, _)| {
            // As the nodes have it: that converges from one side.
            descent(&run.scene, run.state()).unwrap_or(f64::NAN)
        });
        let descents: Vec<f64> = descents.collect();
        let limit = descents[3] + (descents[3] - descents[2]) / 3.0;
        let thickness = levels[0].1.scene.mesh.extent(2);
        let area = 2.0 * problem_h::HALF_WIDTH * thickness;
        let known = [
            (Quantity::Descent, "overall", limit),
            (Quantity::PeakMises, "block", problem_h::MISES_BLOCK),
            (Quantity::PeakMises, "cylinder", problem_h::MISES_CYLINDER),
            (
                Quantity::PeakPressure,
                "cylinder-block",
                problem_h::PRESSURE,
            ),
            (Quantity::HalfWidth, "cylinder-block", problem_h::HALF_WIDTH),
            (Quantity::ContactArea, "cylinder-block", area),
        ];
        for (across, run, certificate) in &levels {
            let problem = format!("problem H, {name}, h/a = 1/{across}");
            claims.extend(judged(&problem, run, certificate, &known));
        }
    }
    Ok(claims)
}

/// A sphere on a rigid flat.
fn sphere() -> Result<Vec<LadderClaim>, VerifyError> {
    let hertz = hertz_sphere::hertz()?;
    let area = PI * hertz.contact_radius.powi(2);
    let known = [
        (
            Quantity::PeakMises,
            "sphere",
            hertz_sphere::peak_mises(&hertz)?,
        ),
        (Quantity::PeakPressure, "body-flat", hertz.peak_pressure),
        (Quantity::HalfWidth, "body-flat", hertz.contact_radius),
        (Quantity::ContactArea, "body-flat", area),
    ];
    let mut claims = Vec::new();
    for across in [3, 4, 6, 8] {
        let run = hertz_sphere::pressed(&hertz, f64::from(across))?;
        let certificate = certified(&run)?;
        let problem = format!("sphere, h/a = 1/{across}");
        claims.extend(judged(&problem, &run, &certificate, &known));
    }
    // Elements that are fine at the peak only: coarse ones at the rim decide how far off it is.
    for (across, growth) in [(10, 1.2), (20, 1.35), (20, 1.5)] {
        let run = hertz_sphere::pressed_on(&hertz, f64::from(across), 0.1, growth)?;
        let certificate = certified(&run)?;
        let problem = format!("sphere, h/a = 1/{across} at the peak, growing by {growth}");
        claims.extend(judged(&problem, &run, &certificate, &known));
    }
    Ok(claims)
}

/// Tubes under internal pressure, thin and thick, with few elements in the wall.
fn tubes() -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = Vec::new();
    for (kind, name) in kit::ELEMENTS {
        for outer in [1.3, 2.0, 4.0] {
            let tube = Tube::new(1.0, outer, BilinearSteel::new(1e3, 1.0, 0.0)?)?;
            let stress = tube.elastic_stress(1.0, POISSON, 1.0)?;
            let known = [(Quantity::PeakMises, "tube", stress.mises())];
            for cells in [2, 3, 4, 8] {
                let mut scene = wall(kind, outer, cells)?;
                scene.supports = kit::quarter_supports();
                let run = kit::run(scene)?;
                let certificate = certified(&run)?;
                let problem = format!("tube, b/a = {outer}, {name}, {cells} in the wall");
                claims.extend(judged(&problem, &run, &certificate, &known));
            }
        }
    }
    Ok(claims)
}

/// Tubes under internal pressure that are pulled or pushed along: errors of one stress may hide those of another in that of
/// Mises.
fn pulled_tubes() -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = Vec::new();
    for outer in [1.5, 2.5] {
        let tube = Tube::new(1.0, outer, BilinearSteel::new(1e3, 1.0, 0.0)?)?;
        let bore = tube.elastic_stress(1.0, POISSON, 1.0)?;
        for (cells, pull) in [3, 6].into_iter().flat_map(|n| PULLS.map(|pull| (n, pull))) {
            let axial = pull * bore.hoop;
            let truth = PolarStress { axial, ..bore }.mises();
            let mut scene = wall(ElementKind::Bbar, outer, cells)?;
            let mirrors = kit::quarter_supports().into_iter();
            scene.supports = mirrors.filter(|held| held.surface != "z_max").collect();
            let pull_along = kit::traction("pull", "z_max", [0.0, 0.0, axial]);
            scene.tractions.push(pull_along);
            let run = kit::run(scene)?;
            let certificate = certified(&run)?;
            let problem = format!(
                "tube, b/a = {outer}, {cells} in the wall, pulled by {pull} of its hoop stress"
            );
            let known = [(Quantity::PeakMises, "tube", truth)];
            claims.extend(judged(&problem, &run, &certificate, &known));
        }
    }
    Ok(claims)
}

/// A quarter of a tube of the inner radius 1 under the pressure 1, with so many elements in its wall; nothing holds it yet.
fn wall(kind: ElementKind, outer: f64, cells: usize) -> Result<Scene, VerifyError> {
    let mesh = Block::new(
        "tube",
        uniform(1.0, outer, cells),
        uniform(0.0, FRAC_PI_2, 4 * cells),
        uniform(0.0, 0.1, 1),
    );
    let mesh = mesh.mapped(kit::quarter).build()?;
    let mut scene = Scene::bare("tube", mesh, Steel::elastic(1e3, POISSON));
    scene.controls.element = kind;
    scene.tractions = vec![kit::pressure("x_min", 1.0)];
    scene.steps = vec![Step::to("pressure", 1.0)];
    Ok(scene)
}

/// A strip in plane strain that is held at one end and bent by a pressure, with one element in its height or a few.
fn strips() -> Result<Vec<LadderClaim>, VerifyError> {
    let bent = |kind, cells: [usize; 2]| {
        let [along, layers] = cells;
        let mesh = Block::new(
            "strip",
            uniform(0.0, 10.0, along),
            uniform(0.0, 1.0, layers),
            uniform(0.0, 0.1, 1),
        );
        let faces = ["x_min", "y_max", "z_min", "z_max"];
        let mesh = (faces.into_iter()).fold(mesh, |mesh, face| mesh.face(face, face));
        let mut scene = Scene::bare("strip", mesh.build()?, Steel::elastic(1e3, POISSON));
        scene.controls.element = kind;
        scene.supports = vec![
            kit::support("x_min", [Some(0.0), Some(0.0), None]),
            kit::support("z_min", [None, None, Some(0.0)]),
            kit::support("z_max", [None, None, Some(0.0)]),
        ];
        scene.tractions = vec![kit::pressure("y_max", 1e-3)];
        scene.steps = vec![Step::to("pressure", 1.0)];
        kit::run(scene)
    };
    let travel = |layers: usize| -> Result<f64, VerifyError> {
        let run = bent(ElementKind::Enhanced, [10 * layers, layers])?;
        Ok(descent(&run.scene, run.state()).unwrap_or(f64::NAN))
    };
    let (coarse, fine) = (travel(8)?, travel(16)?);
    let known = [(Quantity::Descent, "overall", fine + (fine - coarse) / 3.0)];
    let mut claims = Vec::new();
    for (kind, name) in kit::ELEMENTS {
        for (along, layers) in [(5, 1), (10, 1), (20, 2), (40, 2), (40, 4)] {
            let run = bent(kind, [along, layers])?;
            let certificate = certified(&run)?;
            let problem = format!("bent strip, {name}, {along} by {layers}");
            claims.extend(judged(&problem, &run, &certificate, &known));
        }
    }
    Ok(claims)
}

pub(super) fn certified(run: &SolvedScene) -> Result<Vec<Figure>, VerifyError> {
    let (scene, state) = (&run.scene, run.state());
    let answer = Answer::of(&AnswerInputs::new(scene, state, &recover(scene, state)));
    Ok(answer?.certificate)
}

/// How far off the estimates of a certificate are.
pub(super) fn judged(
    problem: &str,
    run: &SolvedScene,
    certificate: &[Figure],
    known: &[KnownTruth],
) -> Vec<LadderClaim> {
    let judge = |(what, place, truth): &KnownTruth| {
        let claim = figure(certificate, *what, place)?;
        let error = (claim.value - truth).abs();
        let estimate = claim.error.total()?;
        let short = error / estimate;
        let text = format!(
            "{problem}: {} of {place}, {:.2} % off, bar {:.2} %: share of it",
            what.name(),
            100.0 * error / truth.abs(),
            100.0 * estimate / truth.abs(),
        );
        let claim = LadderClaim::small(text, short, 1.0)
            .from("closed forms; limits of problem H; the series in h")
            .because("a bar holds");
        Some(run.claim(claim))
    };
    known.iter().filter_map(judge).collect()
}
