//! Design rules, each with its limit and what it says of the loads; then what the steel does.

use crate::analytic::rules::{Judged, Limit};
use crate::answer::certify::{Figure, Quantity};
use crate::ground::units::UnitLabels;
use crate::render::summary::{JudgedRule, RuleSheet, SteelAfter, Summary};
use crate::render::table::{Cell, Table};

const TITLE: &str = "Design rules";

/// The rules of a run, and its steel.
pub fn rules(summary: &Summary) -> Vec<Table> {
    let Some(sheet) = &summary.rules else {
        return Vec::new();
    };
    let mut rules = rule_table(sheet, &summary.units).about(
        "Under the load of the worst line of contact spread evenly over the length that bears, and under the largest \
         load per length that the solution found. Indicative rules are of standards whose text was not at hand. Rules \
         take rollers as solid and loads as even; what the steel does stands below.",
    );
    rules.title = TITLE.to_string();
    vec![rules, steel_table(&sheet.steel, summary)]
}

/// The rules that apply, a row each; of the others why they do not.
pub fn rule_table(sheet: &RuleSheet, units: &UnitLabels) -> Table {
    let with_largest = sheet.rules.iter().any(|rule| rule.largest.is_some());
    let mut table = Table::new(TITLE)
        .words("rule")
        .figure("limit", units.line_load())
        .figure("as p0", &units.stress)
        .figure("even", units.line_load())
        .figures(["of limit"])
        .words("verdict");
    if with_largest {
        table = table
            .figure("largest", units.line_load())
            .figures(["of limit"])
            .words("verdict");
    }
    table = table.words("source");
    for JudgedRule {
        rule,
        even,
        largest,
        ..
    } in &sheet.rules
    {
        match &rule.limit {
            Limit::Holds(bound) => {
                let mut row = vec![
                    rule.name.into(),
                    Cell::figure(bound.line_load),
                    Cell::figure(bound.pressure),
                ];
                row.extend(judged(even.as_ref()));
                if with_largest {
                    row.extend(judged(largest.as_ref()));
                }
                row.push(rule.source.into());
                table.row(row);
                if !rule.notes.is_empty() {
                    table.note(format!("{}: {}", rule.name, rule.notes.join("; ")));
                }
            }
            Limit::Needs(what) => table.note(format!("{}: left out, needs {what}", rule.name)),
            Limit::Refused(why) => table.note(format!("{}: does not apply: {why}", rule.name)),
        }
    }
    for note in &sheet.notes {
        table.note(note);
    }
    if !sheet.steel.is_empty() && sheet.steel.iter().all(|body| body.peeq_max == 0.0) {
        table.note("under this load nothing yields");
    }
    table
}

/// Load, share of the limit, verdict.
fn judged(judged: Option<&Judged>) -> [Cell; 3] {
    let Some(judged) = judged else {
        return [Cell::figure(None), Cell::Share(None), "-".into()];
    };
    let words = judged.verdict.to_string();
    [
        Cell::figure(judged.line_load),
        Cell::Share(Some(judged.utilisation)),
        match judged.verdict.is_within() {
            Some(true) => words.into(),
            _ => Cell::Care(words),
        },
    ]
}

/// Bodies that have flowed, with what the certificate says of their figures.
fn steel_table(steel: &[SteelAfter], summary: &Summary) -> Table {
    let units = &summary.units;
    let unloaded = steel.iter().any(|body| body.dent.is_some());
    let mut table = Table::new("What the steel does under the load")
        .words("body")
        .figures(["plastic strain", "away from edges"])
        .figure("yielded", units.volume())
        .figures(["of body"]);
    if unloaded {
        table = table.figure("dent", &units.length).figures(["over D"]);
    }
    let changed = |body: &&SteelAfter| body.peeq_max > 0.0 || body.dent.is_some_and(|d| d > 0.0);
    for body in steel.iter().filter(changed) {
        let mut row = vec![
            (&body.body).into(),
            claimed(
                body.peeq_max,
                summary
                    .answer
                    .figure(Quantity::PeakPlasticStrain, &body.body),
            ),
            Cell::rough(body.peeq_away),
            Cell::rough(body.yielded_volume),
            Cell::Share(Some(body.yielded_share)),
        ];
        if unloaded {
            let claim = (body.dent_in.as_ref())
                .and_then(|surface| summary.answer.figure(Quantity::Dent, surface));
            let dent = body
                .dent
                .map_or(Cell::figure(None), |dent| claimed(dent, claim));
            row.extend([dent, Cell::rough(body.dent_over_diameter)]);
        }
        table.row(row);
    }
    if !unloaded {
        table.note("with `unload = true` also the dents that stay");
    }
    table
}

/// A figure with its error, or that it is not resolved, everywhere.
fn claimed(value: f64, claim: Option<&Figure>) -> Cell {
    match Cell::certified(value, claim) {
        Cell::Figure(number) => Cell::Estimate(number),
        other => other,
    }
}
