//! What statics and limit loads tell of a bearing without solving it.

use crate::proof::verify::drawn::{DrawnBearing, End};
use crate::proof::verify::random::known::BalanceLimit;
use libm::{cos, sin, tan};
use std::f64::consts::PI;

/// Corners of a roller on the mesh of the report, which rolls on them, and the length of an element along it over its
/// diameter.
const CORNERS: f64 = 24.0;
const ELEMENT_LENGTH: f64 = 1.0 / 6.0;

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
pub fn limits(bearing: &DrawnBearing) -> Vec<BalanceLimit> {
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
    let between = |what, has, [a, b]: [f64; 2], off: f64| BalanceLimit {
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
    let element = ELEMENT_LENGTH * bearing.diameter;
    let half = bearing.half();
    let mut length = between("half of the length of the rollers", half, length, element);
    if let End::Radius(_) = bearing.end {
        // A smaller fillet is a chamfer as long as the last element: the node before it bears only once that has closed.
        length.needs[1] += element;
    }
    vec![friction, length]
}

impl DrawnBearing {
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
pub fn turn(bearing: &DrawnBearing, load: f64, ring: f64, strength: f64) -> f64 {
    if bearing.offset == 0.0 {
        return 0.0;
    }
    let lean = tan(0.5 * bearing.degrees.to_radians());
    let left = bearing.half() - bearing.offset - lean * bearing.height();
    let bears = 3.0 * left.max(ELEMENT_LENGTH * bearing.diameter / 3.0);
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
pub fn ring_limit(bearing: &DrawnBearing, strength: f64) -> f64 {
    bearing.wall.map_or(f64::INFINITY, |wall| {
        let moment = 2.0 / 3f64.sqrt() * strength * wall * wall / 4.0;
        let mean = 0.5 * (bearing.diameter - wall);
        4.0 * moment * bearing.length / mean
    })
}
