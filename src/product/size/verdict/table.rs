//! The verdict as text.

use super::check::{LimitCheck, LimitKind};
use super::design::DesignVerdict;
use super::position::Placed;
use super::standing::Standing;
use crate::product::size::table::wrapped;
use crate::render::figures::MESH_DIGITS;
use crate::render::table::text::text as table_text;
use crate::render::table::{Cell, Number, Table};
use crate::render::text::{percent, significant};
use std::fmt::Write;

/// Everything, every line ended.
pub fn render(verdict: &DesignVerdict) -> String {
    let mut text = String::new();
    for placed in &verdict.positions {
        text += &position(verdict, placed);
        text.push('\n');
    }
    text + &conclusion(verdict)
}

/// The same as a Markdown file.
pub fn page(verdict: &DesignVerdict) -> String {
    let units = &verdict.units;
    let design = &verdict.design;
    let n = |value: f64| significant(value, 4);
    format!(
        "# Verdict: {}\n\n\
         Load {} {}, steel of {} {}, displacement {} {}; rollers {} x {} {}, wall {}, plates {}; mesh `{}`, \
         Brinell {}.\n\n```text\n{}```\n",
        match (verdict.met, verdict.open) {
            (true, 0) => "met".to_string(),
            (true, open) => format!("no limit missed, {open} open"),
            (false, _) =>
                if verdict.positions.iter().any(Placed::misses) {
                    "MISSED".to_string()
                } else {
                    "none, not resolved".to_string()
                },
        },
        n(verdict.load),
        units.force,
        n(verdict.yield_stress),
        units.stress,
        n(verdict.capacity),
        units.length,
        n(design.diameter),
        n(design.length),
        units.length,
        n(design.wall),
        n(design.plate),
        verdict.mesh,
        verdict.brinell_version,
        render(verdict)
    )
}

fn said(standing: Standing) -> &'static str {
    match standing {
        Standing::Met => "yes",
        Standing::MetWithinError => "yes, within ±",
        Standing::MissedWithinError => "NO, within ±",
        Standing::Missed => "NO",
        Standing::Open => "open",
        Standing::Unresolved => "NOT RESOLVED",
        Standing::NotJudged => "not judged",
    }
}

fn what(check: &LimitCheck, verdict: &DesignVerdict) -> String {
    let units = &verdict.units;
    match (check.kind, check.line_load) {
        (LimitKind::ContactPressure, Some(q)) => {
            format!(
                "p0 at {} {}, {}",
                significant(q, 4),
                units.line_load(),
                units.stress
            )
        }
        (LimitKind::ContactPressure | LimitKind::ElasticMises, _) => {
            format!("{}, {}", check.kind.name(), units.stress)
        }
        (kind, _) => kind.name().to_string(),
    }
}

fn position(verdict: &DesignVerdict, placed: &Placed) -> String {
    let units = &verdict.units;
    let number = |value: Option<f64>| value.map_or("-".to_string(), |v| significant(v, 4));
    let mut table = Table::new(format!(
        "{}: rollers at s = {} {}, {} unknowns, {:.0} s, descent {} {}",
        placed.position,
        significant(placed.offset, 4),
        units.length,
        placed.unknowns,
        placed.seconds,
        number(placed.descent),
        units.length,
    ))
    .words("where")
    .figures(["what", "value", "± error", "limit", "of limit", "met"]);
    let mut remarks: Vec<(&str, Vec<&str>)> = Vec::new();
    for check in &placed.checks {
        // The star is for peaks beside loaded edges alone; remarks go by numbers.
        let star = if check.at_edge { "*" } else { "" };
        let remark = check.remark.as_ref().map(|remark| {
            let known = remarks.iter().position(|(known, _)| known == remark);
            let index = known.unwrap_or_else(|| {
                remarks.push((remark, Vec::new()));
                remarks.len() - 1
            });
            remarks[index].1.push(&check.place);
            format!(" [{}]", index + 1)
        });
        let remark = remark.unwrap_or_default();
        table.row([
            (&check.place).into(),
            what(check, verdict).into(),
            format!("{}{star}{remark}", number(check.value)).into(),
            Cell::Figure(Number::new(check.error, MESH_DIGITS)),
            Cell::figure(check.limit),
            Cell::Share(check.utilisation),
            said(check.standing).into(),
        ]);
    }
    let mut text = table_text(&table);
    for ((remark, places), number) in remarks.into_iter().zip(1..) {
        text += &wrapped(&format!("[{number}] {}: {remark}", places.join(", ")), 2);
    }
    if placed.checks.iter().any(|check| check.at_edge) {
        text += "  * beside a loaded edge: a value of this mesh\n";
    }
    text
}

fn conclusion(verdict: &DesignVerdict) -> String {
    let checks = || {
        verdict
            .positions
            .iter()
            .flat_map(|p| p.checks.iter().map(move |c| (p, c)))
    };
    let named = |(placed, check): (&Placed, &LimitCheck)| {
        let share = check
            .utilisation
            .map_or_else(String::new, |u| format!(" at {}", percent(u)));
        format!(
            "{} of {}, {}{share}",
            check.kind.name(),
            check.place,
            placed.position
        )
    };
    let by_share = |a: &(&Placed, &LimitCheck), b: &(&Placed, &LimitCheck)| {
        a.1.utilisation
            .unwrap_or(0.0)
            .total_cmp(&b.1.utilisation.unwrap_or(0.0))
    };
    let missed: Vec<String> = (checks().filter(|(_, c)| c.standing.is_missed()))
        .map(named)
        .collect();
    let count = |standing: Standing| checks().filter(|(_, c)| c.standing == standing).count();
    let unresolved: Vec<String> = (checks().filter(|(_, c)| c.standing == Standing::Unresolved))
        .map(named)
        .collect();
    let mut text = match missed.as_slice() {
        [] if !unresolved.is_empty() => {
            let words = format!(
                "VERDICT: NONE, not resolved by this mesh: {}",
                unresolved.join("; ")
            );
            wrapped(&words, 0)
        }
        [] => {
            let nearest = checks().max_by(by_share).map_or_else(String::new, named);
            format!("VERDICT: no limit is missed; the nearest is that on {nearest} of it\n")
        }
        missed => {
            let words = format!("VERDICT: FAILED, limits missed: {}", missed.join("; "));
            wrapped(&words, 0)
        }
    };
    // Writing to a string cannot fail.
    let remarks = [
        (
            Standing::MetWithinError,
            "met by less than the estimated error",
        ),
        (
            Standing::Open,
            "open: this mesh cannot tell; brinell run with --target mises=3% refines it",
        ),
        (
            Standing::Unresolved,
            "not resolved: the error is not known; brinell run with --target mises=3% refines the mesh",
        ),
        (
            Standing::NotJudged,
            "beside loaded edges, not judged: what is found there belongs to the mesh",
        ),
    ];
    for (standing, words) in remarks {
        let n = count(standing);
        if n > 0 {
            let _ = writeln!(text, "  {n} {words}");
        }
    }
    if let Some(advice) = &verdict.advice {
        text += &wrapped(
            &format!("what would help: {}, which {}", advice.options, advice.why),
            2,
        );
    }
    text
}
