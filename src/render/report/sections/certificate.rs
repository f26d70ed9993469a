//! The certificate: figures with their estimated errors, by cause.

use crate::answer::certify::Figure;
use crate::render::report::figures::{NOT_RESOLVED, number, unit_of, with_error};
use crate::render::report::html::{row, table};
use crate::render::summary::Summary;
use crate::render::text::significant;
use maud::{Markup, html};

pub fn certificate(summary: &Summary) -> Markup {
    if summary.answer.certificate.is_empty() {
        return Markup::default();
    }
    let rows: Vec<Vec<Markup>> = (summary.answer.certificate.iter())
        .map(|claim| {
            row([
                html! { (claim.what.name()) },
                html! { (claim.place) },
                html! { (figure(claim)) " " (unit_of(claim.what, &summary.units)) },
                html! { (relative(claim, claim.bar())) },
                html! { (relative(claim, claim.error.discretisation)) },
                html! { (relative(claim, claim.error.penetration)) },
                html! { (relative(claim, claim.error.increment)) },
                html! { (claim.note.unwrap_or_default()) },
            ])
        })
        .collect();
    let headings = [
        "figure",
        "<where",
        "value",
        "error",
        "of the mesh",
        "of penetration",
        "of increments",
        "<remark",
    ];
    html! {
        (table("", &headings, &rows))
        p class="note" {
            "Estimated from the one mesh that was solved; of the right size, and no bounds. A peak at a loaded edge \
             gets a remark in place of an error."
        }
    }
}

/// The figure with its error, or as one that this mesh does not resolve.
fn figure(claim: &Figure) -> Markup {
    match claim.bar() {
        Some(error) => html! { (with_error(claim.value, Some(error))) },
        None => html! { (significant(claim.value, 2)) " " b class="care" { (NOT_RESOLVED) } },
    }
}

fn relative(claim: &Figure, error: Option<f64>) -> String {
    match error.filter(|_| claim.value != 0.0) {
        Some(error) => format!("{} %", significant(100.0 * error / claim.value.abs(), 2)),
        None => number(None),
    }
}
