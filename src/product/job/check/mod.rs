//! A case and its mesh looked at, but not solved.

mod held;
mod strip;

use super::error::JobError;
use super::mesh::find_mesh;
use super::summarise::assumptions;
use super::welds::welds;
use super::{left_out, limits};
use crate::case::{Case, Kind};
use crate::ground::memory;
use crate::ground::units::UnitLabels;
use crate::model::mesh::Mesh;
use crate::model::scene::Scene;
use crate::render::check::{BodyCheck, Check, ContactCheck, Machine, MeshCheck, PredictedCost};
use crate::render::text::{percent, significant};
use crate::solver::solve::{Forecast, FreeMotion, forecast};
use std::collections::BTreeSet;
use std::path::Path;

/// Elements with a smaller scaled Jacobian, or a larger aspect ratio, are worth a warning.
const POOR_JACOBIAN: f64 = 0.1;
const POOR_ASPECT: f64 = 100.0;

/// Gaps and ways of less than this share of the largest coordinate are none.
const ROUNDING: f64 = 1e-9;

/// Looks at `case` on the mesh that it would be solved on, which gmsh makes where there is none.
///
/// # Errors
/// [`JobError`] for whatever would stop a run before it solves: the case, its mesh, supports that
/// contradict each other.
pub fn check(case: &Case, say: &mut dyn FnMut(&str)) -> Result<Check, JobError> {
    let mesh = find_mesh(case, None, say)?;
    // What gmsh has just made was kept nowhere.
    let made = matches!(case.kind, Kind::Bearing(_)) && !Path::new(&mesh.source).exists();
    let source = match made {
        true => "of the template, by gmsh".to_string(),
        false => mesh.source.clone(),
    };
    let mut scene = case.scene(mesh)?;
    let bodies = bodies(&scene);
    let forecast = forecast(&mut scene)?;
    let machine = Machine {
        threads: rayon::current_num_threads(),
        memory_bytes: memory::available(),
    };
    let units = case.units;
    let mut check = Check {
        case: case.title.clone(),
        units: UnitLabels::of(units),
        mesh: MeshCheck {
            source,
            nodes: scene.mesh.points.len(),
            elements: scene.mesh.hexes.len(),
        },
        bodies,
        contacts: contacts(&scene, &forecast),
        strips: strip::strips(case, &scene, &forecast)?,
        cost: cost(&scene, &forecast, machine.threads),
        machine,
        needs: needs(&scene, &forecast),
        left_out: left_out::beforehand(case, &scene, &forecast),
        assumptions: assumptions(case),
        limits: limits::all(case),
        warnings: Vec::new(),
        problems: Vec::new(),
    };
    check.warnings = warnings(&check, &scene.mesh, &forecast);
    check.problems = problems(&check, &forecast);
    Ok(check)
}

fn bodies(scene: &Scene) -> Vec<BodyCheck> {
    let quality = scene.mesh.quality();
    let bodies = scene.mesh.bodies.iter().zip(quality).enumerate();
    let checked = bodies.map(|(index, (body, quality))| BodyCheck {
        name: body.name.clone(),
        elements: quality.elements,
        nodes: scene.mesh.nodes_of_body(index).len(),
        volume: quality.volume,
        min_scaled_jacobian: quality.min_scaled_jacobian,
        max_aspect_ratio: quality.max_aspect_ratio,
        held_by: held::held_by(scene, index),
    });
    checked.collect()
}

fn contacts(scene: &Scene, forecast: &Forecast) -> Vec<ContactCheck> {
    let rounded = rounded(&scene.mesh);
    let pairs = scene.contacts.iter().zip(&forecast.pairs);
    let checked = pairs.map(|(pair, found)| ContactCheck {
        name: pair.name.clone(),
        friction: pair.friction,
        gap: found.gap.map(&rounded),
        gap_at_touch: found.gap_at_touch.map(&rounded),
        at: found.at.map(|(node, _)| scene.mesh.points[node as usize]),
        likely: found.likely,
        within_reach: found.within_reach,
    });
    checked.collect()
}

/// Seconds on the clock: two threads were measured to do one and a half times the work of one, more
/// are not reckoned with. A run that may yield is solved twice, the second time in a few
/// iterations; the rough figure is taken as right within a factor of two and a half.
fn cost(scene: &Scene, forecast: &Forecast, threads: usize) -> PredictedCost {
    const SPREAD: f64 = 2.5;
    let speed = if threads > 1 { 1.5 } else { 1.0 };
    let wall = forecast.processor_s / speed;
    let largest = match forecast.can_yield > 0 {
        true => 1.4 * SPREAD,
        false => SPREAD,
    };
    PredictedCost {
        unknowns: forecast.unknowns,
        contact_unknowns: forecast.kept,
        solver: match (forecast.divided, scene.contacts.is_empty()) {
            (true, _) => "divided into subdomains, conjugate directions",
            (false, false) => "bodies condensed onto contact, then factorised",
            (false, true) => "factorised",
        },
        memory_bytes: forecast.memory,
        iterations: forecast.iterations,
        processor_s: forecast.processor_s,
        wall_s: [wall / SPREAD, wall * largest],
    }
}

