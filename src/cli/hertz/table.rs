//! The handbook's answer as a plain table.

use std::fmt::Write;

use crate::analytic::handbook::{Below, HandbookAnswer, Spread};
use crate::analytic::sizing;
use crate::ground::units::UnitLabels;
use crate::render::sections::rule_table;
use crate::render::summary::RuleSheet;
use crate::render::table::text::text;

/// Rows of label, value and unit under headings.
struct HandbookTable<'u> {
    text: String,
    units: &'u UnitLabels,
}

impl HandbookTable<'_> {
    fn heading(&mut self, heading: &str) {
        let gap = if self.text.is_empty() { "" } else { "\n" };
        self.put(format_args!("{gap}{heading}\n"));
    }

    fn row(&mut self, label: &str, value: f64, unit: &str) {
        let line = format!("  {label:<46} {:>12} {unit}", number(value));
        self.put(format_args!("{}\n", line.trim_end()));
    }

    fn length(&mut self, label: &str, value: f64) {
        self.row(label, value, &self.units.length);
    }

    fn area(&mut self, label: &str, value: f64) {
        self.row(label, value, &self.units.area());
    }

    fn force(&mut self, label: &str, value: f64) {
        self.row(label, value, &self.units.force);
    }

    fn stress(&mut self, label: &str, value: f64) {
        self.row(label, value, &self.units.stress);
    }

    fn line_load(&mut self, label: &str, value: f64) {
        self.row(label, value, &self.units.line_load());
    }

    fn share(&mut self, label: &str, value: f64) {
        self.row(label, value, "");
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
    let mut t = HandbookTable {
        text: String::new(),
        units,
    };
    t.heading("Contact (Hertz, line, even load)");
    t.line_load("load per length p", answer.line_load);
    t.stress("peak pressure p0", answer.peak_pressure);
    t.stress("  by (2-48) as printed", answer.peak_pressure_printed);
    t.stress("mean pressure", answer.mean_pressure);
    t.length("contact width 2a", answer.contact_width);
    t.length("  by (2-47) as printed", answer.contact_width_printed);
    for (name, below) in [("roller", &answer.roller), ("plate", &answer.plate)] {
        peak(&mut t, name, below);
    }
    t.stress("first yield at p0", answer.first_yield.peak_pressure);
    t.line_load("first yield at p", answer.first_yield.line_load);
    t.force("first yield at the load", answer.first_yield.load);
    sections(&mut t, answer);
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

fn peak(t: &mut HandbookTable, body: &str, below: &Below) {
    t.stress(&format!("largest Mises stress, {body}"), below.mises);
    t.length("  at the depth", below.depth);
    t.share("  over yield", below.share_of_yield);
    if let Some(mises) = below.mises_in_sliding {
        t.stress("  if it slid", mises);
    }
}

fn sections(t: &mut HandbookTable, answer: &HandbookAnswer) {
    let rules = &answer.rules;
    t.heading("Sizing (reference study)");
    t.stress("limit 1.65 yield, (2-49)", rules.pressure_limit);
    t.share("p0 over yield", rules.pressure_over_yield);
    t.area("D L", rules.diameter_times_length);
    t.area("D L required by (2-50), constant 8", rules.required_printed);
    let exact = format!(
        "D L required by (2-49), constant {:.4}",
        sizing::exact().sizing
    );
    t.area(&exact, rules.required_exact);
    t.force("load capacity, constant 8", rules.capacity_printed);
    t.force("load capacity, exact constant", rules.capacity_exact);
    if let Some(bore) = &answer.bore {
        t.heading("Hollow roller (exact ring, plane strain)");
        t.stress(
            "hoop stress at the bore under the load",
            bore.hoop_under_load,
        );
        t.stress("  its Mises stress", bore.mises_under_load);
        t.stress("  by the curved beam", bore.curved_beam_hoop);
        t.row(
            "  error of the curved beam",
            100.0 * bore.curved_beam_error,
            "%",
        );
        t.stress("hoop stress at the bore at 90°", bore.hoop_at_side);
        if let Some(change) = bore.outer_diameter_change {
            t.length("change of the outer diameter", change);
        }
        t.length("change of the inner diameter", bore.inner_diameter_change);
    }
    if let Some(groove) = &answer.groove {
        t.heading("V groove (two lines)");
        t.line_load("force across each line", groove.normal_load);
        if let Some([low, high]) = groove.normal_load_bounds {
            t.line_load("  at least, with friction", low);
            t.line_load("  at most, with friction", high);
        }
        t.length("lines beside the root by", groove.offset);
        t.length("gap over the root", groove.gap_at_root);
        t.stress("peak pressure of each", groove.peak_pressure);
        if let Some(pressure) = groove.peak_pressure_with_interaction {
            t.stress("  with the other's effect", pressure);
        }
        t.length("contact width of each", groove.contact_width);
        t.stress("largest Mises stress", groove.mises);
    }
    if let Some(displaced) = &answer.displaced {
        t.heading("Displaced roller");
        spread(t, "even over the effective length", &displaced.block);
        spread(t, "linear, no tension", &displaced.linear);
        if let Some([normal, push]) = displaced.on_slope {
            t.line_load("across the one line on the slope, without friction", normal);
            t.force("  horizontal force to be reacted", push);
        }
        if let Some(push) = displaced.rolling_push {
            t.force("horizontal force as it rolls, by friction", push);
        }
    }
}

fn spread(t: &mut HandbookTable, name: &str, spread: &Spread) {
    t.line_load(&format!("p, {name}"), spread.line_load);
    t.length("  over a length of", spread.bearing_length);
    t.stress("  peak pressure", spread.peak_pressure);
    t.stress("  largest Mises stress (elastic)", spread.mises);
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
