//! What a run did not need to do, in words.

use crate::case::{Case, Kind};
use crate::scene::Scene;
use crate::solve::Solution;

/// One line for each thing left out.
pub fn list(case: &Case, scene: &Scene, solution: &Solution) -> Vec<String> {
    let mut lines = Vec::new();
    if !scene.mirrors.is_empty() {
        let axes: Vec<&str> = scene.mirrors.iter().map(|a| ["x", "y", "z"][*a]).collect();
        let part = ["the whole", "half", "a quarter", "an eighth"][scene.mirrors.len().min(3)];
        let what = match case.kind {
            Kind::Bearing(_) => "bearing",
            Kind::General(_) => "model",
        };
        lines.push(format!(
            "symmetric about {}: {part} of the {what} is solved",
            axes.join(" and ")
        ));
    }
    if !scene.contacts.is_empty() && scene.contacts.iter().all(|c| c.friction == 0.0) {
        lines.push("no friction: no tangential law is evaluated".to_owned());
    }
    let elastic: Vec<&str> = scene
        .mesh
        .bodies
        .iter()
        .zip(&scene.materials)
        .filter(|(_, m)| m.is_elastic() || !scene.controls.plasticity)
        .map(|(b, _)| b.name.as_str())
        .collect();
    if !elastic.is_empty() {
        lines.push(format!(
            "elastic, yield is never checked: {}",
            elastic.join(", ")
        ));
    }
    lines.push(
        "elastic stiffness and contact operator are integrated once and never again".to_owned(),
    );
    let counters = &solution.counters;
    if counters.kept_equations < counters.equations {
        lines.push(format!(
            "bodies are condensed: iterations see {} of {} unknowns",
            counters.kept_equations, counters.equations
        ));
    }
    let carriers: usize = solution.last.contacts.iter().map(|c| c.nodes.len()).sum();
    let rows = counters.contact_rows;
    if carriers > rows {
        lines.push(format!(
            "contact is prepared at {rows} of {carriers} carrier nodes, the others being out of reach"
        ));
    }
    lines
}
