//! Assumptions, what was left out, the model, the time it took, and the versions.

use crate::ground::geometry::AXES;
use crate::render::report::Inputs;
use crate::render::report::figures::number;
use crate::render::report::html::{list, row, table};
use crate::render::summary::Summary;
use crate::render::text::significant;
use maud::{Markup, html};

pub fn run(inputs: &Inputs) -> Markup {
    let summary = inputs.summary;
    let left_out: Vec<String> = (summary.left_out.iter())
        .map(|item| {
            let saved: Vec<String> = item.saved.iter().map(ToString::to_string).collect();
            match saved.is_empty() {
                true => item.what.clone(),
                false => format!("{} (saved: {})", item.what, saved.join(", ")),
            }
        })
        .collect();
    html! {
        (list("Assumed", &summary.assumptions))
        (list("Left out, because the case does not need it", &left_out))
        div class="pair" {
            div { h3 { "Model" } (steels(inputs)) (settings(inputs)) }
            div { h3 { "Time" } (times(summary)) }
        }
    }
}

fn steels(inputs: &Inputs) -> Markup {
    let scene = inputs.scene;
    let rows: Vec<Vec<Markup>> = (scene.mesh.bodies.iter().zip(&scene.materials))
        .map(|(body, steel)| {
            let yields = scene.controls.plasticity && !steel.is_elastic();
            let plastic = |value: f64| yields.then_some(value);
            row([
                body.name.clone(),
                number(Some(steel.youngs_modulus)),
                significant(steel.poissons_ratio, 3),
                number(plastic(steel.yield_stress)),
                number(plastic(steel.hardening_modulus)),
                body.elements.len().to_string(),
            ])
        })
        .collect();
    let stress = &inputs.summary.units.stress;
    let modulus = format!("E, {stress}");
    let yields = format!("yield, {stress}");
    let hardening = format!("hardening, {stress}");
    table(
        "",
        &["body", &modulus, "ν", &yields, &hardening, "elements"],
        &rows,
    )
}

fn settings(inputs: &Inputs) -> Markup {
    let (scene, summary) = (inputs.scene, inputs.summary);
    let friction: Vec<String> = (scene.contacts.iter())
        .map(|pair| format!("{} {}", pair.name, significant(pair.friction, 3)))
        .collect();
    let symmetry: Vec<&str> = scene.mirrors.iter().map(|m| AXES[*m % 3]).collect();
    let controls = &scene.controls;
    let mut rows: Vec<[String; 2]> = vec![
        ["unknowns".into(), summary.counters.dofs.to_string()],
        [
            "elements".into(),
            format!("{} ({:?})", summary.answer.elements, controls.element),
        ],
        [
            "symmetric about".into(),
            match symmetry.is_empty() {
                true => "nothing: the whole is modelled".to_string(),
                false => symmetry.join(" and "),
            },
        ],
        ["friction".into(), friction.join(", ")],
        ["mesh".into(), scene.mesh.source.clone()],
        [
            "mesh fingerprint".into(),
            scene
                .mesh
                .fingerprint
                .clone()
                .unwrap_or_else(|| "none".into()),
        ],
        [
            "tolerance of forces".into(),
            format!("{:e} of the applied", controls.residual),
        ],
        [
            "program".into(),
            format!("Brinell {}", summary.brinell_version),
        ],
    ];
    rows.extend(
        inputs
            .setting
            .iter()
            .map(|(name, value)| [name.clone(), value.clone()]),
    );
    html! {
        div class="scroll" {
            table { tbody { @for [name, value] in &rows {
                tr { th scope="row" { (name) } td class="left why" { (value) } }
            } } }
        }
    }
}

fn times(summary: &Summary) -> Markup {
    let timing = &summary.timing;
    let seconds = |value: f64| format!("{value:.2}");
    let mut rows = vec![
        row(["mesh and scene".to_string(), seconds(timing.mesh_s)]),
        row(["solution".to_string(), seconds(timing.solve_s)]),
    ];
    for (phase, value) in &timing.phases.0 {
        rows.push(row([
            format!("– {}", phase.replace('_', " ")),
            seconds(*value),
        ]));
    }
    rows.push(row([
        "fields to files".to_string(),
        seconds(timing.write_s),
    ]));
    rows.push(row([
        "again without plasticity".to_string(),
        seconds(timing.elastic_s),
    ]));
    rows.push(row(["together".to_string(), seconds(timing.total_s)]));
    let memory = summary.peak_memory_bytes.map(|bytes| 1e-6 * bytes as f64);
    html! {
        (table("", &["", "seconds"], &rows))
        p class="note" {
            (summary.counters.iterations) " iterations, " (summary.counters.factorisations) " factorisations"
            @if let Some(memory) = memory { ", " (format!("{memory:.0}")) " MB at most" }
            ". This page is made afterwards and not counted."
        }
    }
}
