//! Assumptions, what was left out, the model, the time it took, and the versions.

use crate::ground::geometry::AXES;
use crate::ground::hash::Fnv;
use crate::render::report::Inputs;
use crate::render::report::html::list;
use crate::render::summary::Summary;
use crate::render::table::html::table;
use crate::render::table::{Cell, Table};
use crate::render::text::significant;
use maud::{Markup, html};

pub fn run(inputs: &Inputs) -> Markup {
    let summary = inputs.summary;
    let left_out: Vec<String> = (summary.left_out.iter())
        .map(|item| {
            let saved: Vec<String> = item.saved.iter().map(ToString::to_string).collect();
            if saved.is_empty() {
                item.what.clone()
            } else {
                format!("{} (saved: {})", item.what, saved.join(", "))
            }
        })
        .collect();
    html! {
        (list("Assumed", &summary.assumptions))
        (list("Left out, because the case does not need it", &left_out))
        div class="pair" {
            div { h3 { "Model" } (table(&steels(inputs))) (settings(inputs)) }
            div { h3 { "Time" } (times(summary)) }
        }
    }
}

fn steels(inputs: &Inputs) -> Table {
    let scene = inputs.scene;
    let stress = &inputs.summary.units.stress;
    let mut table = Table::new("")
        .words("body")
        .figure("E", stress)
        .figures(["ν"])
        .figure("yield", stress)
        .figure("hardening", stress)
        .figures(["elements"]);
    for (body, steel) in scene.mesh.bodies.iter().zip(&scene.materials) {
        let yields = scene.controls.plasticity && !steel.is_elastic();
        let plastic = |value: f64| Cell::figure(yields.then_some(value));
        table.row([
            (&body.name).into(),
            Cell::figure(steel.youngs_modulus),
            Cell::rough(steel.poissons_ratio),
            plastic(steel.yield_stress),
            plastic(steel.hardening_modulus),
            body.elements.len().into(),
        ]);
    }
    table
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
            if symmetry.is_empty() {
                "nothing: the whole is modelled".to_string()
            } else {
                symmetry.join(" and ")
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
        ["case file, FNV-1a".into(), Fnv::hex(inputs.case.1)],
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
    let mut times = Table::new("").words("").figures(["seconds"]);
    let mut time = |name: String, seconds: f64| {
        times.row([name.into(), format!("{seconds:.2}").into()]);
    };
    time("mesh and scene".into(), timing.mesh_s);
    time("solution".into(), timing.solve_s);
    for (phase, seconds) in &timing.phases.0 {
        time(format!("– {}", phase.replace('_', " ")), *seconds);
    }
    time("fields to files".into(), timing.write_s);
    time("again without plasticity".into(), timing.elastic_s);
    time("together".into(), timing.total_s);
    let memory = summary.peak_memory_bytes.map(|bytes| 1e-6 * bytes as f64);
    html! {
        (table(&times))
        p class="note" {
            (summary.counters.iterations) " iterations, " (summary.counters.factorisations) " factorisations"
            @if let Some(memory) = memory { ", " (format!("{memory:.0}")) " MB at most" }
            ". This page is made afterwards and not counted."
        }
    }
}
