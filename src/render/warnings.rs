//! What a reader must know before trusting a figure.

use serde::Serialize;

use super::text::percent;
use crate::answer::Answer;
use crate::answer::BodyFigures;
use crate::answer::certify::{Figure, Quantity, WITHOUT_INCREMENTS};
use crate::answer::checks::NOTABLE_SHARE;
use crate::answer::results::hertz::HALF_STRIP;

/// A sentence of warning.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(transparent)]
pub struct Warning(pub String);

/// Small-strain theory is good to about this strain.
const SMALL_STRAIN_LIMIT: f64 = 0.02;

/// The warnings that the figures of an answer call for.
pub fn warnings(answer: &Answer) -> Vec<Warning> {
    let mut list = Vec::new();
    let mut warn = |text: String| list.push(Warning(text));
    if answer.interrupted {
        warn(
            "the run was interrupted: no figure here is an answer; --resume goes on with it"
                .to_string(),
        );
    } else if !answer.converged {
        warn("the solution has not converged: no figure here is an answer".to_string());
    }
    if let Some(strain) = answer.max_strain.filter(|s| *s > SMALL_STRAIN_LIMIT) {
        let (strain, limit) = (percent(strain), percent(SMALL_STRAIN_LIMIT));
        warn(format!(
            "largest strain {strain}: small-strain theory is in doubt above {limit}"
        ));
    }
    let bodies = answer.bodies.0.iter();
    for (names, text) in together(bodies.map(|(name, body)| (name.as_str(), of_body(body)))) {
        warn(format!("{}: {text}", names.join(", ")));
    }
    for (names, text) in together(pressures_at_edges(&answer.standing().1)) {
        warn(format!("{}: {text}", names.join(", ")));
    }
    if let Some(text) = of_unresolved(&answer.unresolved()) {
        warn(text);
    }
    let unaware = |f: &&Figure| f.is_resolved() && f.note == Some(WITHOUT_INCREMENTS);
    let number = answer.certificate.iter().filter(unaware).count();
    if number > 0 && !answer.interrupted {
        warn(format!(
            "{number} bars are too narrow: no second solution tells what the size of the increments does \
             (a smaller `first_increment` may)"
        ));
    }
    for (name, roller) in &answer.rollers.0 {
        if roller.bore_mises.is_none() {
            let why = match roller.bore_mises_nodal {
                Some(_) => "the wall has yielded under the load or its shape is no bore",
                None => "the mesh has no such surface",
            };
            warn(format!(
                "{name}: no Mises stress from the strain of the bore: {why}"
            ));
        }
    }
    for (name, interface) in &answer.interfaces.0 {
        if interface.max_pressure <= 0.0 {
            warn(format!(
                "{name}: the surfaces do not touch, so this contact pair carries nothing"
            ));
        }
        if interface.not_hertz == Some(HALF_STRIP) {
            warn(format!(
                "{name}: the line of contact is no strip of Hertz's: {HALF_STRIP}"
            ));
        }
        let (Some(q), load) = (&interface.q, interface.normal_force.abs()) else {
            continue;
        };
        if q.outside.abs() > NOTABLE_SHARE * load {
            let share = percent(q.outside.abs() / load);
            warn(format!(
                "{name}: {share} of the load lies outside the slices of the line load"
            ));
        }
    }
    if let Some(share) = answer.checks.force_balance.filter(|s| *s > NOTABLE_SHARE) {
        warn(format!(
            "an interface misses the load by {}",
            percent(share)
        ));
    }
    if let Some(share) = answer
        .checks
        .stabilisation_share
        .filter(|s| *s > NOTABLE_SHARE)
    {
        warn(format!(
            "stabilisation carries {} of the load",
            percent(share)
        ));
    }
    list
}

/// Of every interface whose largest pressure is where the mesh does not resolve it, why.
fn pressures_at_edges<'a>(replaced: &[&'a Figure]) -> impl Iterator<Item = (&'a str, Vec<String>)> {
    let pressures = replaced
        .iter()
        .filter(|claim| claim.what == Quantity::PeakPressure);
    pressures.map(|claim| {
        let (what, why) = (claim.what.name(), claim.note.unwrap_or_default());
        let text =
            format!("{what} is not resolved, and that away from edges counts in its place: {why}");
        (claim.place.as_str(), vec![text])
    })
}

/// The figures of which this mesh says nothing, in one sentence.
fn of_unresolved(claims: &[&Figure]) -> Option<String> {
    let figures = claims
        .iter()
        .map(|c| (c.what.name(), vec![c.place.clone()]));
    let named: Vec<String> = together(figures)
        .into_iter()
        .map(|(figures, place)| format!("{} of {place}", figures.join(", ")))
        .collect();
    (!named.is_empty()).then(|| {
        let named = named.join("; ");
        format!("not resolved by this mesh: {named}")
    })
}

/// The sentences, each with all the names that it holds for.
fn together<'a>(
    of_names: impl Iterator<Item = (&'a str, Vec<String>)>,
) -> Vec<(Vec<&'a str>, String)> {
    let mut list: Vec<(Vec<&str>, String)> = Vec::new();
    for (name, texts) in of_names {
        for text in texts {
            match list.iter_mut().find(|(_, known)| *known == text) {
                Some((names, _)) => names.push(name),
                None => list.push((vec![name], text)),
            }
        }
    }
    list
}

fn of_body(body: &BodyFigures) -> Vec<String> {
    let mut list = Vec::new();
    let singular: Vec<&str> = ["centroid", "integration point", "nodal"]
        .into_iter()
        .zip(body.at_singular_edge.each())
        .filter_map(|(measure, singular)| singular.then_some(measure))
        .collect();
    if !singular.is_empty() {
        let measures = singular.join(", ");
        list.push(format!(
            "the peak ({measures}) sits on a singular edge: a loaded edge, such as a square roller end, an edge of \
             what is held, an inner corner, or the rim of a tie; there elastic stress has no bound, so the value belongs \
             to this mesh, not to the part"
        ));
    }
    if body.peeq_max > 0.0 && body.elastic_mises_max.is_none() {
        list.push(
            "the peak has yielded, so it says nothing about the mesh; the elastic peak is not known"
                .to_string(),
        );
    }
    list
}
