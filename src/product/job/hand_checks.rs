//! What a checker can recompute by hand: the equilibrium of each interface, and Hertz's line contact under the load per
//! length that the run found.

use super::error::JobError;
use super::rollers::bearing_length;
use crate::analytic::DomainError;
use crate::analytic::hertz::{LineContact, PointContact};
use crate::analytic::subsurface::LineField;
use crate::answer::Answer;
use crate::answer::certify::{Figure, Quantity};
use crate::case::bearing::{Dimensions, Seat};
use crate::case::{BearingCase, Case};
use crate::ground::units::UnitLabels;
use crate::model::scene::{ContactPair, Scene};
use crate::render::summary::{HandCheck, SizedLine, SizedPatch, Sizing};
use crate::render::text::significant;

const FRICTION: &str = "friction on the slopes carries a part";
const HALF_SPACE: &str = "bodies are no half spaces, and rollers bend";
const OTHERS: &str = "bodies are no half spaces; other lines and bending add to the peak of a body";
const ROUNDING: &str = "they agree but for rounding";

/// The checks of every line and patch of contact, and of the equilibrium of a bearing.
pub fn hand_checks(
    case: &Case,
    scene: &Scene,
    (answer, sizing): (&Answer, Option<&Sizing>),
) -> Result<Vec<HandCheck>, JobError> {
    let Some(sizing) = sizing else {
        return Ok(Vec::new());
    };
    let no_form = |error: DomainError| JobError::ClosedForm {
        what: "what can be recomputed by hand".to_owned(),
        why: error.to_string(),
    };
    let units = UnitLabels::of(case.units);
    let mut checks = Vec::new();
    let bearing = case.bearing();
    for pair in &scene.contacts {
        let hand = ByHand {
            scene,
            answer,
            units: &units,
            pair,
            shared: bearing.is_some_and(BearingCase::shares_evenly),
        };
        let seat = bearing.and_then(|bearing| bearing.seat(&pair.name));
        checks.extend(seat.as_ref().and_then(|seat| hand.force(seat)));
        let patches = sizing.patches.iter().filter(|p| p.interface == pair.name);
        for patch in patches {
            checks.extend(hand.patch(patch).map_err(no_form)?);
        }
        let lines = sizing.lines.iter();
        let lines = lines.filter(|line| line.interface == pair.name && !line.merged);
        let heaviest = lines.max_by(|a, b| a.peak_line_load.total_cmp(&b.peak_line_load));
        let Some(line) = heaviest else { continue };
        let even = seat.as_ref().zip(bearing);
        checks.extend(even.and_then(|(seat, bearing)| hand.even(seat, &bearing.geometry, line)));
        checks.extend(hand.hertz(line).map_err(no_form)?);
    }
    Ok(checks)
}

/// One interface of what was solved.
struct ByHand<'a> {
    scene: &'a Scene,
    answer: &'a Answer,
    units: &'a UnitLabels,
    pair: &'a ContactPair,
    /// Do lines that are images of each other bear the same?
    shared: bool,
}

