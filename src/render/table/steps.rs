//! All steps side by side, in the table.

use super::{DIGITS, number};
use crate::answer::StepFigures;
use crate::render::summary::Summary;
use crate::render::text::{Columns, significant};

/// The ends of the steps; nothing for a single one.
pub(super) fn steps(summary: &Summary) -> String {
    if summary.answer.steps.len() < 2 {
        return String::new();
    }
    let units = &summary.units;
    let mut table = Columns::new(&[
        "Steps, at their ends",
        &format!("load {}", units.force),
        "x",
        "y",
        "z",
        &format!("descent {}", units.length),
        &format!("Mises {}", units.stress),
        &format!("p max {}", units.stress),
        "plastic strain",
        "stick/slip",
    ]);
    for step in &summary.answer.steps {
        let mut row = vec![step.name.clone(), significant(step.load, DIGITS)];
        row.extend(components(step.force));
        let [stick, slip] = step.stick_and_slip();
        row.extend([
            number(step.descent),
            number(step.mises_max.nodal),
            number(step.max_pressure()),
            significant(step.peeq_max, 3),
            format!("{stick}/{slip}"),
        ]);
        table.row(row);
    }
    let text = table.render().replacen("  Steps", "Steps", 1);
    format!("{text}  All other figures are of {}.\n", moment(summary))
}

/// Components of a force, as zero where they are noise beside the whole.
pub(super) fn components(force: [f64; 3]) -> [String; 3] {
    let size = crate::ground::geometry::norm(force);
    force.map(|f| match f.abs() <= 1e-9 * size {
        true => "0".to_string(),
        false => significant(f, DIGITS),
    })
}

/// The moment that the figures are of, in words.
fn moment(summary: &Summary) -> String {
    let reported = summary.answer.steps.iter().position(|step| step.reported);
    let name = |step: &StepFigures| format!("the end of step \u{201c}{}\u{201d}", step.name);
    match reported {
        Some(index) if summary.answer.unloaded.is_some() => {
            format!(
                "{}, the last before unloading",
                name(&summary.answer.steps[index])
            )
        }
        Some(index) => name(&summary.answer.steps[index]),
        None => format!(
            "step \u{201c}{}\u{201d}, as far as it is done",
            summary.answer.step
        ),
    }
}
