//! What is read from every level.

use super::ConvergeError;
use crate::answer::Three;
use crate::case::Case;
use crate::product::job::Outcome;
use crate::proof::verify::{energy, problem_h};
use serde::Serialize;

/// A value from elsewhere.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Known {
    pub value: f64,
    /// How far it may be off, relative to itself: smaller errors mean nothing. Zero where exact.
    pub within: f64,
    pub origin: &'static str,
}

/// One scalar of one level.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    pub name: String,
    pub unit: String,
    pub value: f64,
    pub known: Option<Known>,
    /// Is it a peak beside a loaded edge, where elastic stress has no limit?
    pub at_singular_edge: bool,
}

/// The case that is built in: problem H, to be had without a file under this name.
pub const PROBLEM_H: &str = "problem-h";
const PROBLEM_H_CASE: &str = include_str!("../../../cases/problem-h.toml");

/// The built-in problem H.
///
/// # Errors
/// Never, as long as the shipped case is sound.
pub fn problem_h() -> Result<Case, ConvergeError> {
    Ok(crate::case::parse(PROBLEM_H, PROBLEM_H_CASE)?)
}

/// Is `case` problem H as it is shipped, so that its limits are known?
pub fn is_problem_h(case: &Case) -> bool {
    case.source.text() == PROBLEM_H_CASE
}

/// The quantities of a solved level.
///
/// # Errors
/// Where problem H has no contact to read.
pub fn read(case: &Case, outcome: &Outcome) -> Result<Vec<Quantity>, ConvergeError> {
    match is_problem_h(case) {
        true => of_problem_h(outcome),
        false => Ok(of_summary(case, outcome)),
    }
}

fn of_problem_h(outcome: &Outcome) -> Result<Vec<Quantity>, ConvergeError> {
    use problem_h::{HALF_WIDTH, MISES_BLOCK, MISES_CYLINDER, PRESSURE};
    const HERTZ: &str = "Hertz's line contact (Johnson, Contact Mechanics, 4.43 and 4.45)";
    const SERIES: &str = "a series of meshes with an independent solver of the finite bodies";
    const NORM: &str = "distance from Hertz's half ellipse in L2, over the norm of the ellipse";
    // From the series of the independent solver: its meshes, and its two ways to take the gap.
    let (contact, stress) = (0.0015, 0.002);
    let reading = problem_h::read(&outcome.scene, outcome.state())?;
    let quantity = |name: &str, unit: &str, value: f64, known: Option<(f64, f64, &'static str)>| {
        let known = known.map(|(value, within, origin)| Known {
            value,
            within,
            origin,
        });
        Quantity {
            name: name.into(),
            unit: unit.into(),
            value,
            known,
            at_singular_edge: false,
        }
    };
    let mut list = vec![
        quantity(
            "p0",
            "ksi",
            reading.pressure,
            Some((PRESSURE, contact, HERTZ)),
        ),
        quantity(
            "half-width",
            "in",
            reading.half_width,
            Some((HALF_WIDTH, contact, HERTZ)),
        ),
        quantity("pressure L2", "", reading.profile, Some((0.0, 0.0, NORM))),
        quantity("potential energy", "kip", reading.energy, None),
    ];
    let bodies = [
        ("block", reading.block, MISES_BLOCK),
        ("cylinder", reading.cylinder, MISES_CYLINDER),
    ];
    for (body, mises, limit) in bodies {
        let readings = [
            ("centroid", mises.centroid),
            ("nodal", mises.nodal),
            ("integration point", mises.integration_point),
        ];
        for (place, value) in readings {
            let name = format!("Mises {body}, {place}");
            list.push(quantity(&name, "ksi", value, Some((limit, stress, SERIES))));
        }
    }
    Ok(list)
}

/// The scalars that `summary.json` also has, and the strain energy where nothing has yielded.
fn of_summary(case: &Case, outcome: &Outcome) -> Vec<Quantity> {
    let summary = &outcome.summary;
    let (length, force, stress) = (case.units.length(), case.units.force(), case.units.stress());
    let mut list = Vec::new();
    let mut add = |name: String, unit: &str, value: Option<f64>, at_singular_edge: bool| {
        // A level without this value leaves it out; the study puts "not a number" in its place.
        if let Some(value) = value {
            list.push(Quantity {
                name,
                unit: unit.to_owned(),
                value,
                known: None,
                at_singular_edge,
            });
        }
    };
    add("descent".into(), length, summary.answer.descent, false);
    let yielded = outcome.state().peeq.iter().flatten().any(|p| *p > 0.0);
    let energy = energy::strain_energy(&outcome.scene, outcome.state());
    add(
        "strain energy".into(),
        &format!("{force} {length}"),
        (!yielded).then_some(energy),
        false,
    );
    for (name, interface) in &summary.answer.interfaces.0 {
        let pressure = Some(interface.max_pressure);
        add(format!("peak pressure {name}"), stress, pressure, false);
    }
    for (name, body) in &summary.answer.bodies.0 {
        let edges = places(&body.at_singular_edge);
        for ((place, value), (_, edge)) in places(&body.mises_max).into_iter().zip(edges) {
            add(format!("Mises {name}, {place}"), stress, value, edge);
        }
        if yielded {
            let strain = Some(body.peeq_max);
            add(format!("plastic strain {name}"), "", strain, false);
        }
    }
    for (name, roller) in &summary.answer.rollers.0 {
        let mises = roller.bore_mises;
        add(format!("bore Mises {name}"), stress, mises, false);
    }
    list
}

fn places<T: Copy>(three: &Three<T>) -> [(&'static str, T); 3] {
    [
        ("centroid", three.centroid),
        ("nodal", three.nodal),
        ("integration point", three.integration_point),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_case_is_the_shipped_one() {
        let case = problem_h().unwrap();
        assert!(is_problem_h(&case));
        let other = crate::case::parse("other", &PROBLEM_H_CASE.replace("1.5 in", "2 in"));
        assert!(!is_problem_h(&other.unwrap()));
    }
}
