//! What a checker can recompute by hand: the equilibrium of each interface, and Hertz's line contact under the load per
//! length that the run found.

use super::error::JobError;
use crate::analytic::hertz::LineContact;
use crate::analytic::subsurface::LineField;
use crate::analytic::{DomainError, Elastic, contact_compliance};
use crate::answer::Answer;
use crate::answer::certify::{Figure, Quantity};
use crate::case::{BearingCase, Case, Kind};
use crate::model::scene::Scene;
use crate::render::summary::{HandCheck, SizedLine, Sizing};
use crate::render::text::significant;

/// Digits of the numbers in a formula: more than what is compared has.
const NUMBERS: usize = 5;

const FRICTION: &str = "friction on the slopes carries a part";
const HALF_SPACE: &str = "bodies are no half spaces, and rollers bend";
const OTHERS: &str = "bodies are no half spaces; other lines and bending add to the peak of a body";
const ROUNDING: &str = "they agree but for rounding";

/// The checks of a bearing; none of a general scene.
pub fn hand_checks(
    case: &Case,
    scene: &Scene,
    (answer, sizing): (&Answer, Option<&Sizing>),
) -> Result<Vec<HandCheck>, JobError> {
    let (Kind::Bearing(bearing), Some(sizing)) = (&case.kind, sizing) else {
        return Ok(Vec::new());
    };
    let mut checks = Vec::new();
    for (name, interface) in &answer.interfaces.0 {
        let force = &case.units.force();
        checks.push(HandCheck {
            what: format!("force along the load, {force}"),
            place: name.clone(),
            formula: format!("P = {}", significant(bearing.load, NUMBERS)),
            by_hand: bearing.load,
            found: Some(interface.normal_force),
            error: None,
            differs: ROUNDING,
        });
        let lines = sizing
            .lines
            .iter()
            .filter(|l| l.interface == *name && !l.merged);
        let heaviest = lines.max_by(|a, b| a.peak_line_load.total_cmp(&b.peak_line_load));
        let Some(line) = heaviest else { continue };
        let checked = LineCheck::new(bearing, scene, (answer, line)).map_err(|error| {
            JobError::ClosedForm {
                what: "what can be recomputed by hand".to_owned(),
                why: error.to_string(),
            }
        })?;
        checks.extend(checked.into_iter().flat_map(|checked| checked.all(case)));
    }
    Ok(checks)
}

/// The heaviest line of an interface.
struct LineCheck<'a> {
    bearing: &'a BearingCase,
    answer: &'a Answer,
    line: &'a SizedLine,
    contact: LineContact,
    /// C_E of (2-46).
    compliance: f64,
    /// The plate, and Hertz's largest Mises stress in it.
    plate: (&'a str, f64),
}

impl<'a> LineCheck<'a> {
    /// `None` where the bodies are not those of a bearing.
    fn new(
        bearing: &'a BearingCase,
        scene: &Scene,
        (answer, line): (&'a Answer, &'a SizedLine),
    ) -> Result<Option<Self>, DomainError> {
        let Some((upper, lower)) = line.interface.split_once('-') else {
            return Ok(None);
        };
        let steel = |body: &str| scene.materials.get(scene.mesh.body(body)?);
        let (Some(above), Some(below)) = (steel(upper), steel(lower)) else {
            return Ok(None);
        };
        let [above, below] =
            [above, below].map(|steel| Elastic::new(steel.youngs_modulus, steel.poissons_ratio));
        let (above, below) = (above?, below?);
        let compliance = contact_compliance(above, below)?;
        let contact = LineContact::new(line.peak_line_load, bearing.geometry.radius(), compliance)?;
        let (plate, ratio) = match upper.contains("roller") {
            true => (lower, below.poissons_ratio()),
            false => (upper, above.poissons_ratio()),
        };
        let mises = LineField::below(&contact, ratio)?.peak_mises().value;
        Ok(Some(Self {
            bearing,
            answer,
            line,
            contact,
            compliance,
            plate: (plate, mises),
        }))
    }

    fn all(&self, case: &Case) -> Vec<HandCheck> {
        let (length, stress) = (case.units.length(), case.units.stress());
        let number = |value: f64| significant(value, NUMBERS);
        let radius = number(self.bearing.geometry.radius());
        let (q, compliance) = (number(self.line.peak_line_load), number(self.compliance));
        let with = format!("q = {q} found, R = {radius}, C_E = {compliance}");
        let interface = &self.line.interface;
        let check =
            |what: String, formula: String, by_hand, figure: Option<&Figure>, differs| HandCheck {
                what,
                place: figure.map_or(interface, |f| &f.place).clone(),
                formula,
                by_hand,
                found: figure.map(|f| f.value),
                error: figure.and_then(Figure::bar),
                differs,
            };
        let of = |what| self.answer.figure(what, interface);
        let (plate, mises) = self.plate;
        let p0 = number(self.contact.peak_pressure);
        let peak = [
            Quantity::ElasticMisesAway,
            Quantity::ElasticPeakMises,
            Quantity::MisesAway,
            Quantity::PeakMises,
        ];
        let peak = peak
            .into_iter()
            .find_map(|what| self.answer.figure(what, plate));
        let mut checks: Vec<HandCheck> = self.even(case).into_iter().collect();
        checks.extend([
            check(
                format!("peak pressure, {stress}"),
                format!("p0 = √(q / π R C_E), {with}"),
                self.contact.peak_pressure,
                of(Quantity::PeakPressure),
                HALF_SPACE,
            ),
            check(
                format!("half-width, {length}"),
                format!("a = 2 √(q R C_E / π), {with}"),
                self.contact.half_width,
                of(Quantity::HalfWidth),
                HALF_SPACE,
            ),
            check(
                format!("elastic Mises, {stress}"),
                format!(
                    "{} p0 below the strip, p0 = {p0}",
                    significant(mises / self.contact.peak_pressure, 3)
                ),
                mises,
                peak,
                OTHERS,
            ),
        ]);
        checks
    }

    /// The even load per length of a line of a centred bearing: on the flat one line has all, in a V two share.
    fn even(&self, case: &Case) -> Option<HandCheck> {
        let geometry = &self.bearing.geometry;
        if !geometry.is_centred() {
            return None;
        }
        let (load, length) = (self.bearing.load, geometry.length);
        let in_valley = self.line.interface.contains("intermediate_plate");
        let [p, l] = [load, length].map(|value| significant(value, NUMBERS));
        let (formula, by_hand, differs) = match in_valley {
            true => (
                format!("P / 2 L' cos θ, P = {p}, L' = {l}"),
                load / (2.0 * length * geometry.slope.cos()),
                FRICTION,
            ),
            false => (
                format!("P / L', P = {p}, L' = {l}"),
                load / length,
                ROUNDING,
            ),
        };
        Some(HandCheck {
            what: format!(
                "even line load, {}/{}",
                case.units.force(),
                case.units.length()
            ),
            place: self.line.interface.clone(),
            formula,
            by_hand,
            found: Some(self.line.even.line_load),
            error: None,
            differs,
        })
    }
}
