//! A study as text.

use super::study::{Curve, Study, StudyLevel};
use crate::render::table::text::text;
use crate::render::table::{Cell, Number, Table};
use crate::render::text::significant;

/// The head of the lines that `line` makes.
pub fn head() -> String {
    format!(
        "{:>5} {:9} {:>9} {:>9} {:>10} {:>8} {:>10} {:>9}",
        "level", "element", "elements", "unknowns", "iterations", "wall s", "CPU s", "memory MB"
    )
}

/// A level as it finishes.
pub fn line(level: &StudyLevel) -> String {
    format!(
        "{:5} {:9} {:9} {:9} {:10} {:8.2} {:10.2} {:>9}",
        level.level,
        level.element,
        level.elements,
        level.dofs,
        level.iterations,
        level.cost.wall_s,
        level.cost.cpu_s,
        memory(level)
    )
}

/// Peak memory in units of 10⁶ bytes; at most that where it is that of the process since it began.
pub fn memory(level: &StudyLevel) -> String {
    let most = if level.cost.peak_is_own { "" } else { "≤ " };
    level.cost.peak_memory_bytes.map_or_else(
        || "-".to_owned(),
        |bytes| format!("{most}{:.0}", 1e-6 * bytes as f64),
    )
}

/// A relative error in percent with its sign.
pub fn signed_percent(error: Option<f64>) -> String {
    error.map_or_else(
        || "-".to_owned(),
        |e| {
            let sign = if e > 0.0 { "+" } else { "" };
            format!("{sign}{} %", significant(100.0 * e, 3))
        },
    )
}

/// An order with two decimals.
pub fn order(order: Option<f64>) -> String {
    order.map_or_else(|| "-".to_owned(), |p| format!("{p:.2}"))
}

/// All quantities: values, errors and orders by level.
pub fn render(study: &Study) -> String {
    let mut text = format!("\n{}\n{}\n", study.case, study.series);
    for curve in study.curves() {
        text.push('\n');
        text.push_str(&one(&curve, study));
    }
    text.push_str(
        "\nerror: from the reference, relative to it; order: p in error ~ size^p, from the errors \
         where the\nreference is exact, else from the differences of three levels; - where there \
         is none\n",
    );
    if study.levels.iter().any(|l| !l.cost.peak_is_own) {
        text.push_str("≤: memory of the process since it began, not of the level alone\n");
    }
    text
}

fn one(curve: &Curve, study: &Study) -> String {
    let unit = match curve.unit.as_str() {
        "" => String::new(),
        unit => format!(", {unit}"),
    };
    let (quantity, element) = (&curve.quantity, curve.element);
    let title = format!("{quantity}{unit}, {element}: {}", reference(curve));
    let columns = ["level", "unknowns", "size", "value", "error", "order"];
    let mut table = Table::new(title).figures(columns);
    for (i, level) in study.levels_of(curve.element).into_iter().enumerate() {
        table.row([
            level.level.into(),
            level.dofs.into(),
            Cell::rough(level.size),
            Cell::Figure(Number::new(curve.values[i], 6)),
            signed_percent(curve.errors[i]).into(),
            order(curve.orders[i]).into(),
        ]);
    }
    if curve.at_singular_edge {
        table.note("beside a singular edge, where elastic stress has no limit");
    }
    text(&table)
}

/// What the errors of a curve are measured from, and what the finest levels tend to.
pub fn reference(curve: &Curve) -> String {
    use super::study::Reference;
    let from = match &curve.reference {
        None => "no reference".to_owned(),
        Some(Reference::Known { value, .. }) if *value == 0.0 => "exact 0".to_owned(),
        Some(Reference::Known { value, within, .. }) => {
            let value = significant(*value, 6);
            match *within {
                0.0 => format!("exact {value}"),
                within => format!(
                    "reference {value}, known to {} %",
                    significant(100.0 * within, 2)
                ),
            }
        }
        Some(Reference::Extrapolated { value, .. }) => {
            return format!(
                "extrapolated {} (order {})",
                significant(*value, 6),
                order(curve.order)
            );
        }
        Some(Reference::Finest { value }) => {
            return format!("reference: the finest mesh, {}", significant(*value, 6));
        }
    };
    match curve.extrapolated {
        Some([limit, p]) => format!(
            "{from}; the levels tend to {} (order {p:.2})",
            significant(limit, 6)
        ),
        None => from,
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::study;
    use super::*;

    #[test]
    fn every_reference_is_named() {
        let text = render(&study());
        for words in [
            "energy, ksi, bbar: extrapolated 2.00000 (order 2.00)",
            "pressure, ksi, bbar: reference: the finest mesh, 4.00000",
            "stress, ksi, bbar: exact 10.0000",
            "+3.12 %",
        ] {
            assert!(text.contains(words), "{words} in\n{text}");
        }
    }

    #[test]
    fn a_level_is_a_line_below_its_head() {
        let study = study();
        assert_eq!(
            head().chars().count(),
            line(&study.levels[0]).chars().count()
        );
    }
}
