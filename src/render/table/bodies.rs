//! Bodies and bores of rollers in the table.

use super::{DIGITS, SINGULAR_DIGITS, number};
use crate::answer::{BodyFigures, Three};
use crate::render::summary::Summary;
use crate::render::text::{Columns, percent, place, significant};

pub(super) fn bodies(summary: &Summary) -> String {
    let mut table = Columns::new(&[
        "body",
        "centroid",
        "integration pt",
        "nodal",
        "plastic strain",
        &format!("yielded {}", summary.units.volume()),
        "of body",
    ]);
    let mut places = Columns::new(&["where", "centroid", "integration pt", "nodal"]);
    let mut singular = false;
    for (name, body) in &summary.answer.bodies.0 {
        singular |= body.at_singular_edge.each().contains(&true);
        let mut row = vec![name.clone()];
        row.extend(peaks(&body.mises_max, &body.at_singular_edge));
        row.push(significant(body.peeq_max, 3));
        row.push(significant(body.yielded_volume, 3));
        row.push(percent(body.yielded_volume / body.volume));
        table.row(row);
        if let Some(elastic) = elastic_row(body) {
            table.row(elastic);
        }
        let at = body
            .at
            .each()
            .map(|at| at.map_or_else(|| "-".to_string(), place));
        places.row(std::iter::once(name.clone()).chain(at));
    }
    if table.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "Largest Mises stress, {}\n{}",
        summary.units.stress,
        table.render()
    );
    if singular {
        text.push_str("  * beside a loaded edge: a value of this mesh, see the warnings\n");
    }
    format!(
        "{text}\nPeaks at, {}\n{}",
        summary.units.length,
        places.render()
    )
}

fn peaks(values: &Three<Option<f64>>, singular: &Three<bool>) -> Vec<String> {
    let digits = |singular| if singular { SINGULAR_DIGITS } else { DIGITS };
    let print = |(value, singular): (Option<f64>, bool)| match value {
        Some(value) => {
            format!(
                "{}{}",
                significant(value, digits(singular)),
                if singular { "*" } else { "" }
            )
        }
        None => "-".to_string(),
    };
    values
        .each()
        .into_iter()
        .zip(singular.each())
        .map(print)
        .collect()
}

fn elastic_row(body: &BodyFigures) -> Option<Vec<String>> {
    let elastic = body.elastic_mises_max?;
    let mut row = vec!["  elastic".to_string()];
    row.extend(peaks(&elastic, &body.at_singular_edge));
    Some(row)
}

pub(super) fn rollers(summary: &Summary) -> String {
    let mut table = Columns::new(&["roller", "from strain", "at", "nodal", "at"]);
    let at = |at: Option<[f64; 3]>| at.map_or_else(|| "-".to_string(), place);
    for (name, roller) in &summary.answer.rollers.0 {
        table.row([
            name.clone(),
            number(roller.bore_mises),
            at(roller.bore_mises_at),
            number(roller.bore_mises_nodal),
            at(roller.bore_mises_nodal_at),
        ]);
    }
    if table.is_empty() {
        return String::new();
    }
    format!(
        "Mises stress at the bore, {}\n{}",
        summary.units.stress,
        table.render()
    )
}
