//! Random stacks of two or three blocks: distorted, of meshes that do not match, of unlike steels, turned.
//!
//! The lowest block is held, the uppermost is loaded by a traction on its top. All forces pass through every
//! interface, so that statics knows them: the resultant has to lie within the cone of friction and to pass
//! through the area where the two blocks face each other.

use super::Kind;
use super::known::{Known, Limit};
use crate::ground::geometry::{Vec3, dot, norm, scale, sub};
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{Scene, Side, Traction, TractionValue};
use crate::proof::verify::stream::Stream;
use crate::proof::verify::{VerifyError, kit};
use libm::{cos, sin};
use nalgebra::{Rotation3, Unit, Vector3};
use std::f64::consts::PI;

/// A stack with what statics knows of it.
pub struct Stack {
    pub scene: Scene,
    pub known: Known,
    /// The force that every interface passes on to the block below.
    pub force: Vec3,
    /// Is it free to slide somewhere, with nothing that drives it?
    pub slides: bool,
}

/// One block of a stack: its footprint about (0, 0) shifted to its place, and the heights of its faces.
struct Part {
    low: [f64; 2],
    high: [f64; 2],
    /// Lower and upper face: z = height + slopes · (x, y).
    faces: [Face; 2],
    cells: [usize; 3],
    /// How far inner nodes are moved, over the size of a cell, and the phases of that.
    distortion: (f64, [f64; 3]),
}

#[derive(Clone, Copy)]
struct Face {
    height: f64,
    slopes: [f64; 2],
}

impl Face {
    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.height + self.slopes[0] * x + self.slopes[1] * y
    }

    /// Unit normal, upwards.
    fn normal(&self) -> Vec3 {
        let [a, b] = self.slopes;
        let size = (1.0 + a * a + b * b).sqrt();
        [-a / size, -b / size, 1.0 / size]
    }
}

/// Shear over pressure that is none.
const NOTHING: f64 = 1e-9;

const NAMES: [&str; 3] = ["lower", "middle", "upper"];

