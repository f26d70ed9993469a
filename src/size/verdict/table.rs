//! The verdict as text.

use super::{Check, Kind, Placed, Standing, Verdict};
use crate::output::text::{Columns, percent, significant};
use std::fmt::Write;

/// Everything, every line ended.
pub fn render(verdict: &Verdict) -> String {
    let mut text = String::new();
    for placed in &verdict.positions {
        text += &position(verdict, placed);
        text.push('\n');
    }
    text + &conclusion(verdict)
}

/// The same as a Markdown file.
pub fn page(verdict: &Verdict) -> String {
    let units = &verdict.units;
    let design = &verdict.design;
    let n = |value: f64| significant(value, 4);
    format!(
        "# Verdict: {}\n\n\
         Load {} {}, steel of {} {}, displacement {} {}; rollers {} x {} {}, wall {}, plates {}; mesh `{}`, \
         Brinell {}.\n\n```text\n{}```\n",
        if verdict.met { "met" } else { "MISSED" },
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
        Standing::NotJudged => "not judged",
    }
}

fn what(check: &Check, verdict: &Verdict) -> String {
    let units = &verdict.units;
    match (check.kind, check.line_load) {
        (Kind::ContactPressure, Some(q)) => {
            format!(
                "p0 at {} {}, {}",
                significant(q, 4),
                units.line_load(),
                units.stress
            )
        }
        (Kind::ContactPressure, None) => format!("p0, {}", units.stress),
        (Kind::ElasticMises, _) => format!("Mises, elastic, {}", units.stress),
        (Kind::PlasticStrain, _) => "plastic strain".to_string(),
        (Kind::EdgePlasticStrain, _) => "plastic strain at edges".to_string(),
        (Kind::Solution, _) => "solution".to_string(),
    }
}

fn position(verdict: &Verdict, placed: &Placed) -> String {
    let units = &verdict.units;
    let dash = || "-".to_string();
    let mut table = Columns::new(&[
        "where", "what", "value", "± error", "limit", "of limit", "met",
    ]);
    let mut remarks: Vec<(&str, Vec<&str>)> = Vec::new();
    for check in &placed.checks {
        let mut star = "";
        if let Some(remark) = &check.remark {
            star = "*";
            match remarks.iter_mut().find(|(known, _)| known == remark) {
                Some((_, places)) => places.push(&check.place),
                None => remarks.push((remark, vec![&check.place])),
            }
        }
        let number =
            |value: Option<f64>, digits| value.map_or_else(dash, |v| significant(v, digits));
        table.row([
            check.place.clone(),
            what(check, verdict),
            format!("{}{star}", number(check.value, 4)),
            number(check.error, 2),
            number(check.limit, 4),
            check.utilisation.map_or_else(dash, percent),
            said(check.standing).to_string(),
        ]);
    }
    let mut text = format!(
        "{}: rollers at s = {} {}, {} unknowns, {:.0} s, descent {} {}\n{}",
        placed.position,
        significant(placed.offset, 4),
        units.length,
        placed.unknowns,
        placed.seconds,
        placed.descent.map_or_else(dash, |d| significant(d, 4)),
        units.length,
        table.render()
    );
    for (remark, places) in remarks {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  * {}: {remark}", places.join(", "));
    }
    text
}

fn conclusion(verdict: &Verdict) -> String {
    let checks = || {
        verdict
            .positions
            .iter()
            .flat_map(|p| p.checks.iter().map(move |c| (p, c)))
    };
    let worst = checks()
        .filter_map(|(p, c)| Some((c.utilisation?, p, c)))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let worst = worst.map_or_else(String::new, |(share, placed, check)| {
        format!(
            "{} of its limit: {}, {}, {}",
            percent(share),
            check.place,
            what(check, verdict),
            placed.position
        )
    });
    let count = checks().filter(|(_, c)| c.standing.is_missed()).count();
    let close = checks()
        .filter(|(_, c)| c.standing == Standing::MetWithinError)
        .count();
    let edges = checks()
        .filter(|(_, c)| c.standing == Standing::NotJudged)
        .count();
    let mut text = match count {
        0 => format!("VERDICT: all limits are met; the nearest to it is at {worst}\n"),
        1 => format!("VERDICT: FAILED, one limit is missed; the worst is at {worst}\n"),
        n => format!("VERDICT: FAILED, {n} limits are missed; the worst is at {worst}\n"),
    };
    // Writing to a string cannot fail.
    if close > 0 {
        let _ = writeln!(
            text,
            "  {close} met by less than the estimated error: a finer mesh would tell"
        );
    }
    if edges > 0 {
        let _ = writeln!(
            text,
            "  {edges} beside loaded edges not judged: what is found there belongs to the mesh"
        );
    }
    if let Some(advice) = &verdict.advice {
        let _ = writeln!(
            text,
            "  what would help: {}, which {}",
            advice.options, advice.why
        );
    }
    text
}
