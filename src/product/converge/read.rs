//! The quantities of a solved level.

use super::error::Missing;
use super::quantity::StudyQuantity;
use super::{energy, problem_h};
use crate::answer::Three;
use crate::case::Case;
use crate::product::job::Outcome;

/// The quantities of a solved level.
///
/// # Errors
/// [`Missing`] where problem H has no contact to read.
pub fn read(case: &Case, outcome: &Outcome) -> Result<Vec<StudyQuantity>, Missing> {
    if problem_h::is_problem_h(case) {
        let reading = problem_h::read(&outcome.scene, outcome.state())?;
        Ok(problem_h::quantities(&reading))
    } else {
        Ok(of_summary(case, outcome))
    }
}

/// The scalars that `summary.json` also has, and the strain energy where nothing has yielded.
fn of_summary(case: &Case, outcome: &Outcome) -> Vec<StudyQuantity> {
    let summary = &outcome.summary;
    let (length, force, stress) = (case.units.length(), case.units.force(), case.units.stress());
    let mut list = Vec::new();
    let mut add = |name: String, unit: &str, value: Option<f64>, at_singular_edge: bool| {
        // A level without this value leaves it out; the study puts "not a number" in its place.
        if let Some(value) = value {
            list.push(StudyQuantity {
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
