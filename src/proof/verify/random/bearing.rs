//! Random bearings, sensible or not, and what is known of each without solving it.

use super::Kind;
use super::known::{Known, Limit};
use crate::proof::verify::drawn::{Drawn, End, INCH, METRIC, digits};
use crate::proof::verify::stream::Stream;
use libm::{cos, sin, tan};
use std::f64::consts::PI;

/// Loads, over that at which the pressure of the study's rule (2-49) is reached, p0 = 1.65 Y.
const LOADS: [f64; 2] = [0.1, 4.0];
const RULE: f64 = 1.65;

/// Plastic strain up to which steel is taken to harden where a load is told to be beyond its limit: small strains
/// mean nothing beyond.
const STRAIN: f64 = 0.02;

/// The part that is not of steel, where one is not: half as strong.
const PARTS: [&str; 5] = [
    "upper_plate",
    "intermediate_plate",
    "lower_plate",
    "upper_roller",
    "lower_roller",
];

/// Bearing `number` of a seed, on the mesh of the report.
pub fn bearing(seed: u64, number: usize) -> (Drawn, Known) {
    let mut stream = Stream::new(seed, number);
    let inch = stream.of([true, false]);
    let units = if inch { INCH } else { METRIC };
    let diameter = match inch {
        true => stream.between([1.0, 12.0]),
        false => stream.scale([20.0, 400.0]),
    };
    let solid = stream.share() < 0.2;
    let wall = stream.between([0.08, 0.47]) * diameter;
    let wall = (!solid).then_some(wall);
    let length = stream.between([1.5, 6.0]) * diameter;
    let degrees = stream.between([0.5, 12.0]);
    let kind = stream.of([[0.0, 0.0], [0.005, 0.05], [0.05, 0.25], [0.25, 0.46]]);
    let offset = stream.between(kind) * length;
    let (modulus, strengths) = match inch {
        true => (29_500.0, [50.0, 100.0, 175.0, 250.0]),
        false => (203_000.0, [350.0, 690.0, 1200.0, 1700.0]),
    };
    let strength = stream.of(strengths);
    let poisson = stream.of([0.28, 0.3, 0.33]);
    let soft = (stream.share() < 0.3).then_some(stream.of(PARTS));
    let pressure = RULE * strength;
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
    let bearing = Drawn {
        name: Kind::Bearing.name(seed, number),
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
    let plastic = ring(&bearing, rollers + STRAIN * hardening);
    let load = load / units.forces;
    let known = Known {
        limits: limits(&bearing),
        plastic,
        load,
        turn: turn(&bearing, load, plastic / length, of(soft.is_some())),
    };
    (bearing, known)
}

/// Corners of a roller on the mesh of the report, which rolls on them, and the length of an element along it over its
/// diameter.
const CORNERS: f64 = 24.0;
const ALONG: f64 = 1.0 / 6.0;

/// What a displaced bearing needs to stand.
///
/// Rollers weigh nothing: the force in each passes from its line of contact above to that below, so leans by half
/// of the slope across its axis. It leans as much along its axis, as the other roller demands it. With t =
/// tan(slope/2) both lean by √2 t from the normals of all faces. The forces in all parts lie on one straight
/// line, which from the line of contact at s reaches s + t H in the height H of both rollers and the plate
/// between them.
///
/// A roller of the mesh has corners. It bears on that which is nearest to the slope, at the angle c from the lowest
/// point, or on those beside it as far as the bodies are dented: t is known to lie between tan(slope/2) and tan(c/2).
fn limits(bearing: &Drawn) -> Vec<Limit> {
    if bearing.offset == 0.0 {
        return Vec::new();
    }
    let slope = bearing.degrees.to_radians();
    let apart = 2.0 * PI / CORNERS;
    let corner = apart * (slope / apart).round();
    let round = tan(0.5 * slope);
    let meshed = tan(0.5 * corner);
    let height = bearing.height();
    let friction = [round, meshed].map(|lean| {
        let slid = [[0.0, 0.0], [tan(slope), 0.0]].map(|face| sheared([lean; 2], face));
        slid[0].max(slid[1])
    });
    let length = [(round, slope), (meshed, corner)].map(|(lean, at)| {
        let touches = bearing.offset + 0.5 * bearing.diameter * sin(at);
        (bearing.offset + lean * height).max(touches)
    });
    let between = |what, has, [a, b]: [f64; 2], off: f64| Limit {
        what,
        has,
        needs: [a.min(b) - off, a.max(b) + off],
    };
    let rough = 0.03 * friction[0].max(friction[1]);
    let mut friction = between("friction", bearing.friction, friction, rough);
    if bearing.offset < 0.5 * bearing.diameter * apart {
        // Nearer to the valley than a facet is long the meshed roller bears on both of its faces.
        friction.needs[0] = 0.0;
    }
    // The middle of a force is known to an element of the mesh.
    let element = ALONG * bearing.diameter;
    let half = bearing.half();
    let mut length = between("half of the length of the rollers", half, length, element);
    if let End::Radius(_) = bearing.end {
        // A smaller fillet is a chamfer as long as the last element: the node before it bears only once that has closed.
        length.needs[1] += element;
    }
    vec![friction, length]
}

impl Drawn {
    /// Of both rollers and the plate between them, along the line of the forces.
    fn height(&self) -> f64 {
        let slope = self.degrees.to_radians();
        self.thickness[1]
            + 2.0 * self.offset * tan(slope)
            + self.diameter * (1.0 + 1.0 / cos(slope))
    }

    /// Of the straight length of a roller.
    fn half(&self) -> f64 {
        let end = match self.end {
            End::Radius(radius) => radius,
            _ => 0.0,
        };
        0.5 * self.length - end
    }
}

/// About by how much a plate turns where the force passes near the end of a roller whose rings carry `ring` a length and
/// where the softer part yields at `strength`, in radians. Pressure grows from nothing to twice its mean over three
/// times the distance of the force from the end.
///
/// A hollow roller becomes flatter there by 0.1488 q r³ / (E I) (Young and Budynas, Roark's Formulas for Stress and
/// Strain, table 9.2, case 1), and without limit where its rings collapse. Steel that flows below a line bears three
/// times its yield stress (Johnson, Contact Mechanics, section 6.3): over the width q / 3 Y the roller dents by the
/// height of that arc.
fn turn(bearing: &Drawn, load: f64, ring: f64, strength: f64) -> f64 {
    if bearing.offset == 0.0 {
        return 0.0;
    }
    let lean = tan(0.5 * bearing.degrees.to_radians());
    let left = bearing.half() - bearing.offset - lean * bearing.height();
    let bears = 3.0 * left.max(ALONG * bearing.diameter / 3.0);
    if load > ring * bears {
        return f64::INFINITY;
    }
    let most = 2.0 * load / bears;
    let flatter = bearing.wall.map_or(0.0, |wall| {
        let mean = 0.5 * (bearing.diameter - wall);
        let plane = bearing.modulus / (1.0 - bearing.poisson * bearing.poisson);
        0.1488 * most * mean.powi(3) / (plane * wall.powi(3) / 12.0)
    });
    let dent = (0.5 * most / (3.0 * strength)).powi(2) / bearing.diameter;
    (flatter + dent) / bears
}

/// Shear over pressure of the force along (x, y, 1) on the face whose normal is along (a, b, 1).
fn sheared([x, y]: [f64; 2], [a, b]: [f64; 2]) -> f64 {
    let pressed = x * a + y * b + 1.0;
    let across = [y - b, a - x, x * b - y * a];
    across.iter().map(|c| c * c).sum::<f64>().sqrt() / pressed
}

/// An upper bound of the load that the rollers carry as rings, which collapse by four hinges: the two halves of
/// the work P w are spent in hinges that turn by 8 w / (2 r) together, each at the moment M = 2/√3 Y t²/4 of plane
/// strain, so that P = 4 M L / r at the mean radius r. (A ring that has become flat may carry more, but has then
/// moved too far for small displacements.) Infinite for solid rollers.
fn ring(bearing: &Drawn, strength: f64) -> f64 {
    bearing.wall.map_or(f64::INFINITY, |wall| {
        let moment = 2.0 / 3f64.sqrt() * strength * wall * wall / 4.0;
        let mean = 0.5 * (bearing.diameter - wall);
        4.0 * moment * bearing.length / mean
    })
}