/// Stack `number` of a seed.
///
/// # Errors
/// Where a block cannot be meshed.
pub fn stack(seed: u64, number: usize) -> Result<Stack, VerifyError> {
    let mut stream = Stream::new(seed, number);
    let count = stream.of([2, 3]);
    let tilted = stream.of([0.0, 0.1]);
    let mut parts: Vec<Part> = Vec::new();
    for index in 0..count {
        let size = [(); 2].map(|()| stream.between([0.8, 1.6]));
        let shift = [(); 2].map(|()| stream.between([-0.4, 0.4]));
        let height = stream.between([0.5, 1.2]);
        let slopes = [(); 2].map(|()| tilted * stream.between([-1.0, 1.0]));
        let cells = [(); 3].map(|()| stream.of([3, 4, 5, 6]));
        let distortion = stream.of([0.0, 0.1, 0.2]);
        let phases = [(); 3].map(|()| stream.between([0.0, 2.0 * PI]));
        let flat = Face {
            height: 0.0,
            slopes: [0.0; 2],
        };
        let below = parts.last().map_or(flat, |part| part.faces[1]);
        let top = Face {
            height: below.height + height,
            // What is held and what is loaded is level.
            slopes: if index + 1 < count { slopes } else { [0.0; 2] },
        };
        parts.push(Part {
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
    let interfaces = interfaces(&parts, force);
    let known = Known {
        limits: limits(&parts, &frictions, &interfaces),
        plastic: f64::INFINITY,
        load: norm(force),
        turn: turn(&parts, &steels, &interfaces),
    };
    let meshes: Result<Vec<Mesh>, VerifyError> = (parts.iter().zip(NAMES))
        .map(|(part, name)| part.mesh(name))
        .collect();
    let mut mesh = Mesh::join(meshes?).map_err(|_| VerifyError::Missing("mesh"))?;
    let turned = |v: Vec3| Vec3::from(rotation * Vector3::from(v));
    mesh.points.iter_mut().for_each(|p| *p = turned(*p));
    let mut scene = kit::scene(&Kind::Stack.name(seed, number), mesh, steels[0]);
    scene.materials = steels;
    scene.supports = vec![kit::support("lower_z_min", [Some(0.0); 3])];
    let loaded = NAMES[count - 1];
    scene.tractions = vec![Traction {
        name: "load".into(),
        surface: format!("{loaded}_z_max"),
        value: TractionValue::Vector(turned(traction)),
    }];
    scene.contacts = (1..count)
        .map(|k| {
            let names = [
                format!("{}_z_min", NAMES[k]),
                format!("{}_z_max", NAMES[k - 1]),
            ];
            let mut pair = kit::pair(NAMES[k], &names[0], &names[1]);
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

/// Where the force passes an interface.
struct Interface {
    /// Force across it, and along it.
    pressed: f64,
    shear: f64,
    /// Of the area where the two blocks face each other: half of its widths,
    half: [f64; 2],
    /// and how far from its middle the line of force passes.
    off: [f64; 2],
}

fn interfaces(parts: &[Part], force: Vec3) -> Vec<Interface> {
    let top = &parts[parts.len() - 1];
    let middle = [0, 1].map(|i| 0.5 * (top.low[i] + top.high[i]));
    let centre = [middle[0], middle[1], top.faces[1].at(middle)];
    let between = |pair: &[Part]| {
        let face = pair[0].faces[1];
        let normal = face.normal();
        let pressed = -dot(force, normal);
        // Where the line of force meets the interface.
        let origin = [0.0, 0.0, face.height];
        let way = dot(sub(origin, centre), normal) / dot(force, normal);
        let bears = [0, 1].map(|i| {
            let low = pair[0].low[i].max(pair[1].low[i]);
            let high = pair[0].high[i].min(pair[1].high[i]);
            let at = centre[i] + way * force[i];
            (0.5 * (high - low), (at - 0.5 * (low + high)).abs())
        });
        Interface {
            pressed,
            shear: norm(sub(force, scale(normal, -pressed))),
            half: bears.map(|(half, _)| half),
            off: bears.map(|(_, off)| off),
        }
    };
    parts.windows(2).map(between).collect()
}

/// What every interface needs.
fn limits(parts: &[Part], frictions: &[f64], interfaces: &[Interface]) -> Vec<Limit> {
    let mut limits = Vec::new();
    for ((pair, friction), at) in parts.windows(2).zip(frictions).zip(interfaces) {
        let Interface { pressed, shear, .. } = *at;
        if shear > NOTHING * pressed {
            limits.push(Limit::about("friction", *friction, shear / pressed, 0.02));
        }
        for i in 0..2 {
            // Pressure at the very edge of the area takes nodes there: its middle is known to a third of a cell.
            let cell = |part: &Part| (part.high[i] - part.low[i]) / part.cells[i] as f64;
            let half = at.half[i];
            limits.push(Limit::about(
                "half of the width that bears",
                half,
                at.off[i].max(NOTHING),
                cell(&pair[0]).max(cell(&pair[1])) / (3.0 * half.abs()),
            ));
        }
    }
    limits
}

/// About by how much the uppermost block turns, in radians. Where the force passes an interface beyond the kern of
/// its area, pressure grows from nothing to twice its mean over three times the distance of the force from the edge;
/// the blocks beside give way as columns would.
fn turn(parts: &[Part], steels: &[Steel], interfaces: &[Interface]) -> f64 {
    let mut all = 0.0;
    for ((pair, steels), at) in parts.windows(2).zip(steels.windows(2)).zip(interfaces) {
        for i in 0..2 {
            let half = at.half[i];
            let bears = (3.0 * (half - at.off[i])).min(2.0 * half).max(NOTHING);
            let uneven = (3.0 * at.off[i] / half).min(1.0);
            let edge = uneven * 2.0 * at.pressed / (bears * 2.0 * at.half[1 - i]);
            for (part, steel) in pair.iter().zip(steels) {
                let height = part.faces[1].height - part.faces[0].height;
                let strain = match edge > steel.yield_stress {
                    true => (edge - steel.yield_stress) / steel.hardening_modulus,
                    false => edge / steel.youngs_modulus,
                };
                all += strain * height / bears;
            }
        }
    }
    all
}

impl Part {
    fn mesh(&self, name: &str) -> Result<Mesh, VerifyError> {
        let [x, y, z] = self.cells;
        let line = |cells| uniform(0.0, 1.0, cells);
        let block = Block::new("block", line(x), line(y), line(z)).mapped(|at| self.place(at));
        let faces = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"];
        let block = (faces.into_iter()).fold(block, |block, face| block.face(face, face));
        Ok(block.build()?.prefixed(&format!("{name}_")))
    }

    /// From the unit cube into the part. Inner nodes are moved to and fro, and so are those of a face within it.
    fn place(&self, at: Vec3) -> Vec3 {
        let (size, phases) = self.distortion;
        let moved = |i: usize| {
            let across = (i + 1) % 3;
            let wave = sin(PI * at[i]) * sin(3.0 * at[across] + 2.0 * at[i] + phases[i]);
            at[i] + size * wave / self.cells[i] as f64
        };
        let [x, y, share] = [0, 1, 2].map(moved);
        let plan = [
            self.low[0] + x * (self.high[0] - self.low[0]),
            self.low[1] + y * (self.high[1] - self.low[1]),
        ];
        let [low, high] = self.faces.map(|face| face.at(plan));
        [plan[0], plan[1], low + share * (high - low)]
    }
}
