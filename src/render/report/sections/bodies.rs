//! The largest Mises stress of each body, read in three ways, and of the bores of rollers.

use crate::answer::certify::Quantity;
use crate::answer::{BodyFigures, Three};
use crate::render::report::Inputs;
use crate::render::report::figures::{number, share, with_error};
use crate::render::report::html::table;
use crate::render::summary::Summary;
use crate::render::text::{place, significant};
use maud::{Markup, html};

pub fn bodies(inputs: &Inputs) -> Markup {
    let summary = inputs.summary;
    if summary.answer.bodies.0.is_empty() {
        return Markup::default();
    }
    let units = &summary.units;
    let mut rows = Vec::new();
    let mut marked = false;
    for (name, body) in &summary.answer.bodies.0 {
        marked |= body.at_singular_edge.each().contains(&true);
        rows.push(body_row(name, body, summary));
        if let Some(elastic) = &body.elastic_mises_max {
            let error = total(summary, Quantity::ElasticPeakMises, name);
            let mut row = vec![html! { "– without yielding" }];
            row.extend(peaks(elastic, &body.at_singular_edge, error));
            rows.push(row);
        }
    }
    let caption = format!("Largest Mises stress, {}", units.stress);
    let yielded = format!("yielded, {}", units.volume());
    let at = format!("nodal peak at, {}", units.length);
    let headings = [
        "body",
        "centroid",
        "integration point",
        "nodal",
        "plastic strain",
        &yielded,
        "of body",
        &at,
    ];
    html! {
        (table(&caption, &headings, &rows))
        @if marked {
            p class="note" { "* beside a loaded edge, such as a square roller end, where elastic stress has no \
                              bound: a figure of this mesh." }
        }
        p class="note" {
            "Centroid: of the mean of an element's integration points. Integration point: the largest at any. \
             Nodal: extrapolated to the nodes and averaged, with its estimated error."
        }
        (bores(summary))
    }
}

fn total(summary: &Summary, what: Quantity, place: &str) -> Option<f64> {
    summary.answer.figure(what, place).and_then(|c| c.bar())
}

fn body_row(name: &str, body: &BodyFigures, summary: &Summary) -> Vec<Markup> {
    let error = total(summary, Quantity::PeakMises, name);
    let strain_error = total(summary, Quantity::PeakPlasticStrain, name);
    let mut row = vec![html! { (name) }];
    row.extend(peaks(&body.mises_max, &body.at_singular_edge, error));
    row.push(match body.peeq_max > 0.0 {
        true => html! { (with_error(body.peeq_max, strain_error)) },
        false => html! { "0" },
    });
    row.push(html! { (significant(body.yielded_volume, 3)) });
    row.push(html! { (share(Some(body.yielded_volume / body.volume))) });
    row.push(html! { (body.at.nodal.map_or_else(|| "–".to_string(), place)) });
    row
}

fn peaks(
    values: &Three<Option<f64>>,
    singular: &Three<bool>,
    error: Option<f64>,
) -> impl Iterator<Item = Markup> {
    let cells = values.each().into_iter().zip(singular.each()).enumerate();
    let cell = move |(k, (value, singular)): (usize, (Option<f64>, bool))| {
        let text = match value {
            // The nodal reading is the one with an error.
            Some(value) if k == 2 && error.is_some() => with_error(value, error),
            Some(value) if singular => significant(value, 2),
            value => number(value),
        };
        html! { (text) @if singular && value.is_some() { "*" } }
    };
    cells.map(cell)
}

fn bores(summary: &Summary) -> Markup {
    let rows: Vec<Vec<Markup>> = (summary.answer.rollers.0.iter())
        .map(|(name, roller)| {
            let at = roller.bore_mises_at.map_or_else(|| "–".to_string(), place);
            [
                name.clone(),
                number(roller.bore_mises),
                at,
                number(roller.bore_mises_nodal),
            ]
            .iter()
            .map(|cell| html! { (cell) })
            .collect()
        })
        .collect();
    let caption = format!(
        "Mises stress on the bores of the rollers, {}",
        summary.units.stress
    );
    let at = format!("at, {}", summary.units.length);
    let headings = [
        "roller",
        "under the load line, from the strain",
        &at,
        "largest nodal",
    ];
    table(&caption, &headings, &rows)
}
