//! A rigid punch with rounded edges: a narrow peak of pressure where the flat part ends, which coarse meshes do not
//! show. They must say so.
//!
//! The half plane is a block twenty times as wide and as deep as the punch.

use super::certificate::{certified, judged};
use crate::answer::certify::{Quantity, figure};
use crate::case::bearing::RollerEnd;
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::Block;
use crate::model::scene::{EDGE_REACH, Scene};
use crate::proof::closed_forms::rounded_punch::RoundedPunch;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// Half-width of the flat part and radius of the edges, in inches.
const FLAT: f64 = 0.9;
const RADIUS: f64 = 0.1;
const WIDTH: f64 = 20.0;
/// In ksi.
const YOUNG: f64 = 29_500.0;
const POISSON: f64 = 0.3;
/// Stiffness of the punch over that of the block: rigid to 1e-5.
const PUNCH_STIFFNESS: f64 = 1e5;
/// Mean pressure over E*.
const STRAIN: f64 = 0.006;

/// Lengths of the facets where the flat part ends, and whether the contact that spills onto the edge, 0.012 in, is
/// resolved by them.
const MESHES: [(f64, bool); 4] = [(0.02, false), (0.01, false), (0.005, false), (0.0025, true)];

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let compliance = (1.0 - POISSON.powi(2)) / YOUNG;
    let load = 2.0 * (FLAT + RADIUS) * STRAIN / compliance;
    let punch = RoundedPunch::new(load, FLAT, RADIUS, compliance)?;
    let (_, peak) = punch.peak_pressure();
    // Nothing is away from the edges but what is as far from where they begin as they reach.
    let away = punch.pressure(FLAT - EDGE_REACH * 2.0 * (FLAT + RADIUS));
    let mut claims = Vec::new();
    for (facet, expected) in MESHES {
        let run = pressed(load, facet)?;
        let certificate = certified(&run)?;
        let pressure = figure(&certificate, Quantity::PeakPressure, "contact");
        let read = pressure.ok_or(VerifyError::Missing("pressure"))?;
        let problem = format!("rounded punch, R/h = {}", RADIUS / facet);
        let off = 100.0 * (read.value / peak - 1.0).abs();
        let says = if expected { "resolved" } else { "not resolved" };
        let wrong = f64::from(u8::from(read.is_resolved() != expected));
        let text = format!("{problem}: peak pressure, {off:.1} % off, is called {says}");
        let claim = LadderClaim::small(text, wrong, 0.5)
            .from("Ciavarella, Hills and Monno 1998")
            .because("facets show what is wider than they are");
        claims.push(run.claim(claim));
        let known = [
            (Quantity::PeakPressure, "contact", peak),
            (Quantity::PressureAway, "contact", away),
        ];
        claims.extend(judged(&problem, &run, &certificate, &known));
    }
    Ok(claims)
}

/// Half of the punch under half of the load.
fn pressed(load: f64, facet: f64) -> Result<SolvedScene, VerifyError> {
    const STEP: f64 = 0.08;
    let flat = spaced(facet, FLAT, STEP)
        .into_iter()
        .rev()
        .map(|x| FLAT - x);
    let edge = spaced(facet, RADIUS, RADIUS / 6.0).into_iter().skip(1);
    let across: Vec<f64> = flat.chain(edge.map(|x| FLAT + x)).collect();
    let half = FLAT + RADIUS;
    let beside = spaced(facet, WIDTH - half, 2.0).into_iter().skip(1);
    let wide = across
        .iter()
        .copied()
        .chain(beside.map(|x| half + x))
        .collect();
    let deep = spaced(facet, WIDTH, 2.0)
        .into_iter()
        .rev()
        .map(|y| -y)
        .collect();
    let thick = vec![0.0, facet];

    let edges = RollerEnd::Radius(RADIUS);
    let raised = |x: f64| edges.drop_at(x, 2.0 * half, WIDTH);
    let punch = Block::new("punch", across, spaced(facet, half, STEP), thick.clone())
        .mapped(|[x, y, z]| [x, y + raised(x) * (1.0 - y / half), z])
        .build()?;
    let block = Block::new("block", wide, deep, thick).build()?;
    let mesh = Mesh::join([punch.prefixed("punch_"), block.prefixed("block_")])?;

    let mut scene = Scene::bare("rounded punch", mesh, Steel::elastic(YOUNG, POISSON));
    scene.materials[0] = Steel::elastic(PUNCH_STIFFNESS * YOUNG, POISSON);
    scene.mirrors = vec![0];
    let faces = ["x_min", "z_min", "z_max"].into_iter().zip([0, 2, 2]);
    let held = faces.flat_map(|(face, axis)| {
        ["punch", "block"].map(|body| kit::held(&format!("{body}_{face}"), axis))
    });
    scene.supports = held.chain([kit::held("block_y_min", 1)]).collect();
    scene.rigid_planes = vec![kit::driven("top", "punch_y_max", 1, -0.5 * load * facet)];
    scene.contacts = vec![kit::pair("contact", "punch_y_min", "block_y_max")];
    kit::run(scene)
}

/// Coordinates from 0 to `length`, some `least` apart at first, each further than the one before, none by more than
/// `most`.
fn spaced(least: f64, length: f64, most: f64) -> Vec<f64> {
    const GROWTH: f64 = 1.15;
    let steps = std::iter::successors(Some(least), |step| Some((GROWTH * step).min(most)));
    let mut list = vec![0.0];
    let mut end = 0.0;
    for step in steps {
        end += step;
        list.push(end);
        if end >= length {
            break;
        }
    }
    list.into_iter().map(|x| x * length / end).collect()
}
