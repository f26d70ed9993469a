//! Random bearings, sensible or not.

use super::statics;
use crate::analytic::sizing::PRESSURE_LIMIT;
use crate::proof::verify::drawn::{DrawnBearing, DrawnUnits, End, digits};
use crate::proof::verify::random::kind::RandomKind;
use crate::proof::verify::random::known::KnownOfCase;
use crate::proof::verify::stream::Stream;
use libm::tan;
use std::f64::consts::PI;

/// Loads, over that at which the pressure of the study's rule (2-49) is reached, p0 = 1.65 Y.
const LOADS: [f64; 2] = [0.1, 4.0];

/// Plastic strain up to which steel is taken to harden where a load is told to be beyond its limit: small strains
/// mean nothing beyond.
const SMALL_STRAIN: f64 = 0.02;

/// The part that is not of steel, where one is not: half as strong.
const PARTS: [&str; 5] = [
    "upper_plate",
    "intermediate_plate",
    "lower_plate",
    "upper_roller",
    "lower_roller",
];

/// Bearing `number` of a seed, on the mesh of the report.
pub fn draw(seed: u64, number: usize) -> (DrawnBearing, KnownOfCase) {
    let mut stream = Stream::new(seed, number);
    let (units, diameter) = DrawnUnits::draw(&mut stream);
    let solid = stream.share() < 0.2;
    let wall = stream.between([0.08, 0.47]) * diameter;
    let wall = (!solid).then_some(wall);
    let length = stream.between([1.5, 6.0]) * diameter;
    let degrees = stream.between([0.5, 12.0]);
    let kind = stream.of([[0.0, 0.0], [0.005, 0.05], [0.05, 0.25], [0.25, 0.46]]);
    let offset = stream.between(kind) * length;
    let (modulus, strengths) = units.steels();
    let strength = stream.of(strengths);
    let poisson = stream.of([0.28, 0.3, 0.33]);
    let soft = (stream.share() < 0.3).then_some(stream.of(PARTS));
    let pressure = PRESSURE_LIMIT * strength;
    let rule = PI * diameter * (1.0 - poisson * poisson) * pressure * pressure / modulus;
    let loaded = stream.of([length, length - 2.0 * offset]);
    let load = stream.scale(LOADS) * rule * loaded * units.forces;
    let least = tan(0.5 * degrees.to_radians());
    let between = stream.between([0.05, 0.6]);
    let friction = stream.of([0.0, between, 0.15, 0.3]);
    let grip = stream.of([1.02, 1.3, 2.0]) * least;
    let friction = if offset > 0.0 {
        friction.max(grip)
    } else {
        friction
    };
    let thickness = [(); 3].map(|()| stream.between([0.2, 1.5]) * diameter);
    let [radius, drop] = [[0.01, 0.06], [1e-4, 2e-3]].map(|range| stream.between(range) * diameter);
    let most = 0.4 * wall.unwrap_or(diameter).min(0.15 * diameter);
    let end = stream.of([End::Square, End::Radius(radius.min(most)), End::Crown(drop)]);
    let unloads = stream.of([true, false]);
    let hardening = stream.of([0.0, 0.001, 0.01, 0.05]) * modulus;
    let hardens = match hardening > 0.0 {
        true => format!(
            "hardening_modulus = \"{} {}\"\n",
            digits(hardening),
            units.stress
        ),
        false => String::new(),
    };
    let other = soft.map(|part| {
        format!(
            "[steel.{part}]\nyoungs_modulus = \"{} {stress}\"\npoissons_ratio = 0.33\nyield_stress = \"{} {stress}\"\n",
            digits(modulus / 2.9),
            digits(0.5 * strength),
            stress = units.stress,
        )
    });
    let bearing = DrawnBearing {
        name: RandomKind::Bearing.name(seed, number),
        units,
        load,
        friction,
        diameter,
        wall,
        length,
        end,
        offset,
        degrees,
        unload: Some(unloads),
        thickness,
        modulus,
        poisson,
        strength,
        hardening: hardens,
        more: format!(
            "{}[mesh]\npreset = \"report-like\"\n",
            other.unwrap_or_default()
        ),
    };
    let of = |weak| if weak { 0.5 * strength } else { strength };
    let rollers = of(soft.is_some_and(|part| part.ends_with("roller")));
    let plastic = statics::ring_limit(&bearing, rollers + SMALL_STRAIN * hardening);
    let load = load / units.forces;
    let known = KnownOfCase {
        limits: statics::limits(&bearing),
        plastic,
        load,
        turn: statics::turn(&bearing, load, plastic / length, of(soft.is_some())),
    };
    (bearing, known)
}