/// What the scene makes the solution do.
fn needs(scene: &Scene, forecast: &Forecast) -> Vec<String> {
    let mut needs = Vec::new();
    let steps: Vec<String> = (scene.steps.iter())
        .map(|step| format!("{} (to {})", step.name, significant(step.factor, 3)))
        .collect();
    needs.push(format!("steps: {}", steps.join(", ")));
    if forecast.can_yield > 0 {
        let yielding = (scene.mesh.bodies.iter().zip(&scene.materials))
            .filter(|(_, steel)| !steel.is_elastic())
            .map(|(body, _)| body.name.as_str());
        let yielding: Vec<&str> = yielding.collect();
        needs.push(format!(
            "plasticity: {} of {} elements can yield, in {}",
            forecast.can_yield,
            scene.mesh.hexes.len(),
            yielding.join(", ")
        ));
    }
    let rubbing = scene.contacts.iter().filter(|pair| pair.friction > 0.0);
    let rubbing: Vec<&str> = rubbing.map(|pair| pair.name.as_str()).collect();
    if !rubbing.is_empty() {
        needs.push(format!("friction: {}", rubbing.join(", ")));
    }
    let rounded = rounded(&scene.mesh);
    for closing in &forecast.closings {
        let [x, y, z] = closing.shift.map(|c| significant(rounded(c), 3));
        needs.push(format!(
            "first touch: {} moved by [{x}, {y}, {z}]",
            closing.body
        ));
    }
    needs
}

fn warnings(check: &Check, mesh: &Mesh, forecast: &Forecast) -> Vec<String> {
    let mut list = in_words(forecast.free.iter().filter(|free| !free.is_fatal()));
    for (body, part) in check.bodies.iter().zip(&mesh.bodies) {
        let name = &body.name;
        if body.min_scaled_jacobian < POOR_JACOBIAN {
            let least = significant(body.min_scaled_jacobian, 2);
            list.push(format!(
                "{name}: an element with a scaled Jacobian of {least} is nearly flat at a corner"
            ));
        }
        if body.max_aspect_ratio > POOR_ASPECT {
            let ratio = significant(body.max_aspect_ratio, 3);
            list.push(format!(
                "{name}: an element is {ratio} times as long as wide"
            ));
        }
        let pieces = mesh.pieces(part.elements.clone());
        if pieces > 1 {
            list.push(format!(
                "{name} falls into {pieces} pieces that share no nodes"
            ));
        }
    }
    list.extend(welds(mesh).iter().map(|weld| weld.in_words(mesh)));
    for contact in &check.contacts {
        let name = &contact.name;
        match contact.gap_at_touch {
            None => list.push(format!(
                "{name}: the two surfaces do not face each other, so this pair carries nothing"
            )),
            Some(_) if contact.within_reach == 0 => list.push(format!(
                "{name}: nothing is within reach, so this pair carries nothing"
            )),
            Some(gap) if gap < 0.0 => list.push(format!(
                "{name}: the surfaces overlap by {} {} before the load",
                significant(-gap, 3),
                check.units.length
            )),
            Some(_) => {}
        }
    }
    for strip in &check.strips {
        if strip.pressure_error.is_none() {
            list.push(format!(
                "{}: the nodes are {} half-widths of the contact strip apart: pressures and stresses \
                 below it will belong to the mesh",
                strip.contact,
                significant(1.0 / strip.elements, 2)
            ));
        }
    }
    list
}

/// Each once: a body may move in many ways that read the same.
fn in_words<'f>(free: impl Iterator<Item = &'f FreeMotion>) -> Vec<String> {
    let mut list: Vec<String> = free.map(held::free_in_words).collect();
    let mut told = BTreeSet::new();
    list.retain(|text| told.insert(text.clone()));
    list
}

/// Gaps and ways, as none where they are nothing but rounding.
fn rounded(mesh: &Mesh) -> impl Fn(f64) -> f64 {
    let coordinates = mesh.points.iter().flatten();
    let rounding = ROUNDING * coordinates.fold(0.0f64, |most, c| most.max(c.abs()));
    move |way| if way.abs() <= rounding { 0.0 } else { way }
}

fn problems(check: &Check, forecast: &Forecast) -> Vec<String> {
    let mut list = in_words(forecast.free.iter().filter(|free| free.is_fatal()));
    let needed = check.cost.memory_bytes;
    if let Some(left) = check.machine.memory_bytes.filter(|left| needed > *left) {
        list.push(format!(
            "about {} GB of memory are needed, {} of what is left: a coarser mesh, or \
             `solver = \"divided\"` under [controls]",
            significant(1e-9 * needed, 3),
            percent(needed / left)
        ));
    }
    list
}
