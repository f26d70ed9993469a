//! What the figures are worth: each with its estimated error, by cause.

use crate::answer::certify::Figure;
use crate::render::figures::MESH_DIGITS;
use crate::render::summary::Summary;
use crate::render::table::{Cell, Number, Table};

/// Every certified figure.
pub fn certificate(summary: &Summary) -> Table {
    let certificate = &summary.answer.certificate;
    let beside_edges = (certificate.iter()).any(|figure| figure.error.beside_edge.is_some());
    let mut table = Table::new("")
        .words("Certificate")
        .words("where")
        .figures(["value", "± error", "mesh"])
        .figures(beside_edges.then_some("beside an edge"))
        .figures(["penetration", "increments"])
        .about(
            "Estimated from the one mesh that was solved; of the right size, and no bounds. A peak at a singular edge \
             gets a remark in place of an error.",
        );
    for figure in certificate {
        let unit = match summary.units.of_measure(figure.what.measure()) {
            unit if unit.is_empty() => unit,
            unit => format!(", {unit}"),
        };
        let off = |error: Option<f64>| {
            let error = error.filter(|_| figure.value != 0.0);
            Cell::Off(error.map(|error| error / figure.value.abs()))
        };
        let error = match figure.bar() {
            Some(error) => Cell::Figure(Number::new(error, MESH_DIGITS)),
            None => Cell::Care("unresolved".to_string()),
        };
        let first = [
            format!("{}{unit}", figure.what.name()).into(),
            (&figure.place).into(),
            Cell::certified(figure.value, Some(figure)),
            error,
        ];
        let causes = [
            Some(figure.error.discretisation),
            beside_edges.then_some(figure.error.beside_edge),
            Some(figure.error.penetration),
            Some(figure.error.increment),
        ];
        table.row(
            first
                .into_iter()
                .chain(causes.into_iter().flatten().map(off)),
        );
    }
    table.note("The error in the unit of the figure, its causes relative to the figure.");
    table.notes.extend(remarks(certificate));
    table
}

/// Each remark once, with the figures that it is about.
fn remarks(figures: &[Figure]) -> impl Iterator<Item = String> {
    let mut remarks: Vec<(&str, Vec<String>)> = Vec::new();
    for figure in figures {
        let Some(note) = figure.note else { continue };
        let name = format!("{} of {}", figure.what.name(), figure.place);
        match remarks.iter_mut().find(|(known, _)| *known == note) {
            Some((_, names)) => names.push(name),
            None => remarks.push((note, vec![name])),
        }
    }
    let lines = remarks.into_iter();
    lines.map(|(note, names)| format!("{}: {note}", names.join(", ")))
}
