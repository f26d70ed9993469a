//! The figures of a run that go into the table, by name.

use crate::answer::certify::Quantity;
use crate::answer::{BodyFigures, InterfaceFigures};
use crate::render::Summary;
use crate::render::joint::governing;
use serde_json::Value;

/// Figures under their names, in the order of the columns.
#[derive(Debug, Default)]
struct RowFigures(Vec<(String, Value)>);

impl RowFigures {
    fn add(&mut self, name: impl Into<String>, value: impl Into<Value>) {
        self.0.push((name.into(), value.into()));
    }
}

/// What the table says of a run, in the units of its case.
///
/// Mises peaks without an estimated error lie at a loaded edge, where they belong to the mesh. Where
/// nothing has yielded, the elastic peak is the peak.
pub fn figures(summary: &Summary) -> Vec<(String, Value)> {
    let mut out = RowFigures::default();
    let units = &summary.units;
    out.add(
        "units",
        format!("{}-{}-{}", units.length, units.force, units.stress),
    );
    out.add("dofs", summary.counters.dofs);
    out.add("iterations", summary.counters.iterations);
    out.add("memory_bytes", summary.peak_memory_bytes);
    out.add("applied_load", summary.answer.applied_load);
    out.add("descent", summary.answer.descent);
    out.add(
        "descent_error",
        error(summary, Quantity::Descent, "overall"),
    );
    overall(summary, &mut out);
    // Also where a figure away from edges stands beside it: the table has both.
    let claims = summary.answer.certificate.iter();
    let names: Vec<String> = claims
        .filter(|claim| !claim.is_resolved())
        .map(|claim| format!("{} of {}", claim.what.name(), claim.place))
        .collect();
    out.add("unresolved", names.join("; "));
    for (name, body) in &summary.answer.bodies.0 {
        add_body(summary, name, body, &mut out);
    }
    for (name, interface) in &summary.answer.interfaces.0 {
        add_interface(summary, name, interface, &mut out);
    }
    for (name, roller) in &summary.answer.rollers.0 {
        out.add(format!("{name}.bore_mises"), roller.bore_mises);
        let bar = error(summary, Quantity::BoreMises, name);
        out.add(format!("{name}.bore_mises_error"), bar);
        out.add(format!("{name}.bore_mises_nodal"), roller.bore_mises_nodal);
    }
    out.0
}

/// The largest of all bodies and lines.
fn overall(summary: &Summary, out: &mut RowFigures) {
    let bodies = &summary.answer.bodies.0;
    let centroid = bodies.iter().filter_map(|(_, b)| b.mises_max.centroid);
    out.add("mises_centroid", centroid.reduce(f64::max));
    let nodal = bodies
        .iter()
        .filter_map(|(n, b)| Some((n, b.mises_max.nodal?)));
    add_largest(
        "mises_nodal",
        nodal,
        |n| error(summary, Quantity::PeakMises, n),
        out,
    );
    // A body that has not yielded beside one that has stays below the yield stress in both.
    let elastic = bodies.iter().filter_map(|(n, b)| Some((n, elastic(b)?)));
    let of = |n: &str| elastic_error(summary, n);
    add_largest("elastic_mises_nodal", elastic, of, out);
    let most = governing(summary);
    out.add("utilisation", most.as_ref().map(|most| most.utilisation));
    out.add(
        "utilisation_error",
        most.as_ref().and_then(|most| most.error),
    );
    out.add("utilisation_at", most.map(|most| most.what));
}

/// The largest value with its error and where it is.
fn add_largest<'s>(
    name: &str,
    values: impl Iterator<Item = (&'s String, f64)>,
    error: impl Fn(&str) -> Option<f64>,
    out: &mut RowFigures,
) {
    let largest = values.reduce(|a, b| if b.1 > a.1 { b } else { a });
    out.add(name, largest.map(|(_, value)| value));
    out.add(
        format!("{name}_error"),
        largest.and_then(|(at, _)| error(at)),
    );
    out.add(format!("{name}_at"), largest.map(|(at, _)| at.as_str()));
}

fn add_body(summary: &Summary, name: &str, body: &BodyFigures, out: &mut RowFigures) {
    let mut add = |figure: &str, value: Option<f64>| out.add(format!("{name}.{figure}"), value);
    add("mises_centroid", body.mises_max.centroid);
    add("mises_nodal", body.mises_max.nodal);
    add(
        "mises_nodal_error",
        error(summary, Quantity::PeakMises, name),
    );
    add("mises_away", value(summary, Quantity::MisesAway, name));
    add(
        "mises_away_error",
        error(summary, Quantity::MisesAway, name),
    );
    let known = body.elastic_mises_max.is_some() || nothing_yielded(summary);
    add("elastic_mises_nodal", elastic(body).filter(|_| known));
    add(
        "elastic_mises_nodal_error",
        elastic_error(summary, name).filter(|_| known),
    );
    add("peeq_max", Some(body.peeq_max));
}

fn add_interface(summary: &Summary, name: &str, contact: &InterfaceFigures, out: &mut RowFigures) {
    let mut add = |figure: &str, value: Option<f64>| out.add(format!("{name}.{figure}"), value);
    add("p_max", Some(contact.max_pressure));
    add("p_max_error", error(summary, Quantity::PeakPressure, name));
    add("p_max_away", value(summary, Quantity::PressureAway, name));
    add(
        "p_max_away_error",
        error(summary, Quantity::PressureAway, name),
    );
    add("p0", contact.hertz_p0);
    add("p0_error", error(summary, Quantity::HertzPressure, name));
    let loads = contact.lines.iter().map(|line| line.peak);
    add("largest_line_load", loads.reduce(f64::max));
    add(
        "largest_line_load_error",
        error(summary, Quantity::LineLoad, name),
    );
    let lines = summary.sizing.iter().flat_map(|s| &s.lines);
    let own = lines.filter(|line| line.interface == name);
    add(
        "utilisation",
        own.filter_map(|l| l.utilisation).reduce(f64::max),
    );
}

fn nothing_yielded(summary: &Summary) -> bool {
    summary
        .answer
        .bodies
        .0
        .iter()
        .all(|(_, body)| body.peeq_max == 0.0)
}

fn elastic(body: &BodyFigures) -> Option<f64> {
    match &body.elastic_mises_max {
        Some(elastic) => elastic.nodal,
        None => body.mises_max.nodal.filter(|_| body.peeq_max == 0.0),
    }
}

fn elastic_error(summary: &Summary, body: &str) -> Option<f64> {
    let yielded = summary
        .answer
        .bodies
        .get(body)
        .is_some_and(|b| b.elastic_mises_max.is_some());
    let what = if yielded {
        Quantity::ElasticPeakMises
    } else {
        Quantity::PeakMises
    };
    error(summary, what, body)
}

/// The value of a claim of the certificate.
fn value(summary: &Summary, what: Quantity, place: &str) -> Option<f64> {
    Some(summary.answer.figure(what, place)?.value)
}

/// The estimated error of a claim of the certificate.
fn error(summary: &Summary, what: Quantity, place: &str) -> Option<f64> {
    summary.answer.figure(what, place)?.bar()
}
