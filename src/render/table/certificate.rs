//! What the figures are worth, in the table.

use super::{DIGITS, number};
use crate::answer::certify::Figure;
use crate::render::summary::Summary;
use crate::render::text::{Columns, significant};

pub(super) fn certificate(summary: &Summary) -> String {
    let units = &summary.units;
    let mut table = Columns::new(&[
        "Certificate",
        "where",
        "value",
        "± error",
        "mesh",
        "penetration",
        "increments",
    ]);
    for claim in &summary.answer.certificate {
        let unit = match units.of_measure(claim.what.measure()) {
            unit if unit.is_empty() => unit,
            unit => format!(", {unit}"),
        };
        table.row([
            format!("{}{unit}", claim.what.name()),
            claim.place.clone(),
            significant(claim.value, DIGITS),
            bar(claim),
            share(claim, claim.error.discretisation),
            share(claim, claim.error.penetration),
            share(claim, claim.error.increment),
        ]);
    }
    if table.is_empty() {
        return String::new();
    }
    let text = table.render().replacen("  Certificate", "Certificate", 1);
    let units = "  The error in the unit of the figure, its causes relative to the figure.\n";
    text + units + &notes(&summary.answer.certificate)
}

/// The whole error, or that none is known.
fn bar(claim: &Figure) -> String {
    let known = claim.bar().map(|error| significant(error, 2));
    known.unwrap_or_else(|| "unresolved".to_owned())
}

/// An error relative to its figure.
fn share(claim: &Figure, error: Option<f64>) -> String {
    match error.filter(|_| claim.value != 0.0) {
        Some(error) => format!("{} %", significant(100.0 * error / claim.value.abs(), 2)),
        None => number(None),
    }
}

/// Each remark once, with the figures that it is about.
fn notes(claims: &[Figure]) -> String {
    let mut remarks: Vec<(&str, Vec<String>)> = Vec::new();
    for claim in claims {
        let Some(note) = claim.note else { continue };
        let figure = format!("{} of {}", claim.what.name(), claim.place);
        match remarks.iter_mut().find(|(known, _)| *known == note) {
            Some((_, figures)) => figures.push(figure),
            None => remarks.push((note, vec![figure])),
        }
    }
    let lines = remarks.iter();
    let lines = lines.map(|(note, figures)| format!("  {}: {note}\n", figures.join(", ")));
    lines.collect()
}
