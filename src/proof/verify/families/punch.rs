//! Prandtl's punch: a rigid flat punch sinks into a perfectly plastic block, in plane strain.
//!
//! The limit pressure is (2 + π) Y/√3 on a half plane, whether the punch is rough or smooth. A block
//! clamped at its base and side carries as much once it holds Prandtl's slip lines, which reach 3 b
//! to the side and √2 b deep for the half width b. (On a smooth base a layer 2 b thick slides aside
//! at 2.55 Y.)
//!
//! The edge of the punch is a node that sinks with it; across the element beside it the velocity
//! comes to rest. A mesh of size h so carries the load of a punch whose half width lies between b
//! and b + h/2: over b the force is above the limit, over b + h/2 below, both by some h. The
//! plain pressures of two meshes, extrapolated to h = 0, meet it.
//!
//! The punch is moved until the force stays; the force is its reaction.

use crate::model::material::Steel;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{ElementKind, PlaneMotion, RigidPlane, Scene};
use crate::proof::closed_forms::limit::punch_pressure;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// Half width of the punch, half width and depth of the block.
const HALF: f64 = 1.0;
const WIDTH: f64 = 4.0;
const DEPTH: f64 = 2.0;
const YIELD: f64 = 1.0;
const YOUNG: f64 = 1000.0;
/// How far the punch sinks: ten times as far again changes the force by 1e-3.
const SINK: f64 = 0.04;

pub fn claims(extent: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let [bbar, enhanced] = kit::ELEMENTS;
    let mut claims = series(&[8, 16], bbar)?;
    if extent == Extent::All {
        claims.extend(series(&[32], bbar)?);
        claims.extend(series(&[8, 16], enhanced)?);
    }
    Ok(claims)
}

/// Punches with these numbers of elements along the half width, and the limit of the last two.
fn series(meshes: &[usize], kind: (ElementKind, &str)) -> Result<Vec<LadderClaim>, VerifyError> {
    let exact = punch_pressure(YIELD)?;
    let mut claims = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    for cells in meshes {
        let (run, force) = punch(*cells, kind.0)?;
        let size = HALF / *cells as f64;
        let name = format!("b/h = {cells}, {}: force", kind.1);
        let (plain, wide) = (force / HALF, force / (HALF + 0.5 * size));
        let claim = LadderClaim::relative(
            format!("{name} / (b + h/2) / Y"),
            wide,
            exact,
            // A third of h/2b and more is seen below; on coarse meshes it is only shown.
            if *cells < 16 { f64::INFINITY } else { 0.015 },
        )
        .because("the half width carried is within h/2 of b: 3 % at b/h = 16, halved by the rule");
        claims.push(run.claim(claim));
        claims.push(run.claim(LadderClaim::shown(format!("{name} / b / Y"), plain, exact)));
        if let Some((coarse, old)) = before {
            let value = plain + (plain - old) * size / (coarse - size);
            let claim = LadderClaim::relative(
                format!("{}, force / b / Y extrapolated to h = 0", kind.1),
                value,
                exact,
                0.005,
            );
            claims.push(run.claim(
                claim.because("second order in h remains, and 1e-3 between force and limit"),
            ));
        }
        before = Some((size, plain));
    }
    Ok(claims
        .into_iter()
        .map(|c| c.from("Prandtl 1920; Hill 1950, ch. IX"))
        .collect())
}

/// The force per length on half a punch with `cells` elements along its half width.
fn punch(cells: usize, kind: ElementKind) -> Result<(SolvedScene, f64), VerifyError> {
    let size = HALF / cells as f64;
    let count = |length: f64| (length / size).round() as usize;
    let mut mesh = Block::new(
        "block",
        uniform(0.0, WIDTH, count(WIDTH)),
        uniform(-DEPTH, 0.0, count(DEPTH)),
        uniform(0.0, size, 1),
    )
    .build()?;
    mesh.mark("punch", "block", |[x, y, _]| {
        y == 0.0 && x < HALF + 0.1 * size
    });
    let steel = Steel {
        youngs_modulus: YOUNG,
        poissons_ratio: 0.3,
        yield_stress: YIELD,
        hardening_modulus: 0.0,
    };
    let mut scene = Scene::bare("punch", mesh, steel);
    scene.controls.element = kind;
    scene.controls.residual = 1e-7;
    scene.controls.first_increment = 0.05;
    let clamped = [Some(0.0), Some(0.0), None];
    scene.supports = vec![
        kit::held("x_min", 0),
        kit::support("x_max", clamped),
        kit::support("y_min", clamped),
        kit::held("z_min", 2),
        kit::held("z_max", 2),
    ];
    scene.rigid_planes = vec![RigidPlane {
        name: "punch".into(),
        surface: "punch".into(),
        motion: [
            PlaneMotion::Free,
            PlaneMotion::Held(-SINK * HALF),
            PlaneMotion::Free,
        ],
        ..RigidPlane::default()
    }];
    let run = kit::run(scene)?;
    let force = -run.state().planes[0].force[1] / size;
    Ok((run, force))
}
