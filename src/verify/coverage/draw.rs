//! Bearings drawn by seed: sensible ones, that can be built, stand still and carry their load.
//!
//! A bearing is drawn as the text of its case file, so that whoever wants can run it again.

use super::Bearing;
use crate::analytic::sizing::PRESSURE_LIMIT;
use crate::output::text::significant;
use libm::{exp, log, sin, tan};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::f64::consts::PI;

/// How many bearings a seed draws.
pub const COUNT: usize = 30;

/// Loads, as shares of the sizing limit.
const LOADS: [f64; 2] = [0.1, 1.3];

/// The line load at which a ring turns plastic at its first hinge is π M_p / R; less than that by this
/// factor, so that thin rollers are not crushed.
const RING: f64 = 0.8;

/// Friction of displaced bearings over the least that holds them, tan(slope/2).
const GRIP: f64 = 1.3;

/// How far from the middle of a roller, in its lengths, the force may pass.
const FARTHEST: f64 = 0.36;

/// A stream of numbers that is the same on every machine and with every version.
struct Stream(ChaCha8Rng);

impl Stream {
    fn new(seed: u64, number: usize) -> Self {
        let mut stream = ChaCha8Rng::seed_from_u64(seed);
        stream.set_stream(number as u64);
        Self(stream)
    }

    /// Evenly from 0 to 1, 1 left out.
    fn share(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * 2f64.powi(-53)
    }

    fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.share()
    }

    /// Evenly in the logarithm.
    fn scale(&mut self, [low, high]: [f64; 2]) -> f64 {
        exp(self.between([log(low), log(high)]))
    }

    fn of<T: Copy, const N: usize>(&mut self, choices: [T; N]) -> T {
        choices[(self.share() * N as f64) as usize % N]
    }
}

/// The units of a case: of length, force and stress, and how many of its forces are one unit of stress
/// times one of area.
struct Units {
    system: &'static str,
    length: &'static str,
    force: &'static str,
    stress: &'static str,
    forces: f64,
}

const INCH: Units = Units {
    system: "in-kip-ksi",
    length: "in",
    force: "kip",
    stress: "ksi",
    forces: 1.0,
};

const METRIC: Units = Units {
    system: "mm-N-MPa",
    length: "mm",
    force: "kN",
    stress: "MPa",
    forces: 1e-3,
};

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
    let inch = stream.of([true, false]);
    let units = if inch { INCH } else { METRIC };
    let diameter = match inch {
        true => stream.between([1.0, 12.0]),
        false => stream.scale([20.0, 400.0]),
    };
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
    let grip = stream.of([GRIP, 1.5, 2.0]) * least;
    let friction = if displaced {
        grip.max(friction)
    } else {
        friction
    };
    let (modulus, strengths) = match inch {
        true => (29_500.0, [50.0, 100.0, 175.0, 250.0]),
        false => (203_000.0, [350.0, 690.0, 1200.0, 1700.0]),
    };
    let poisson = stream.of([0.28, 0.3, 0.33]);
    let strength = stream.of(strengths);
    let carried = limit(diameter, wall, modulus, poisson, strength) * (length - 2.0 * offset);
    let load = stream.scale(LOADS) * carried * units.forces;
    let end = match stream.of([0, 1, 2]) {
        0 => "\"square\"".to_owned(),
        1 => {
            let most = 0.4 * wall.unwrap_or(diameter).min(0.15 * diameter);
            let radius = (stream.between([0.01, 0.06]) * diameter).min(most);
            format!("{{ radius = \"{} {}\" }}", digits(radius), units.length)
        }
        _ => {
            let drop = stream.between([1e-4, 2e-3]) * diameter;
            format!("{{ crown = \"{} {}\" }}", digits(drop), units.length)
        }
    };
    let hardening = match stream.of([0, 1, 2]) {
        0 => String::new(),
        1 => {
            let modulus = stream.of([0.001, 0.01, 0.05]) * modulus;
            format!(
                "hardening_modulus = \"{} {}\"\n",
                digits(modulus),
                units.stress
            )
        }
        _ => format!(
            "hardening = {{ stress = \"{} {}\", strain = 0.157, strain_is = \"total\" }}\n",
            digits(1.38 * strength),
            units.stress
        ),
    };
    let hollow = match wall {
        Some(wall) => format!("roller_wall = \"{} {}\"", digits(wall), units.length),
        None => "solid = true".to_owned(),
    };
    let plastic = if elastic {
        "\n[controls]\nplasticity = false\n"
    } else {
        ""
    };
    let [upper, middle, lower] = thickness.map(digits);
    let (length_unit, stress_unit) = (units.length, units.stress);
    Some(format!(
        "title = \"{name}\"\n\
         units = \"{}\"\n\
         [bearing]\n\
         load = \"{} {}\"\n\
         friction = {}\n\
         roller_diameter = \"{} {length_unit}\"\n\
         {hollow}\n\
         roller_length = \"{} {length_unit}\"\n\
         roller_end = {end}\n\
         offset = \"{} {length_unit}\"\n\
         slope = \"{} deg\"\n\
         \n\
         [bearing.plate_thickness]\n\
         upper = \"{upper} {length_unit}\"\n\
         intermediate = \"{middle} {length_unit}\"\n\
         lower = \"{lower} {length_unit}\"\n\
         \n\
         [steel]\n\
         youngs_modulus = \"{modulus} {stress_unit}\"\n\
         poissons_ratio = {poisson}\n\
         yield_stress = \"{strength} {stress_unit}\"\n\
         {hardening}{plastic}",
        units.system,
        digits(load),
        units.force,
        digits(friction),
        digits(diameter),
        digits(length),
        digits(offset),
        digits(degrees),
    ))
}

/// As case files have them.
fn digits(value: f64) -> String {
    significant(value, 4)
}

/// Does the force of a displaced bearing pass through all of its parts?
///
/// It crosses the upper roller from its top to the slope, so leans by slope/2, and on its way down
/// moves outwards along the lower roller by tan(slope/2) of the height of the stack.
fn stands(diameter: f64, length: f64, slope: f64, offset: f64, thickness: f64) -> bool {
    let height = thickness + 2.0 * offset * tan(slope) + 2.0 * diameter;
    let force = offset + tan(slope / 2.0) * height;
    let touches = offset + 0.5 * diameter * sin(slope);
    force.max(touches) <= FARTHEST * length
}

/// The load per length that the study's rule (2-49) allows, p0 = 1.65 Y, or that of the ring.
fn limit(diameter: f64, wall: Option<f64>, modulus: f64, poisson: f64, strength: f64) -> f64 {
    let compliance = 2.0 * (1.0 - poisson * poisson) / modulus;
    let radius = 0.5 * diameter;
    let pressure = PRESSURE_LIMIT * strength;
    let rule = PI * radius * compliance * pressure * pressure;
    let ring =
        |wall: f64| RING * PI * 0.25 * strength * wall * wall / (radius - 0.5 * wall) / LOADS[1];
    wall.map_or(rule, |wall| rule.min(ring(wall)))
}
