//! What stays in a contact surface after unloading to 0.1 % of the load.
//!
//! A column of one element: the bilinear law says what stays of its strain, and half of its
//! shortening is the dent at either end beside its best-fit rigid motion. Problem H in a steel in
//! which Hertz's pressure is 2.5 times the yield stress, 1.4 times that of first yield: the dents of
//! nested meshes down to h/a = 1/16 settle to half a per cent, and with what is left of the load still
//! on CalculiX finds them on one of these meshes. Elastic bodies keep nothing, also when they are made
//! to go through the whole computation.

use crate::answer::results::dent::dent;
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{ElementKind, Scene, Step};
use crate::model::state::State;
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::problem_h::{self, Sizes};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};
use crate::solver::solve::spring_back;

const YOUNG: f64 = 29500.0;
const POISSON: f64 = 0.3;
/// Hardening modulus dσ/dε_p of the reference study's steel, ksi.
const HARDENING: f64 = 249.471;

/// Factor of the load in the last step: so little that all bodies still touch and nothing more yields.
const REMAINING_LOAD: f64 = 1e-3;

/// Limits of the nested meshes at p0 = 2.5 Y, in. At h/a = 1/2 to 1/16: 4.860, 4.565, 4.485 and
/// 4.510e-5 in the block, 4.076, 3.520, 3.410 and 3.407e-5 in the cylinder.
const LINE: [(&str, f64); 2] = [("block", 4.50e-5), ("cylinder", 3.405e-5)];

/// The same with 0.1 % of the load on, by CalculiX 2.20 on the mesh of h/a = 1/8 (C3D8, contact surface to
/// surface at 20 Young's moduli an edge), in.
const CALCULIX: [f64; 2] = [4.558e-5, 3.524e-5];

pub fn claims(extent: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = Vec::new();
    for (kind, name) in kit::ELEMENTS {
        claims.push(column(kind, name)?);
    }
    claims.extend(elastic()?);
    // h/a and how far off the dent may be.
    let levels = [(1, "1/4", 0.05), (2, "1/8", 0.01), (3, "1/16", 0.01)];
    let fast = if extent == Extent::Fast { 2 } else { 3 };
    for (level, size, tolerance) in &levels[..fast] {
        claims.extend(line(*level, size, *tolerance)?);
    }
    Ok(claims)
}

/// Two columns of one element each, 2 in long, the lower one pressed to 110 ksi.
fn column(element: ElementKind, name: &str) -> Result<LadderClaim, VerifyError> {
    const PRESSURE: f64 = 110.0;
    const YIELD: f64 = 100.0;
    let column = |name: &str, from: f64| {
        let one = || uniform(0.0, 1.0, 1);
        let block = Block::new("column", one(), one(), uniform(from, from + 2.0, 1));
        block.build().map(|mesh| mesh.prefixed(&format!("{name}_")))
    };
    let mesh = Mesh::join([column("lower", 0.0)?, column("upper", 2.0)?])?;
    let mut scene = Scene::bare("columns", mesh, steel(YIELD));
    scene.materials[1] = Steel::elastic(YOUNG, POISSON);
    scene.controls.element = element;
    (scene.controls.residual, scene.controls.penetration) = (1e-12, 1e-12);
    scene.contacts = vec![kit::pair("upper-lower", "upper_z_min", "lower_z_max")];
    scene.supports = kit::stack_supports();
    scene.tractions = vec![kit::pressure("upper_z_max", PRESSURE)];
    scene.steps = vec![Step::to("load", 1.0), Step::to("unload", REMAINING_LOAD)];
    let run = kit::run(scene)?;
    let stays = spring_back(&run.scene, run.state())?;
    let claim = LadderClaim::relative(
        format!("column of one element, {name}: dent, in"),
        depth(&run.scene, &stays, "lower_column", "lower_z_max")?,
        (PRESSURE - YIELD) / HARDENING,
        1e-9,
    );
    Ok(run
        .claim(claim)
        .from("bilinear curve, closed form")
        .because("radial return is exact in proportional loading"))
}

