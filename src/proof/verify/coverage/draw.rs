//! Bearings drawn by seed: sensible ones, that can be built, stand still and carry their load.
//!
//! A bearing is drawn as the text of its case file, so that whoever wants can run it again.

use super::bearing::Bearing;
use crate::analytic::sizing::PRESSURE_LIMIT;
use crate::proof::verify::drawn::{DrawnBearing, DrawnUnits, End, digits};
use crate::proof::verify::stream::Stream;
use libm::{sin, tan};
use std::f64::consts::{PI, SQRT_2};

/// How many bearings a seed draws.
pub const COUNT: usize = 30;

/// Loads, as shares of the sizing limit.
pub(super) const LOADS: [f64; 2] = [0.1, 1.3];

/// The line load at which a ring turns plastic at its first hinge is π M_p / R; less than that by this
/// factor, so that thin rollers are not crushed.
const HINGE_LOAD_SHARE: f64 = 0.8;

/// Friction of displaced bearings over tan(slope/2), one of a few, and the least with which they surely stand: both
/// rollers lean on the same friction, so √2 and a little more.
const LEAST_GRIP: f64 = 1.3;
const STANDING_GRIP: f64 = 1.03 * SQRT_2;

/// How far from the middle of a roller, in its lengths, the force may pass.
const FARTHEST_FORCE: f64 = 0.36;

/// The bearings of a seed.
pub fn bearings(seed: u64) -> Vec<Bearing> {
    (0..COUNT).map(|number| bearing(seed, number)).collect()
}

/// Every second one is displaced, and every second one of either kind stays elastic.
fn bearing(seed: u64, number: usize) -> Bearing {
    let mut stream = Stream::new(seed, number);
    let name = format!("seed-{seed}-{number:02}");
    let (displaced, elastic) = (number % 2 == 1, number / 2 % 2 == 1);
    loop {
        if let Some(text) = drawn(&mut stream, &name, displaced, elastic) {
            return Bearing { name, text };
        }
    }
}

/// A bearing, or none where it could not stand.
fn drawn(stream: &mut Stream, name: &str, displaced: bool, elastic: bool) -> Option<String> {
    let (units, diameter) = DrawnUnits::draw(stream);
    let wall = stream.between([0.08, 0.47]) * diameter;
    let wall = (stream.share() >= 0.2).then_some(wall);
    let length = stream.between([1.5, 6.0]) * diameter;
    let degrees = stream.between([0.5, 12.0]);
    let slope = degrees.to_radians();
    let thickness = [(); 3].map(|()| stream.between([0.2, 1.5]) * diameter);
    let share = match displaced {
        true => {
            let ranges = [[0.005, 0.05], [0.05, 0.25], [0.25, 0.36]];
            let range = stream.of(ranges);
            stream.between(range)
        }
        false => 0.0,
    };
    let offset = share * length;
    if displaced && !stands(diameter, length, slope, offset, thickness[1]) {
        return None;
    }
    let least = tan(slope / 2.0);
    let friction = stream.of([0.05, 0.15, 0.3]);
    let grip = stream.of([LEAST_GRIP, 1.5, 2.0]) * least;
    let friction = if displaced {
        grip.max(friction)
    } else {
        friction
    };
    if displaced && friction < STANDING_GRIP * least {
        return None;
    }
    let [modulus, poisson, strength] = steel(stream, &units);
    let carried = limit(diameter, wall, modulus, poisson, strength) * (length - 2.0 * offset);
    let load = stream.scale(LOADS) * carried * units.forces;
    let end = end(stream, diameter, wall);
    let hardening = hardening(stream, modulus, strength, units.stress);
    let drawn = DrawnBearing {
        name: name.to_owned(),
        units,
        load,
        friction,
        diameter,
        wall,
        length,
        end,
        offset,
        degrees,
        unload: None,
        thickness,
        modulus,
        poisson,
        strength,
        hardening,
        more: plasticity(elastic).to_owned(),
    };
    Some(drawn.text())
}

/// Young's modulus, Poisson's ratio and yield stress.
pub(super) fn steel(stream: &mut Stream, units: &DrawnUnits) -> [f64; 3] {
    let (modulus, strengths) = units.steels();
    [modulus, stream.of([0.28, 0.3, 0.33]), stream.of(strengths)]
}

pub(super) fn end(stream: &mut Stream, diameter: f64, wall: Option<f64>) -> End {
    match stream.of([0, 1, 2]) {
        0 => End::Square,
        1 => {
            let most = 0.4 * wall.unwrap_or(diameter).min(0.15 * diameter);
            End::Radius((stream.between([0.01, 0.06]) * diameter).min(most))
        }
        _ => End::Crown(stream.between([1e-4, 2e-3]) * diameter),
    }
}

/// Lines of the table `[steel]`: none, a modulus, or a point of the curve.
pub(super) fn hardening(stream: &mut Stream, modulus: f64, strength: f64, unit: &str) -> String {
    match stream.of([0, 1, 2]) {
        0 => String::new(),
        1 => {
            let modulus = stream.of([0.001, 0.01, 0.05]) * modulus;
            format!("hardening_modulus = \"{} {unit}\"\n", digits(modulus))
        }
        _ => format!(
            "hardening = {{ stress = \"{} {unit}\", strain = 0.157, strain_is = \"total\" }}\n",
            digits(1.38 * strength)
        ),
    }
}

/// The table `[controls]` of a bearing that is elastic or not.
pub(super) fn plasticity(elastic: bool) -> &'static str {
    match elastic {
        true => "\n[controls]\nplasticity = false\n",
        false => "",
    }
}

/// Does the force of a displaced bearing pass through all of its parts?
///
/// It crosses the upper roller from its top to the slope, so leans by slope/2, and on its way down
/// moves outwards along the lower roller by tan(slope/2) of the height of the stack.
fn stands(diameter: f64, length: f64, slope: f64, offset: f64, thickness: f64) -> bool {
    let height = thickness + 2.0 * offset * tan(slope) + 2.0 * diameter;
    let force = offset + tan(slope / 2.0) * height;
    let touches = offset + 0.5 * diameter * sin(slope);
    force.max(touches) <= FARTHEST_FORCE * length
}

/// The load per length that the study's rule (2-49) allows, p0 = 1.65 Y, or that of the ring.
pub(super) fn limit(
    diameter: f64,
    wall: Option<f64>,
    modulus: f64,
    poisson: f64,
    strength: f64,
) -> f64 {
    let compliance = 2.0 * (1.0 - poisson * poisson) / modulus;
    let radius = 0.5 * diameter;
    let pressure = PRESSURE_LIMIT * strength;
    let rule = PI * radius * compliance * pressure * pressure;
    let ring = |wall: f64| {
        HINGE_LOAD_SHARE * PI * 0.25 * strength * wall * wall / (radius - 0.5 * wall) / LOADS[1]
    };
    wall.map_or(rule, |wall| rule.min(ring(wall)))
}
