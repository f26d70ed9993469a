//! The handbook's answer as a plain table.

use std::fmt::Write;

use crate::analytic::handbook::{Below, HandbookAnswer, Spread};
use crate::analytic::sizing;
use crate::ground::units::UnitLabels;
use crate::render::sections::rule_table;
use crate::render::summary::RuleSheet;
use crate::render::table::text::text;

/// Rows of label, value and unit under headings.
struct HandbookTable {
    text: String,
}

impl HandbookTable {
    fn heading(&mut self, heading: &str) {
        let gap = if self.text.is_empty() { "" } else { "\n" };
        self.put(format_args!("{gap}{heading}\n"));
    }

    fn row(&mut self, label: &str, value: f64, unit: &str) {
        let line = format!("  {label:<46} {:>12} {unit}", number(value));
        self.put(format_args!("{}\n", line.trim_end()));
    }

    fn words(&mut self, label: &str, words: &str) {
        self.put(format_args!("  {label:<46} {words:>12}\n"));
    }

    fn put(&mut self, line: std::fmt::Arguments) {
        // Writing to a string cannot fail.
        let _ = self.text.write_fmt(line);
    }
}

/// Five significant digits, without an exponent where that reads well.
fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".into();
    }
    if !(1e-5..1e7).contains(&size) {
        return format!("{value:.4e}");
    }
    let decimals = (4 - size.log10().floor() as i32).max(0) as usize;
    format!("{value:.decimals$}")
}

pub(super) fn table(units: &UnitLabels, answer: &HandbookAnswer, rules: &RuleSheet) -> String {
    let [length, force, stress] = [&units.length, &units.force, &units.stress].map(String::as_str);
    let (per_length, area) = (units.line_load(), units.area());
    let mut t = HandbookTable {
        text: String::new(),
    };
    t.heading("Contact (Hertz, line, even load)");
    t.row("load per length p", answer.line_load, &per_length);
    t.row("peak pressure p0", answer.peak_pressure, stress);
    t.row(
        "  by (2-48) as printed",
        answer.peak_pressure_printed,
        stress,
    );
    t.row("mean pressure", answer.mean_pressure, stress);
    t.row("contact width 2a", answer.contact_width, length);
    t.row(
        "  by (2-47) as printed",
        answer.contact_width_printed,
        length,
    );
    for (name, below) in [("roller", &answer.roller), ("plate", &answer.plate)] {
        peak(&mut t, name, below, length, stress);
    }
    t.row(
        "first yield at p0",
        answer.first_yield.peak_pressure,
        stress,
    );
    t.row(
        "first yield at p",
        answer.first_yield.line_load,
        &per_length,
    );
    t.row("first yield at the load", answer.first_yield.load, force);
    sections(&mut t, answer, [length, force, stress], &per_length, &area);
    t.put(format_args!("\n{}", text(&rule_table(rules, units))));
    t.heading("Verdict");
    t.words("half space valid?", yes_no(answer.half_space_valid));
    t.words("elastic, centred?", yes_no(answer.elastic));
    t.words("within (2-49), centred?", yes_no(answer.within_limit));
    if let Some(displaced) = &answer.displaced {
        t.words(
            "elastic, displaced, even load?",
            yes_no(displaced.block.elastic),
        );
        t.words(
            "within (2-49), displaced, even load?",
            yes_no(displaced.block.within_limit),
        );
    }
    for remark in &answer.remarks {
        t.put(format_args!("  note: {remark}\n"));
    }
    t.text
}

fn yes_no(yes: bool) -> &'static str {
    if yes { "yes" } else { "no" }
}

fn peak(t: &mut HandbookTable, body: &str, below: &Below, length: &str, stress: &str) {
    t.row(
        &format!("largest Mises stress, {body}"),
        below.mises,
        stress,
    );
    t.row("  at the depth", below.depth, length);
    t.row("  over yield", below.share_of_yield, "");
    if let Some(mises) = below.mises_in_sliding {
        t.row("  if it slid", mises, stress);
    }
}

fn sections(
    t: &mut HandbookTable,
    answer: &HandbookAnswer,
    [length, force, stress]: [&str; 3],
    per_length: &str,
    area: &str,
) {
    let rules = &answer.rules;
    t.heading("Sizing (reference study)");
    t.row("limit 1.65 yield, (2-49)", rules.pressure_limit, stress);
    t.row("p0 over yield", rules.pressure_over_yield, "");
    t.row("D L", rules.diameter_times_length, area);
    t.row(
        "D L required by (2-50), constant 8",
        rules.required_printed,
        area,
    );
    let exact = format!(
        "D L required by (2-49), constant {:.4}",
        sizing::exact().sizing
    );
    t.row(&exact, rules.required_exact, area);
    t.row("load capacity, constant 8", rules.capacity_printed, force);
    t.row("load capacity, exact constant", rules.capacity_exact, force);
    if let Some(bore) = &answer.bore {
        t.heading("Hollow roller (exact ring, plane strain)");
        t.row(
            "hoop stress at the bore under the load",
            bore.hoop_under_load,
            stress,
        );
        t.row("  its Mises stress", bore.mises_under_load, stress);
        t.row("  by the curved beam", bore.curved_beam_hoop, stress);
        t.row(
            "  error of the curved beam",
            100.0 * bore.curved_beam_error,
            "%",
        );
        t.row("hoop stress at the bore at 90°", bore.hoop_at_side, stress);
        if let Some(change) = bore.outer_diameter_change {
            t.row("change of the outer diameter", change, length);
        }
        t.row(
            "change of the inner diameter",
            bore.inner_diameter_change,
            length,
        );
    }
    if let Some(groove) = &answer.groove {
        t.heading("V groove (two lines)");
        t.row("force across each line", groove.normal_load, per_length);
        if let Some([low, high]) = groove.normal_load_bounds {
            t.row("  at least, with friction", low, per_length);
            t.row("  at most, with friction", high, per_length);
        }
        t.row("lines beside the root by", groove.offset, length);
        t.row("gap over the root", groove.gap_at_root, length);
        t.row("peak pressure of each", groove.peak_pressure, stress);
        if let Some(pressure) = groove.peak_pressure_with_interaction {
            t.row("  with the other's effect", pressure, stress);
        }
        t.row("contact width of each", groove.contact_width, length);
        t.row("largest Mises stress", groove.mises, stress);
    }
    if let Some(displaced) = &answer.displaced {
        t.heading("Displaced roller");
        spread(
            t,
            "even over the effective length",
            &displaced.block,
            per_length,
            [length, stress],
        );
        spread(
            t,
            "linear, no tension",
            &displaced.linear,
            per_length,
            [length, stress],
        );
        if let Some([normal, push]) = displaced.on_slope {
            t.row("force across the one line on the slope", normal, per_length);
            t.row("horizontal force to be reacted", push, force);
        }
    }
}

fn spread(
    t: &mut HandbookTable,
    name: &str,
    spread: &Spread,
    per_length: &str,
    [length, stress]: [&str; 2],
) {
    t.row(&format!("p, {name}"), spread.line_load, per_length);
    t.row("  over a length of", spread.bearing_length, length);
    t.row("  peak pressure", spread.peak_pressure, stress);
    t.row("  largest Mises stress (elastic)", spread.mises, stress);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_five_digits() {
        for (value, text) in [
            (0.0, "0"),
            (167.17311, "167.17"),
            (0.0037, "0.0037000"),
            (2e11, "2.0000e11"),
            (-24.6, "-24.600"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
