//! Line bearings drawn by seed: parallel rollers between two plates, square and out of parallel.

use super::bearing::Bearing;
use super::draw::{LOADS, end, hardening, limit, plasticity, steel};
use crate::proof::verify::drawn::{DrawnUnits, digits, hollow, steel_table};
use crate::proof::verify::stream::Stream;

/// How many line bearings a seed draws.
pub const COUNT: usize = 10;

/// Numbers of streams that no bearing of crossed rollers draws from.
const STREAMS: usize = 1000;

/// The line bearings of a seed.
pub fn bearings(seed: u64) -> Vec<Bearing> {
    (0..COUNT).map(|number| bearing(seed, number)).collect()
}

/// Every second one has a top that is out of parallel, and every second one of either kind stays elastic.
fn bearing(seed: u64, number: usize) -> Bearing {
    let mut stream = Stream::new(seed, STREAMS + number);
    let name = format!("lines-{seed}-{number:02}");
    let (tilted, elastic) = (number % 2 == 1, number / 2 % 2 == 1);
    let text = drawn(&mut stream, &name, tilted, elastic);
    Bearing { name, text }
}

fn drawn(stream: &mut Stream, name: &str, tilted: bool, elastic: bool) -> String {
    let (units, diameter) = DrawnUnits::draw(stream);
    let (length_unit, stress) = (units.length, units.stress);
    let wall = stream.between([0.12, 0.47]) * diameter;
    let wall = (stream.share() >= 0.5).then_some(wall);
    let length = stream.between([1.5, 5.0]) * diameter;
    let rollers: i32 = stream.of([1, 1, 2, 3, 4]);
    let spacing = stream.between([1.2, 2.0]) * diameter;
    let thickness = [(); 2].map(|()| stream.between([0.25, 1.5]) * diameter);
    // Flush with the rollers, or standing out.
    let stand_out = stream.of([1.0, 1.0, 1.15]);
    let steel @ [modulus, poisson, strength] = steel(stream, &units);
    let carried = limit(diameter, wall, modulus, poisson, strength) * length * f64::from(rollers);
    let load = stream.scale(LOADS) * carried * units.forces;
    let end = end(stream, diameter, wall).text(length_unit);
    let hardening = hardening(stream, modulus, strength, stress);
    let friction = stream.of([0.05, 0.15, 0.3]);
    let angle = stream.scale([0.05, 1.0]);
    let top = match tilted {
        true => format!(
            "top = {{ tilt = [\"{} mrad\", \"0 mrad\"] }}\n",
            digits(angle)
        ),
        false => String::new(),
    };
    let beside = match rollers {
        1 => String::new(),
        _ => format!(
            "rollers = {rollers}\nspacing = \"{} {length_unit}\"\n",
            digits(spacing)
        ),
    };
    let [upper, lower] = thickness.map(digits);
    let across = (f64::from(rollers - 1)) * spacing + 1.5 * diameter;
    format!(
        "title = \"{name}\"\n\
         units = \"{}\"\n\
         [line_bearing]\n\
         load = \"{} {}\"\n\
         friction = {}\n\
         {beside}\
         roller_diameter = \"{} {length_unit}\"\n\
         {}\n\
         roller_length = \"{} {length_unit}\"\n\
         roller_end = {end}\n\
         plate_size = [\"{} {length_unit}\", \"{} {length_unit}\"]\n\
         {top}\
         \n\
         [line_bearing.plate_thickness]\n\
         upper = \"{upper} {length_unit}\"\n\
         lower = \"{lower} {length_unit}\"\n\
         \n\
         {}{hardening}{}",
        units.system,
        digits(load),
        units.force,
        digits(friction),
        digits(diameter),
        hollow(wall, length_unit),
        digits(length),
        digits(across),
        digits(stand_out * length),
        steel_table(steel, stress),
        plasticity(elastic),
    )
}
