//! Figures of this run beside printed ones and Hertz's.

use crate::render::report::figures::{NOT_RESOLVED, number, with_error};
use crate::render::report::html::{row, table};
use crate::render::summary::{Reported, Summary};
use crate::render::text::significant;
use maud::{Markup, html};

pub fn compared(summary: &Summary) -> Markup {
    let rows: Vec<Vec<Markup>> = (summary.comparison.iter())
        .map(|c| {
            let value = match (c.value, c.resolved) {
                (Some(value), Some(false)) => format!("{}, {NOT_RESOLVED}", significant(value, 2)),
                (Some(value), _) => with_error(value, c.error),
                (None, _) => "–".to_string(),
            };
            let report = match c.report {
                Some(Reported::Value(value)) => number(Some(value)),
                Some(Reported::Range([low, high])) => {
                    format!("{} to {}", number(Some(low)), number(Some(high)))
                }
                None => "–".to_string(),
            };
            row([
                html! { (c.what) },
                html! { (c.place) },
                html! { (value) },
                html! { (report) },
                html! { (number(c.report_like)) },
                html! { (number(c.hertz)) },
            ])
        })
        .collect();
    if rows.is_empty() {
        return Markup::default();
    }
    let headings = [
        "figure",
        "<where",
        "this run",
        "printed",
        "report-like mesh",
        "Hertz, even load",
    ];
    html! {
        (table("", &headings, &rows))
        p class="note" { "Printed: what the case file cites. Hertz: the closed form for a line load spread evenly. \
                          Comparisons decide nothing." }
    }
}