impl ByHand<'_> {
    /// The whole load passes through every interface of a bearing, or is shared by rollers side by side.
    fn force(&self, seat: &Seat) -> Option<HandCheck> {
        let load = self.answer.applied_load;
        let (formula, by_hand) = match seat.sharing {
            1 => (format!("P = {}", number(load)), load),
            n if seat.determinate && self.shared => {
                (format!("P / {n}, P = {}", number(load)), load / n as f64)
            }
            _ => return None,
        };
        Some(HandCheck {
            what: format!("force along the load, {}", self.units.force),
            place: self.pair.name.clone(),
            formula,
            by_hand,
            found: Some(self.answer.interfaces.get(&self.pair.name)?.normal_force),
            error: None,
            differs: ROUNDING,
        })
    }

    /// The even load per length of a line of a centred bearing: on the flat one line has all, in a V two share.
    fn even(&self, seat: &Seat, geometry: &Dimensions, line: &SizedLine) -> Option<HandCheck> {
        let alone = !seat.is_valley() && seat.sharing == 1;
        if !seat.determinate || !(alone || self.shared) {
            return None;
        }
        let load = self.answer.applied_load;
        let length = bearing_length(seat, geometry.offset());
        let bears = match geometry.offset() {
            0.0 => "L'",
            _ => "(L' - 2 D_r)",
        };
        let numbers = format!("P = {}, {bears} = {}", number(load), number(length));
        let (formula, by_hand, differs) = match (seat.is_valley(), seat.sharing) {
            (true, _) => (
                format!("P / 2 {bears} cos θ, {numbers}"),
                load / (2.0 * length * seat.slope.cos()),
                FRICTION,
            ),
            (false, 1) => (format!("P / {bears}, {numbers}"), load / length, ROUNDING),
            (false, n) => (
                format!("P / {n} {bears}, {numbers}"),
                load / (n as f64 * length),
                ROUNDING,
            ),
        };
        Some(HandCheck {
            what: format!("even line load, {}", self.units.line_load()),
            place: line.interface.clone(),
            formula,
            by_hand,
            found: Some(line.even.line_load),
            error: None,
            differs,
        })
    }

    /// Hertz's line contact under the largest load per length of the heaviest line.
    fn hertz(&self, line: &SizedLine) -> Result<Vec<HandCheck>, DomainError> {
        let compliance = self.scene.compliance(self.pair)?;
        let radius = line.relative_radius;
        let contact = LineContact::new(line.peak_line_load, radius, compliance)?;
        let [q, r, c] = [line.peak_line_load, radius, compliance].map(number);
        let with = format!("q = {q} found, R = {r}, C_E = {c}");
        let of = |what| self.answer.figure(what, &self.pair.name);
        let mut checks = vec![
            HandCheck {
                what: format!("peak pressure, {}", self.units.stress),
                formula: format!("p0 = √(q / π R C_E), {with}"),
                ..self.found(contact.peak_pressure, of(Quantity::PeakPressure))
            },
            HandCheck {
                what: format!("half-width, {}", self.units.length),
                formula: format!("a = 2 √(q R C_E / π), {with}"),
                ..self.found(contact.half_width, of(Quantity::HalfWidth))
            },
        ];
        checks.extend(self.mises(&contact)?);
        Ok(checks)
    }

    /// Hertz's contact of a sphere; of an ellipse no formula is for a pocket calculator.
    fn patch(&self, patch: &SizedPatch) -> Result<Option<HandCheck>, DomainError> {
        /// Relative radii that differ by less are alike.
        const ALIKE: f64 = 1e-3;
        let [radius, other] = patch.relative_radii;
        if radius > (1.0 + ALIKE) * other {
            return Ok(None);
        }
        let compliance = self.scene.compliance(self.pair)?;
        let contact = PointContact::new(patch.force, radius, compliance)?;
        let [p, r, c] = [patch.force, radius, compliance].map(number);
        let figure = self.answer.figure(Quantity::PeakPressure, &self.pair.name);
        Ok(Some(HandCheck {
            what: format!("peak pressure, {}", self.units.stress),
            formula: format!("p0 = ∛(6 P / π³ R² C_E²), P = {p} found, R = {r}, C_E = {c}"),
            ..self.found(contact.peak_pressure, figure)
        }))
    }

    /// The largest Mises stress below the strip, in the plate; without a roller in the lower body.
    fn mises(&self, contact: &LineContact) -> Result<Option<HandCheck>, DomainError> {
        let sides = [&self.pair.upper, &self.pair.lower].map(|side| side.body(&self.scene.mesh));
        let name = |body: usize| self.scene.mesh.bodies[body].name.as_str();
        let mut plates = sides.into_iter().rev().flatten();
        let Some(plate) = plates.find(|body| !name(*body).contains("roller")) else {
            return Ok(None);
        };
        let ratio = self.scene.materials[plate].poissons_ratio;
        let mises = LineField::below(contact, ratio)?.peak_mises().value;
        let Some(figure) = self.answer.elastic_mises(name(plate)) else {
            return Ok(None);
        };
        let share = significant(mises / contact.peak_pressure, 3);
        let p0 = number(contact.peak_pressure);
        Ok(Some(HandCheck {
            what: format!("{}, {}", figure.what.name(), self.units.stress),
            place: figure.place.clone(),
            formula: format!("{share} p0 below the strip, p0 = {p0}"),
            differs: OTHERS,
            ..self.found(mises, Some(figure))
        }))
    }

    /// A figure of Hertz's beside what was found on the interface.
    fn found(&self, by_hand: f64, figure: Option<&Figure>) -> HandCheck {
        HandCheck {
            what: String::new(),
            place: self.pair.name.clone(),
            formula: String::new(),
            by_hand,
            found: figure.map(|f| f.value),
            error: figure.and_then(Figure::bar),
            differs: HALF_SPACE,
        }
    }
}

/// A number in a formula, with more digits than what is compared has.
fn number(value: f64) -> String {
    significant(value, 5)
}
