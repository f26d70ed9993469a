//! Patch tests: what a linear displacement or a uniform pressure must give exactly.

use crate::model::material::Steel;
use crate::model::mesh::block::{Block, uniform};
use crate::model::mesh::{Body, Mesh};
use crate::model::scene::{ElementKind, Scene, Support};
use crate::proof::closed_forms::patch::STRAIN;
use crate::proof::closed_forms::patch::{INNER_NODES, POISSONS_RATIO, YOUNGS_MODULUS, stress};
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let (equal, unequal) = (uniform(0.0, 1.0, 2), vec![0.0, 0.5, 1.0, 2.0, 3.0]);
    let [bbar, enhanced] = kit::ELEMENTS;
    Ok(vec![
        solid(bbar)?,
        solid(enhanced)?,
        contact(
            "equal blocks, meshes that do not match",
            uniform(0.0, 1.0, 3),
            equal,
        )?,
        contact(
            "a wide block below, another steel",
            uniform(0.0, 1.0, 3),
            unequal,
        )?,
    ])
}

/// Seven distorted hexahedra in the unit cube, displacement prescribed on its faces.
fn solid((kind, name): (ElementKind, &str)) -> Result<LadderClaim, VerifyError> {
    let mut points: Vec<[f64; 3]> = [0.0, 1.0]
        .iter()
        .flat_map(|z| [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| [x, y, *z]))
        .collect();
    points.extend(INNER_NODES);
    // The inner hexahedron, then one from each outer face (outward) to the inner one.
    let mut hexes = vec![[8, 9, 10, 11, 12, 13, 14, 15]];
    for face in crate::model::mesh::surface::FACES {
        let [a, b, c, d] = face.map(|n| n as u32);
        hexes.push([a + 8, b + 8, c + 8, d + 8, a, b, c, d]);
    }
    let mut mesh = Mesh {
        source: "solid patch".into(),
        points,
        bodies: vec![Body {
            name: "cube".into(),
            elements: 0..hexes.len(),
        }],
        hexes,
        ..Mesh::default()
    };
    mesh.mark("outside", "cube", |_| true);
    let mut scene = Scene::bare(
        "patch",
        mesh,
        Steel::elastic(YOUNGS_MODULUS, POISSONS_RATIO),
    );
    let row =
        |i: usize| -> [f64; 3] { std::array::from_fn(|j| STRAIN * if i == j { 1.0 } else { 0.5 }) };
    scene.supports = vec![Support {
        gradient: [row(0), row(1), row(2)],
        ..kit::support("outside", [Some(0.0); 3])
    }];
    scene.controls.residual = 1e-12;
    scene.controls.element = kind;
    let run = kit::run(scene)?;
    let exact = stress();
    let exact = [exact.xx, exact.yy, exact.zz, exact.xy, exact.yz, exact.zx];
    let claim = LadderClaim::small(
        format!("solid patch, {name}: largest error of a stress / 2000"),
        worst(&run, |_, i| exact[i]) / exact[0],
        1e-9,
    );
    Ok(run.claim(
        claim
            .from("MacNeal and Harder 1985")
            .because("exact but for rounding"),
    ))
}

/// Two blocks, uniform pressure on all that is open above.
fn contact(name: &str, upper: Vec<f64>, lower: Vec<f64>) -> Result<LadderClaim, VerifyError> {
    const PRESSURE: f64 = 2.0;
    let wide = lower.last().is_some_and(|x| *x > 1.5);
    let lower = Block::new("lower", lower, uniform(0.0, 1.0, 3), uniform(0.0, 1.0, 2)).build()?;
    let upper = Block::new("upper", upper, uniform(0.0, 1.0, 2), uniform(1.0, 2.0, 2)).build()?;
    let mut mesh = Mesh::join([lower.prefixed("lower_"), upper.prefixed("upper_")])?;
    mesh.mark("exposed", "lower_lower", |p| p[2] == 1.0 && p[0] >= 1.0);
    let mut scene = Scene::bare("contact patch", mesh, Steel::elastic(1000.0, 0.3));
    if wide {
        scene.materials[1] = Steel::elastic(3000.0, 0.2);
    }
    scene.controls.residual = 1e-11;
    scene.controls.penetration = 1e-10;
    scene.supports = kit::stack_supports();
    scene.tractions = vec![kit::pressure("upper_z_max", PRESSURE)];
    if wide {
        scene.tractions.push(kit::pressure("exposed", PRESSURE));
    }
    scene.contacts = vec![kit::pair("upper-lower", "upper_z_min", "lower_z_max")];
    let run = kit::run(scene)?;
    let pressures = run.state().contacts[0].pressure.iter();
    let pressure = pressures.map(|p| (p - PRESSURE).abs()).fold(0.0, f64::max);
    let stress = worst(&run, |_, i| if i == 2 { -PRESSURE } else { 0.0 });
    let claim = LadderClaim::small(
        format!("contact patch, {name}: largest error / p"),
        pressure.max(stress) / PRESSURE,
        1e-8,
    );
    Ok(run.claim(
        claim
            .from("Taylor and Papadopoulos 1991")
            .because("segments are integrated exactly; rounding and residual remain"),
    ))
}

/// Largest distance of a stress component from `exact(element, component)`.
fn worst(run: &SolvedScene, exact: impl Fn(usize, usize) -> f64) -> f64 {
    let mut worst = 0.0f64;
    for (e, points) in run.state().stress.iter().enumerate() {
        for stress in points {
            for (i, s) in stress.iter().enumerate() {
                worst = worst.max((s - exact(e, i)).abs());
            }
        }
    }
    worst
}
