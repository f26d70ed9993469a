//! The page from top to bottom.

use super::Inputs;
use super::html::in_script;
use super::sections::{
    convergence, depth, input, line_load, model, pictures, pressure_map, run, scope, sketch, space,
    strip, title_block, verdict, verified,
};
use crate::render::OutputError;
use crate::render::sections::{
    bodies, certificate, checks, compared, contact, hand_checks, lines, load_line, rules, sizing,
    statics, steps, ties, unloaded,
};
use crate::render::table::Table;
use crate::render::table::html::{table, tables};
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// Nothing from elsewhere, nothing sent: only what stands in the page itself.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

const STYLE: &str = include_str!("assets/style.css");

/// In the order in which they need each other.
const SCRIPTS: [&str; 7] = [
    include_str!("assets/unpack.js"),
    include_str!("assets/model.js"),
    include_str!("assets/cut.js"),
    include_str!("assets/camera.js"),
    include_str!("assets/renderer.js"),
    include_str!("assets/view.js"),
    include_str!("assets/page.js"),
];

/// A part of the page: its name in addresses, its heading, and what it says.
struct Section {
    id: &'static str,
    heading: &'static str,
    content: Markup,
}

/// What stands before the body of a page.
pub fn html_head(title: &str, policy: &str) -> Markup {
    html! {
        head {
            meta charset="utf-8";
            meta name="viewport" content="width=device-width, initial-scale=1";
            meta http-equiv="Content-Security-Policy" content=(policy);
            title { (title) " – Brinell" }
            // An address that holds nothing, lest a browser look for an icon.
            link rel="icon" href="data:,";
            style { (PreEscaped(STYLE)) }
        }
    }
}

pub fn page(inputs: &Inputs) -> Result<Markup, OutputError> {
    let summary = inputs.summary;
    let section = |id, heading, content| Section {
        id,
        heading,
        content,
    };
    let space = space::space(inputs)?;
    let mut loading: Vec<Table> = vec![load_line(summary), steps(summary)];
    loading.extend(unloaded(summary));
    let sections = [
        section("scope", "Scope and actions", scope::scope(inputs)),
        section("sketch", "Sketch", sketch::sketch(inputs)),
        section("inputs", "Inputs and their origin", scope::inputs(inputs)),
        section("model", "Model", model::model(inputs)),
        section("peaks", "Peak stresses", tables(&bodies(summary))),
        section("sizing", "Sizing rules", tables(&sizing(summary))),
        section("rules", "Design rules", tables(&rules(summary))),
        section("space", "The parts in space", space.view),
        section(
            "pictures",
            "Mises stress in section",
            pictures::pictures(inputs)?,
        ),
        section(
            "contact",
            "Contact",
            html! {
                (tables(&contact(summary)))
                (tables(&ties(summary)))
                (table(&lines(summary)))
                (tables(&statics(summary)))
                (table(&checks(summary)))
            },
        ),
        section(
            "pressure",
            "Pressure on the contact surfaces",
            pressure_map::maps(inputs)?,
        ),
        section(
            "strips",
            "Across the lines of contact and below them",
            html! { (strip::pressures(inputs)) (depth::stresses(inputs)) },
        ),
        section(
            "line-load",
            "Load along the lines of contact",
            line_load::loads(summary),
        ),
        section("compared", "Compared", table(&compared(summary))),
        section(
            "certificate",
            "What the figures are worth",
            table(&certificate(summary)),
        ),
        section("verified", "Verification", verified::verified(inputs)),
        section("checker", "For the checker", table(&hand_checks(summary))),
        section("loading", "Load and descent", tables(&loading)),
        section(
            "convergence",
            "Convergence",
            convergence::convergence(inputs),
        ),
        section("run", "Assumptions and the run", run::run(inputs)),
        section("input", "Input", input::input(inputs)),
    ];
    // A section that has nothing to say is not there.
    let sections: Vec<Section> = (sections.into_iter())
        .filter(|s| !s.content.0.is_empty())
        .collect();
    Ok(html! {
        (DOCTYPE)
        html lang="en" {
            (html_head(&summary.case, POLICY))
            body {
                h1 { (summary.case) }
                p class="sub" { "Brinell " (summary.brinell_version) " · " (inputs.case.0) }
                (title_block::title_block(inputs))
                section id="verdict" { (verdict::verdict(inputs)) }
                nav aria-label="Sections" {
                    @for s in &sections { a href=(format!("#{}", s.id)) { (s.heading) } }
                }
                @for s in &sections {
                    section id=(s.id) { h2 { (s.heading) } (s.content) }
                }
                script type="application/json" id="header" { (in_script(&space.header)) }
                script type="text/plain" id="arrays" { (PreEscaped(space.arrays)) }
                script { (PreEscaped("\"use strict\";\n")) @for script in SCRIPTS { (PreEscaped(script)) } }
            }
        }
    })
}
