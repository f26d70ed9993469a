//! What a line of contact is to a design rule: a roller on what it rolls on.
//!
//! A bearing says it by its dimensions. Of a general scene the mesh says it: a roller on a flat with the relative
//! radius of the two surfaces is what Hertz's contact, and with it every rule, sees of them.

use crate::analytic::rules::{RuleInput, RuleSteel};
use crate::analytic::sizing::effective_length;
use crate::answer::{InterfaceFigures, LineFigures};
use crate::case::bearing::Seat;
use crate::case::{BearingCase, Case, CaseError, Kind, Steels};
use crate::ground::geometry::{dot, range};
use crate::ground::units::UnitSystem;
use crate::model::scene::{ContactPair, Scene};

/// Of lines and rollers that bear the same but for rounding, as images of each other do, the first one stays the worst.
pub const TIE: f64 = 1.0 + 1e-6;

/// A line of contact as rules see it.
pub struct RuledLine {
    /// Dimensions and steels.
    pub input: RuleInput,
    /// The length that bears, (2-51) where the roller is displaced.
    pub effective: f64,
}

/// The roller of a line of contact pair `pair`; `None` where a side is a rigid plane, or the shape of the surfaces is
/// not known.
pub fn roller(
    case: &Case,
    scene: &Scene,
    (pair, line): (&ContactPair, &LineFigures),
) -> Result<Option<RuledLine>, CaseError> {
    let sides = pair.bodies(&scene.mesh);
    let [Some(upper), Some(lower)] = sides else {
        return Ok(None);
    };
    let bodies = [upper, lower].map(|body| scene.mesh.bodies[body].name.as_str());
    match &case.kind {
        Kind::Bearing(bearing) => {
            let seat = bearing.seat(&pair.name);
            seat.map(|seat| of_bearing(bearing, case.units, &seat))
                .transpose()
        }
        Kind::General(_) => {
            let Some(radius) = line.relative_radius else {
                return Ok(None);
            };
            let length = Span::of(scene, pair, line).length();
            let [upper, lower] = bodies;
            let steels = [steel(case.steels(), upper)?, steel(case.steels(), lower)?];
            Ok(Some(RuledLine {
                input: RuleInput::new(case.units, 2.0 * radius, length, steels),
                effective: length,
            }))
        }
    }
}

fn of_bearing(
    bearing: &BearingCase,
    units: UnitSystem,
    seat: &Seat,
) -> Result<RuledLine, CaseError> {
    let g = &bearing.geometry;
    let sides = [
        steel(&bearing.steels, &seat.roller)?,
        steel(&bearing.steels, &seat.plate)?,
    ];
    let (end_radius, overhang) = match g.end().radius() {
        // The plate stands out beyond where the fillet begins.
        Some(radius) => (radius, Some(radius + seat.overhang)),
        None => (0.0, None),
    };
    Ok(RuledLine {
        input: RuleInput {
            end_radius,
            overhang,
            rollings: bearing.rollings,
            mating_diameter: (seat.curvature != 0.0).then(|| -2.0 / seat.curvature),
            ..RuleInput::new(units, g.diameter(), g.length(), sides)
        },
        effective: bearing_length(seat, g.offset()),
    })
}

/// The length over which a roller displaced by `offset` bears on its seat, (2-51); all of what faces the plate where, displaced by more than half of
/// that, none is left.
pub fn bearing_length(seat: &Seat, offset: f64) -> f64 {
    effective_length(seat.bears, offset).unwrap_or(seat.bears)
}

fn steel(steels: &Steels, body: &str) -> Result<RuleSteel, CaseError> {
    let steel = steels.of(body)?;
    let strength = steels.strength_of(body)?;
    Ok(RuleSteel {
        yield_stress: strength.yield_stress,
        ultimate_strength: strength.ultimate_strength,
        hardness: strength.hardness,
        surface_hardened: strength.surface_hardened,
        ..RuleSteel::elastic(steel.youngs_modulus, steel.poissons_ratio)
    })
}

/// Where along a line its two surfaces face each other.
pub struct Span {
    ends: [f64; 2],
    /// Is the lower end a mirror plane?
    mirrored: bool,
}

impl Span {
    /// The overlap of both surfaces along the axis of a line.
    pub fn of(scene: &Scene, pair: &ContactPair, line: &LineFigures) -> Self {
        let sides = [&pair.upper, &pair.lower].into_iter();
        let surfaces = sides.filter_map(|side| side.surface(&scene.mesh));
        let all = surfaces.fold(
            [f64::NEG_INFINITY, f64::INFINITY],
            |[low, high], surface| {
                let nodes = surface.faces.iter().flat_map(|face| face.nodes);
                let at = nodes.map(|node| dot(line.along, scene.mesh.points[node as usize]));
                let ends = range(at);
                [low.max(ends[0]), high.min(ends[1])]
            },
        );
        Self {
            ends: all,
            mirrored: line.mirrored,
        }
    }

    /// Its length, in the whole.
    pub fn length(&self) -> f64 {
        let [low, high] = self.ends;
        let copies = if self.mirrored { 2.0 } else { 1.0 };
        copies * (high - low)
    }

    /// From a place to the nearer end; a mirror plane is none.
    pub fn distance_to_end(&self, at: f64) -> f64 {
        let [low, high] = self.ends;
        let from_low = if self.mirrored {
            f64::INFINITY
        } else {
            at - low
        };
        from_low.min(high - at).max(0.0)
    }
}

/// Is this both lines of a V, which the mesh does not tell apart?
pub fn is_merged(
    case: &Case,
    (name, interface): (&str, &InterfaceFigures),
    line: &LineFigures,
) -> bool {
    let seat = case.bearing().and_then(|bearing| bearing.seat(name));
    seat.is_some_and(|seat| rests_on_one(&seat, interface, line))
}

/// Does a centred roller rest in its valley on one line, where it has two slopes to rest on?
fn rests_on_one(seat: &Seat, interface: &InterfaceFigures, line: &LineFigures) -> bool {
    let outermost = seat.lines.last().copied().unwrap_or(0.0);
    // Beside each other by less than the nodes are, one of them may stand for both at its own place. One whose strip ends before the
    // bottom of the valley is alone there: an eccentric load presses on one slope.
    let lines: usize = interface.lines.iter().map(|line| line.images).sum();
    let off = line.across.abs();
    seat.is_valley() && (off < 0.5 * outermost || (lines == 1 && off < line.half_width))
}
