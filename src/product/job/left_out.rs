//! What a run did not need to do: drawn from the scene, and from what the solver counted.

use super::options::Options;
use crate::case::{Case, Kind};
use crate::ground::geometry::AXES;
use crate::model::material::j2::PlasticPoint;
use crate::model::scene::Scene;
use crate::render::left_out::LeftOut;
use crate::solver::solve::{Counters, Forecast, Solution};

/// One entry for each thing left out.
pub fn list(case: &Case, scene: &Scene, solution: &Solution, options: &Options) -> Vec<LeftOut> {
    let counters = &solution.counters;
    let single = [
        symmetry(scene, counters, whole(case)),
        half_turn(scene, counters, solution.half_turn),
        yield_checks(scene, solution),
        path(scene),
        condensation(counters),
        integration(scene, solution),
        rows(solution),
    ];
    let mut list: Vec<LeftOut> = elastic(scene, counters);
    list.extend(frictionless(scene, counters));
    list.extend(single.into_iter().flatten());
    list.extend(outputs(scene, solution, options));
    list
}

/// What is known of it before anything is solved.
pub fn beforehand(case: &Case, scene: &Scene, forecast: &Forecast) -> Vec<String> {
    let counters = Counters {
        equations: forecast.unknowns,
        ..Counters::default()
    };
    let mut list = elastic(scene, &counters);
    list.extend(frictionless(scene, &counters));
    list.extend(symmetry(scene, &counters, whole(case)));
    list.extend(half_turn(scene, &counters, forecast.half_turn));
    list.extend(path(scene));
    list.into_iter().map(|item| item.what).collect()
}

/// What the model is a part of.
fn whole(case: &Case) -> &'static str {
    match case.kind {
        Kind::Bearing(_) => "bearing",
        Kind::General(_) => "model",
    }
}

/// Mirror planes.
fn symmetry(scene: &Scene, counters: &Counters, whole: &str) -> Option<LeftOut> {
    let mirrors = &scene.mirrors;
    if mirrors.is_empty() {
        return None;
    }
    let axes: Vec<&str> = mirrors.iter().map(|a| AXES[*a % 3]).collect();
    let part = ["whole", "half", "quarter", "eighth"][mirrors.len().min(3)];
    let copies = 1usize << mirrors.len();
    let images = |node: &[f64; 3]| copies >> scene.mirrors_through(node).count();
    let points = &scene.mesh.points;
    let nodes = points.iter().map(images).sum::<usize>() - points.len();
    let unknowns = counters.equations * nodes / points.len().max(1);
    let what = format!("symmetric about {}: {part} {whole}", axes.join(" and "));
    Some(
        LeftOut::new(what)
            .saving((copies - 1) * scene.mesh.hexes.len(), "elements")
            .saving(nodes, "nodes")
            .saving_about(unknowns, "unknowns"),
    )
}

/// What is the image of the rest under a half turn.
fn half_turn(scene: &Scene, counters: &Counters, used: bool) -> Option<LeftOut> {
    used.then(|| {
        LeftOut::new("its own image under a half turn about x = y: one half is solved")
            .saving(scene.mesh.hexes.len() / 2, "elements")
            .saving_about(counters.equations, "unknowns")
    })
}

/// Bodies that cannot yield.
fn elastic(scene: &Scene, counters: &Counters) -> Vec<LeftOut> {
    let steels = scene.mesh.bodies.iter().zip(&scene.materials);
    let why = match scene.controls.plasticity {
        true => "elastic",
        false => "taken as elastic",
    };
    steels
        .filter(|(_, steel)| steel.is_elastic() || !scene.controls.plasticity)
        .map(|(body, _)| {
            let points = 8 * body.elements.len();
            LeftOut::new(format!("{}: {why}, yield never checked", body.name))
                .saving(points * counters.evaluations, "integration-point updates")
                .saving(points * size_of::<PlasticPoint>(), "bytes of history")
        })
        .collect()
}

/// How many of so many are in the part that was solved.
fn solved(all: usize, solution: &Solution) -> usize {
    if solution.half_turn { all / 2 } else { all }
}

