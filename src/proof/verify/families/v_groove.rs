//! A solid roller in a V groove: two lines of contact that tilt and bend the surfaces under each
//! other.
//!
//! Roller R = 1.5 in, slope 4°, 8.125 kip/in as uniform pressure on the cut face, no friction,
//! plane strain, E = 29500 ksi, ν = 0.3: the half x ≥ 0, a quarter disc on a block 1.5 in deep and
//! wide. Reference: the two lines on half planes. That the bodies are finite changes p0 by at most
//! 0.15 % in problem H, whose bodies are the same, and may turn the surfaces by as much again as
//! the lines do each other: 1.3 % of the offset.

use crate::analytic::hertz::LineContact;
use crate::analytic::vgroove::VGroove;
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::model::mesh::family::disc::{ARC, QuarterDisc, TO_CORE};
use crate::model::mesh::family::grading::Grading;
use crate::model::scene::Scene;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::problem_h::{DEPTH, LOAD, POISSON, RADIUS, YOUNG};
use crate::proof::verify::scenes::profile::{ContactPoint, integral, peak_pressure, spots};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// Elements across the half-width of a line, and their growth away from it.
const ACROSS: f64 = 8.0;
const GROWTH: f64 = 1.25;

/// Of the boundary-element solution, ksi and in.
const PEAK: f64 = 118.67;
const OFFSET: f64 = 0.106_03;

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let slope = 4f64.to_radians();
    let compliance = 2.0 * (1.0 - POISSON * POISSON) / YOUNG;
    let groove = VGroove::new(LOAD, RADIUS, slope, compliance)?;
    let run = pressed(&groove.contact()?, slope)?;
    let spots = spots(&run.scene, run.state())?;
    let thickness = run.scene.mesh.extent(2);
    let mean = |f: fn(&ContactPoint) -> f64| integral(&spots, f) / thickness;
    let normal = mean(|s| s.pressure);
    let offset = mean(|s| s.pressure * s.at[0]) / normal;
    let (pressure, _) = peak_pressure(&run)?;
    Ok([
        LadderClaim::relative(
            "roller in a V of 4°, h/a = 1/8: ∫ p on one line, kip/in",
            normal,
            groove.normal_load(),
            2e-3,
        )
        .from("statics, w / 2 cos θ")
        .because("pressure acts along the normal of the slope; the roller's facets are chords"),
        LadderClaim::relative("p0 of each line, ksi", pressure, PEAK, 0.01)
            .from("boundary elements on half planes (own program, no version, no deck)")
            .because("0.15 % each for h and for finite bodies, and the node next to the peak"),
        LadderClaim::relative(
            "centre of pressure from the middle, in",
            offset,
            OFFSET,
            0.02,
        )
        .from("boundary elements on half planes (own program, no version, no deck)")
        .because("finite bodies may turn the surfaces by as much as the other line: 1.3 %"),
    ]
    .map(|claim| run.claim(claim))
    .into())
}

/// Lengths from 0 to `total`, fine for 1.5 a on both sides of `middle`.
fn about(middle: f64, total: f64, size: f64, a: f64) -> Vec<f64> {
    let from = |length: f64| Grading::new(size, 1.5 * a, length, GROWTH).nodes(1);
    let mut nodes: Vec<f64> = from(middle).into_iter().rev().map(|s| middle - s).collect();
    nodes[0] = 0.0;
    nodes.extend(from(total - middle).into_iter().skip(1).map(|s| middle + s));
    nodes
}

fn pressed(line: &LineContact, slope: f64) -> Result<SolvedScene, VerifyError> {
    let mut mesh = Mesh::join([block(line, slope)?, roller(line, slope)?])?;
    mark_cuts(&mut mesh);
    let mut scene = Scene::bare("V groove", mesh, Steel::elastic(YOUNG, POISSON));
    scene.contacts = vec![kit::pair("roller-groove", "rolling", "slope")];
    scene.supports = vec![
        kit::support("base", [Some(0.0); 3]),
        kit::held("symmetry", 0),
        kit::held("ends", 2),
    ];
    scene.tractions = vec![kit::pressure("top", LOAD / (2.0 * RADIUS))];
    scene.mirrors = vec![0];
    kit::run(scene)
}

/// The groove's right half, its elements 1.1 times as long as the roller's.
fn block(line: &LineContact, slope: f64) -> Result<Mesh, VerifyError> {
    let (a, h) = (line.half_width, 1.1 * line.half_width / ACROSS);
    let (rise, run) = slope.sin_cos();
    let along = about(RADIUS * slope.tan(), DEPTH, h, a);
    let depths = Grading::new(h, 1.25 * a, DEPTH, GROWTH).nodes(1);
    let depths = depths.into_iter().rev().map(|d| -d).collect();
    // From the sloping surface straight down to a level base.
    let block = Block::new("groove", along, depths, layers(line))
        .mapped(|[s, y, z]| [s * run, y + s * rise * (1.0 + y / DEPTH), z]);
    let mut mesh = block.build()?;
    mesh.surfaces.clear();
    let off = |p: [f64; 3]| p[1] - p[0] * slope.tan();
    mesh.mark("slope", "groove", |p| {
        off(p).abs() < TOLERANCE && p[0] < REACH
    });
    mesh.mark("base", "groove", |p| (p[1] + DEPTH).abs() < TOLERANCE);
    Ok(mesh)
}

/// The quarter disc, touching the slope at the angle θ.
fn roller(line: &LineContact, slope: f64) -> Result<Mesh, VerifyError> {
    let (a, h) = (line.half_width, line.half_width / ACROSS);
    let disc = QuarterDisc {
        radius: RADIUS,
        arcs: about(RADIUS * slope, RADIUS * ARC, h, a),
        depths: Grading::new(h, 1.25 * a, RADIUS * TO_CORE, GROWTH).nodes(1),
        rest: 5,
        layers: layers(line),
    };
    let mut mesh = disc.build("roller")?;
    let centre = RADIUS / slope.cos();
    for point in &mut mesh.points {
        point[1] += centre - RADIUS;
    }
    mesh.mark("rolling", "roller", |p| {
        (p[0].hypot(centre - p[1]) - RADIUS).abs() < TOLERANCE && p[0] < REACH
    });
    mesh.mark("top", "roller", |p| (p[1] - centre).abs() < TOLERANCE);
    Ok(mesh)
}

/// Contact surfaces reach this far from the plane of symmetry.
const REACH: f64 = 0.4;
const TOLERANCE: f64 = 1e-9 * RADIUS;

/// One layer, as thick as a contact element.
fn layers(line: &LineContact) -> Vec<f64> {
    uniform(0.0, line.half_width / ACROSS, 1)
}

fn mark_cuts(mesh: &mut Mesh) {
    let end = mesh.extent(2);
    for body in ["groove", "roller"] {
        mesh.mark("symmetry", body, |p| p[0].abs() < TOLERANCE);
        mesh.mark("ends", body, |p| p[2].abs() < TOLERANCE);
        mesh.mark("ends", body, |p| (p[2] - end).abs() < TOLERANCE);
    }
}