/// Problem H without yield, all of it said to have yielded.
fn elastic() -> Result<Vec<LadderClaim>, VerifyError> {
    let run = pressed(2, f64::INFINITY)?;
    let mut claims = Vec::new();
    for (name, state) in [("loaded", 0), ("unloaded", 1)] {
        let mut state = run.solution.states[state].clone();
        let travel = kit::mean_displacement(&run.scene.mesh, &run.solution.states[0], "top")?[1];
        state.peeq = vec![[1.0; 8]; run.scene.mesh.hexes.len()];
        let [block, cylinder] = line_dents(&run.scene, &state)?;
        let most = block.abs().max(cylinder.abs());
        let claim = LadderClaim::small(
            format!("elastic line contact, {name}: dent / descent"),
            most / travel.abs(),
            1e-6,
        );
        claims.push(
            run.claim(claim)
                .from("elasticity")
                .because("a millionth of the loaded displacement"),
        );
    }
    Ok(claims)
}

/// Problem H beyond yield: the dents, and the same from the state at full load.
fn line(level: u32, size: &str, tolerance: f64) -> Result<Vec<LadderClaim>, VerifyError> {
    let run = pressed(level, problem_h::PRESSURE / 2.5)?;
    let loaded = line_dents(&run.scene, &run.solution.states[0])?;
    let found = line_dents(&run.scene, run.state())?;
    let mut claims = Vec::new();
    for (i, (body, limit)) in LINE.into_iter().enumerate() {
        let at = format!("line contact, h/a = {size}, {body}: dent");
        let claim = LadderClaim::relative(format!("{at}, in"), found[i], limit, tolerance);
        claims.push(
            run.claim(claim)
                .from("nested meshes to h/a = 1/16")
                .because("the plastic zone grows element by element: 0.5 % either way from 1/8 on"),
        );
        let claim = LadderClaim::relative(
            format!("{at}, seen at full load"),
            loaded[i],
            found[i],
            1e-6,
        );
        claims.push(
            run.claim(claim)
                .from("elastic unloading")
                .because("nothing yields on the way down"),
        );
        if size == "1/8" {
            let surface = format!("{body}_contact");
            let raw = depth(&run.scene, &run.state().displacement, body, &surface)?;
            let claim = format!("{at} with the load left, in");
            claims.push(
                run.claim(LadderClaim::relative(claim, raw, CALCULIX[i], 0.015))
                    .from("CalculiX 2.20, C3D8, surface to surface, mesh `Sizes::nested(2)` (deck not kept)")
                    .because("another element and softer contact"),
            );
        }
    }
    Ok(claims)
}

/// Problem H, yielding at `yield_stress`, loaded and unloaded.
fn pressed(level: u32, yield_stress: f64) -> Result<SolvedScene, VerifyError> {
    let mut scene = problem_h::scene(&Sizes::nested(level))?;
    scene.materials.fill(steel(yield_stress));
    scene.steps = vec![Step::to("load", 1.0), Step::to("unload", REMAINING_LOAD)];
    kit::run(scene)
}

fn steel(yield_stress: f64) -> Steel {
    Steel {
        youngs_modulus: YOUNG,
        poissons_ratio: POISSON,
        yield_stress,
        hardening_modulus: HARDENING,
    }
}

/// Dents in the block and the cylinder of problem H.
fn line_dents(scene: &Scene, state: &State) -> Result<[f64; 2], VerifyError> {
    let stays = spring_back(scene, state)?;
    Ok([
        depth(scene, &stays, "block", "block_contact")?,
        depth(scene, &stays, "cylinder", "cylinder_contact")?,
    ])
}

/// Depth of the dent in `surface` of the body called `body`.
fn depth(scene: &Scene, stays: &[[f64; 3]], body: &str, surface: &str) -> Result<f64, VerifyError> {
    let body = scene.mesh.body(body).ok_or(VerifyError::Missing("body"))?;
    let surface = kit::surface(&scene.mesh, surface)?;
    let dent = dent(scene, stays, body, surface).ok_or(VerifyError::Missing("dent"))?;
    Ok(dent.depth)
}