/// Elements that could yield, but stay far from it.
fn yield_checks(scene: &Scene, solution: &Solution) -> Option<LeftOut> {
    let counters = &solution.counters;
    let steels = scene.mesh.bodies.iter().zip(&scene.materials);
    let elements: usize = steels
        .filter(|(_, steel)| !steel.is_elastic() && scene.controls.plasticity)
        .map(|(body, _)| body.elements.len())
        .sum();
    let elements = solved(elements, solution);
    let checked = counters.watched_elements;
    (checked < elements).then(|| {
        let all = 8 * elements * counters.evaluations;
        LeftOut::new(format!(
            "yield checked in {checked} of {elements} elements that could yield; in the others \
             once an increment"
        ))
        .saving(
            all.saturating_sub(counters.plastic_updates),
            "integration-point updates",
        )
    })
}

/// Pairs without friction.
fn frictionless(scene: &Scene, counters: &Counters) -> Option<LeftOut> {
    let smooth = scene.contacts.iter().filter(|pair| pair.friction == 0.0);
    let names: Vec<&str> = smooth.map(|pair| pair.name.as_str()).collect();
    let all = names.len() == scene.contacts.len();
    if names.is_empty() {
        return None;
    }
    let of = if all {
        String::new()
    } else {
        format!("{}: ", names.join(", "))
    };
    let rows = counters.contact_updates - counters.friction_updates;
    Some(
        LeftOut::new(format!("{of}friction 0: no tangential unknowns"))
            .saving(rows, "friction updates"),
    )
}

/// Where nothing depends on the path a step is one increment.
fn path(scene: &Scene) -> Option<LeftOut> {
    let least = (1.0 / scene.controls.first_increment).ceil() as usize;
    (!scene.rubs() && !scene.may_yield()).then(|| {
        LeftOut::new("nothing depends on the path: one increment a step").saving_about(
            scene.steps.len().saturating_mul(least.saturating_sub(1)),
            "increments",
        )
    })
}

/// Unknowns that the iterations do not see.
fn condensation(counters: &Counters) -> Option<LeftOut> {
    let (kept, all) = (counters.kept_equations, counters.equations);
    let again = counters
        .factorisations
        .saturating_sub(counters.preparations);
    let entries = counters.factor_entries - counters.kept_factor_entries;
    (kept < all).then(|| {
        LeftOut::new(format!(
            "bodies condensed: iterations see {kept} of {all} unknowns"
        ))
        .saving(all - kept, "unknowns an iteration")
        .saving_about(again * entries, "factor entries not computed again")
    })
}

/// Elements that are not integrated again for a tangent.
fn integration(scene: &Scene, solution: &Solution) -> Option<LeftOut> {
    let counters = &solution.counters;
    let elements = solved(scene.mesh.hexes.len(), solution);
    let all = elements * counters.linear_solves;
    let done = counters.element_tangents + elements * counters.preparations;
    (done < all).then(|| {
        LeftOut::new(format!(
            "elements integrated again only where they flow: {} of {all} in {} tangents",
            counters.element_tangents, counters.linear_solves
        ))
        .saving(all - done, "element integrations")
    })
}

/// Contact nodes beyond reach, and contact surfaces that are not integrated again.
fn rows(solution: &Solution) -> Option<LeftOut> {
    let counters = &solution.counters;
    let carriers: usize = solution.last.contacts.iter().map(|c| c.nodes.len()).sum();
    let carriers = solved(carriers, solution);
    let rows = counters.contact_rows;
    let all = carriers * counters.evaluations;
    (rows < carriers).then(|| {
        LeftOut::new(format!(
            "contact rows prepared: {rows} of {carriers}, the others being out of reach"
        ))
        .saving(
            all.saturating_sub(counters.contact_updates),
            "contact updates",
        )
        .saving(
            counters.evaluations.saturating_sub(counters.preparations),
            "integrations of the contact surfaces",
        )
    })
}

/// What nobody asked for, or what would say nothing.
fn outputs(scene: &Scene, solution: &Solution, options: &Options) -> Vec<LeftOut> {
    let mut list = Vec::new();
    let elements = scene.mesh.hexes.len();
    if solution.states.iter().all(|state| state.peeq.is_empty()) {
        list.push(
            LeftOut::new("nothing yielded: no plastic strain kept, no second, elastic solution")
                .saving(elements * size_of::<[f64; 8]>(), "bytes a state"),
        );
    } else if !options.elastic_peaks {
        list.push(LeftOut::new(
            "elastic peaks: not wanted (--no-elastic-peaks)",
        ));
    }
    if options.out.is_none() {
        list.push(LeftOut::new("files: not asked for"));
    }
    list
}
