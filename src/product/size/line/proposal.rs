//! The table of candidates and the one that is recommended.

use super::candidate::{LineCandidate, PLATE_TO_DIAMETER};
use super::request::LineRequest;
use crate::analytic::hertz::LineContact;
use crate::case::bearing::MOST_ROLLERS;
use crate::ground::units::{Dimension, UnitLabels};
use crate::product::size::candidate::{SLENDEREST, compliance};
use crate::product::size::practical::diameters;
use crate::product::size::rows::rows;
use crate::product::size::{SizeError, SizingAssumption};
use serde::Serialize;

/// The shortest rollers, in diameters: shorter ones tip before they roll.
const STUBBIEST: f64 = 0.5;
/// The first diameter of the table, as a share of that of rollers as long as they are thick.
const FIRST_DIAMETER: f64 = 0.5;
/// Rows beyond the recommended one.
const ROWS_BEYOND: usize = 2;
/// The most rows.
const MOST_ROWS: usize = 40;

/// What is proposed for a request.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LineProposal {
    pub units: UnitLabels,
    #[serde(skip)]
    pub request: LineRequest,
    pub candidates: Vec<LineCandidate>,
    /// The recommended one, by its place in the table; none where none will do.
    pub recommended: Option<usize>,
    /// Why that one, or why none.
    pub why: String,
    pub assumptions: Vec<SizingAssumption>,
}

impl LineProposal {
    /// Sizes parallel rollers.
    ///
    /// # Errors
    /// [`SizeError`] for a request that no bearing can meet.
    pub fn new(request: &LineRequest) -> Result<Self, SizeError> {
        request.check()?;
        let candidates = candidates(request)?;
        let recommended = candidates.iter().position(|c| will_do(request, c));
        Ok(Self {
            units: UnitLabels::of(request.units),
            why: why(request, recommended.is_some()),
            assumptions: assumptions(request),
            request: request.clone(),
            candidates,
            recommended,
        })
    }

    /// The recommended bearing.
    pub fn choice(&self) -> Option<&LineCandidate> {
        self.candidates.get(self.recommended?)
    }
}

/// Rows of one diameter with more and more rollers where the diameter is fixed, else of more and more diameters.
fn candidates(request: &LineRequest) -> Result<Vec<LineCandidate>, SizeError> {
    if let Some(diameter) = request.diameter {
        let numbers = request.rollers.map_or(1..=MOST_ROLLERS, |n| n..=n);
        return table(request, numbers.map(|rollers| (rollers, diameter)));
    }
    let rollers = request.rollers.unwrap_or(1);
    let limit = request.limit.value * request.yield_stress;
    // A line load at the limit goes with the diameter: n L D is the same for all.
    let compliance = compliance(request.modulus.value, request.poissons_ratio.value)?;
    let at_one = LineContact::at_peak_pressure(limit, 0.5, compliance)?.line_load;
    let product = request.load * request.margin.value / (rollers as f64 * at_one);
    let first = match request.length {
        Some(length) => 0.8 * product / length,
        None => FIRST_DIAMETER * product.sqrt(),
    };
    table(
        request,
        diameters(request.units, first).map(|d| (rollers, d)),
    )
}

fn table(
    request: &LineRequest,
    tried: impl Iterator<Item = (usize, f64)>,
) -> Result<Vec<LineCandidate>, SizeError> {
    let tried = tried.take(MOST_ROWS);
    let tried = tried.map(|(rollers, diameter)| LineCandidate::new(request, rollers, diameter));
    let will_do = |candidate: &LineCandidate| will_do(request, candidate);
    rows(tried, ROWS_BEYOND, will_do, |_| false)
}

/// Long enough, and neither slender nor stubby where the length is open.
fn will_do(request: &LineRequest, candidate: &LineCandidate) -> bool {
    let slender = (STUBBIEST..=SLENDEREST).contains(&candidate.slenderness);
    candidate.is_long_enough() && (request.length.is_some() || slender)
}

fn why(request: &LineRequest, any: bool) -> String {
    let open = match (request.diameter, request.rollers) {
        (Some(_), None) => "number of rollers",
        _ => "diameter",
    };
    let margin = match request.margin.value {
        1.0 => String::new(),
        margin => format!(", for {margin} times the load (--margin)"),
    };
    match (any, request.length.is_some()) {
        (true, false) => format!(
            "the smallest {open} whose rollers are no longer than {SLENDEREST:.2} diameters (the reference study's \
             slenderest) and no shorter than {STUBBIEST}"
        ),
        (true, true) => {
            format!(
                "the smallest {open} that keeps p0 within its limit on the given length{margin}"
            )
        }
        (false, true) => {
            format!(
                "no {open} of the table keeps p0 within its limit on the given --length{margin}"
            )
        }
        (false, false) => format!(
            "no {open} of the table has rollers between {STUBBIEST} and {SLENDEREST:.2} diameters long: leave \
             --diameter or --rollers open, or fix --length"
        ),
    }
}

fn assumptions(request: &LineRequest) -> Vec<SizingAssumption> {
    let stress = |value| request.units.show(value, Dimension::STRESS);
    let entry = SizingAssumption::new;
    let (modulus, margin) = (request.modulus, request.margin);
    vec![
        entry(
            "--modulus",
            stress(modulus.value),
            modulus.given,
            "of steel",
        ),
        entry(
            "--friction",
            request.friction.value.to_string(),
            request.friction.given,
            "greasy steel on steel; without effect under a central load",
        ),
        entry(
            "--wall",
            request
                .wall
                .map_or("solid".to_owned(), |wall| format!("{wall} D")),
            request.wall.is_some(),
            match request.wall {
                Some(_) => {
                    "the limit is of solid rollers, and a wall bends as a ring: below 0.25 D section 2.6.2 asks for a \
                            finite-element analysis, as --verify makes"
                }
                None => "rollers without a bore, unless a wall is given",
            },
        ),
        entry(
            "--plate",
            request
                .plate
                .map_or(format!("{PLATE_TO_DIAMETER} D"), |plate| {
                    request.units.show(plate, Dimension::LENGTH)
                }),
            request.plate.is_some(),
            "no rule: plates are as long as the rollers and reach 3/4 D beyond the outermost axes",
        ),
        entry(
            "--limit",
            format!("{} of the yield stress", request.limit.value),
            request.limit.given,
            "(2-49), meant for the service limit state",
        ),
        entry(
            "--margin",
            format!("for {} times the load", margin.value),
            margin.given,
            "an even load does not see that ends bulge and plates bend; --verify does",
        ),
    ]
}
