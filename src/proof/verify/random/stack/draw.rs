//! Random stacks of two or three blocks: distorted, of meshes that do not match, of unlike steels, turned.
//!
//! The lowest block is held, the uppermost is loaded by a traction on its top.

use super::block::{SlopedFace, StackBlock};
use super::statics;
use crate::ground::geometry::{Vec3, norm, scale};
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::scene::{Scene, Side};
use crate::proof::verify::random::kind::RandomKind;
use crate::proof::verify::random::known::KnownOfCase;
use crate::proof::verify::stream::Stream;
use crate::proof::verify::{VerifyError, kit};
use libm::{cos, sin};
use nalgebra::{Rotation3, Unit, Vector3};
use std::f64::consts::PI;

/// A stack with what statics knows of it.
#[derive(Clone)]
pub struct Stack {
    pub scene: Scene,
    pub known: KnownOfCase,
    /// The force that every interface passes on to the block below.
    pub force: Vec3,
    /// Is it free to slide somewhere, with nothing that drives it?
    pub slides: bool,
}

const BLOCK_NAMES: [&str; 3] = ["lower", "middle", "upper"];

/// Stack `number` of a seed.
///
/// # Errors
/// Where a block cannot be meshed.
pub fn stack(seed: u64, number: usize) -> Result<Stack, VerifyError> {
    let mut stream = Stream::new(seed, number);
    let count = stream.of([2, 3]);
    let tilted = stream.of([0.0, 0.1]);
    let mut parts: Vec<StackBlock> = Vec::new();
    for index in 0..count {
        let size = [(); 2].map(|()| stream.between([0.8, 1.6]));
        let shift = [(); 2].map(|()| stream.between([-0.4, 0.4]));
        let height = stream.between([0.5, 1.2]);
        let slopes = [(); 2].map(|()| tilted * stream.between([-1.0, 1.0]));
        let cells = [(); 3].map(|()| stream.of([3, 4, 5, 6]));
        let distortion = stream.of([0.0, 0.1, 0.2]);
        let phases = [(); 3].map(|()| stream.between([0.0, 2.0 * PI]));
        let flat = SlopedFace {
            height: 0.0,
            slopes: [0.0; 2],
        };
        let below = parts.last().map_or(flat, |part| part.faces[1]);
        let top = SlopedFace {
            height: below.height + height,
            // What is held and what is loaded is level.
            slopes: if index + 1 < count { slopes } else { [0.0; 2] },
        };
        parts.push(StackBlock {
            low: [0, 1].map(|i| shift[i] - 0.5 * size[i]),
            high: [0, 1].map(|i| shift[i] + 0.5 * size[i]),
            faces: [below, top],
            cells,
            distortion: (distortion, phases),
        });
    }
    let steels: Vec<Steel> = (0..count).map(|_| steel(&mut stream)).collect();
    let weakest = steels.iter().map(|s| s.yield_stress);
    let pressure = stream.scale([0.05, 0.8]) * weakest.fold(1.0, f64::min);
    let lean = stream.between([0.0, 0.4]);
    let lean = stream.of([0.0, lean]);
    let direction = stream.between([0.0, 2.0 * PI]);
    let traction = [
        pressure * lean * cos(direction),
        pressure * lean * sin(direction),
        -pressure,
    ];
    let frictions: Vec<f64> = (1..count)
        .map(|_| {
            let rough = stream.between([0.05, 0.6]);
            stream.of([0.0, rough, rough, rough])
        })
        .collect();
    let sides: Vec<Side> = (1..count)
        .map(|_| stream.of([Side::Upper, Side::Lower]))
        .collect();
    let axis = Vector3::from([(); 3].map(|()| stream.between([-1.0, 1.0])));
    let angle = stream.of([0.0, 1.0]) * stream.between([0.1, 3.0]);
    let rotation = Rotation3::from_axis_angle(&Unit::new_normalize(axis), angle);

    let top = &parts[count - 1];
    let area: f64 = (0..2).map(|i| top.high[i] - top.low[i]).product();
    let force = scale(traction, area);
    let interfaces = statics::interfaces(&parts, force);
    let known = KnownOfCase {
        limits: statics::limits(&parts, &frictions, &interfaces),
        plastic: f64::INFINITY,
        load: norm(force),
        turn: statics::turn(&parts, &steels, &interfaces),
    };
    let meshes: Result<Vec<Mesh>, VerifyError> = (parts.iter().zip(BLOCK_NAMES))
        .map(|(part, name)| part.mesh(name))
        .collect();
    let mut mesh = Mesh::join(meshes?).map_err(|_| VerifyError::Missing("mesh"))?;
    let turned = |v: Vec3| Vec3::from(rotation * Vector3::from(v));
    mesh.points.iter_mut().for_each(|p| *p = turned(*p));
    let mut scene = Scene::bare(RandomKind::Stack.name(seed, number), mesh, steels[0]);
    scene.materials = steels;
    scene.supports = vec![kit::support("lower_z_min", [Some(0.0); 3])];
    let loaded = BLOCK_NAMES[count - 1];
    let top = format!("{loaded}_z_max");
    scene.tractions = vec![kit::traction("load", &top, turned(traction))];
    scene.contacts = (1..count)
        .map(|k| {
            let names = [
                format!("{}_z_min", BLOCK_NAMES[k]),
                format!("{}_z_max", BLOCK_NAMES[k - 1]),
            ];
            let mut pair = kit::pair(BLOCK_NAMES[k], &names[0], &names[1]);
            pair.friction = frictions[k - 1];
            pair.carrier = sides[k - 1];
            pair
        })
        .collect();
    Ok(Stack {
        scene,
        slides: frictions.contains(&0.0),
        known,
        force: turned(force),
    })
}

/// Elastic, or hardening so much that no load is too large.
fn steel(stream: &mut Stream) -> Steel {
    let youngs_modulus = stream.scale([100.0, 10_000.0]);
    let poissons_ratio = stream.of([0.0, 0.25, 0.3, 0.4]);
    let yields = stream.of([true, false]);
    let hardening = stream.between([0.02, 0.2]);
    match yields {
        true => Steel {
            youngs_modulus,
            poissons_ratio,
            yield_stress: 1.0,
            hardening_modulus: hardening * youngs_modulus,
        },
        false => Steel::elastic(youngs_modulus, poissons_ratio),
    }
}
