//! The view in space: its controls, and the data that the page's scripts draw.

use crate::ground::file::FileError;
use crate::render::OutputError;
use crate::render::report::drawing::colours;
use crate::render::report::model::shape::{Header, MOST_ELEMENTS, Spot, shape};
use crate::render::report::{FILE, Inputs};
use maud::{Markup, html};
use serde::Serialize;
use std::path::PathBuf;

/// The markup of the view, and what its scripts read.
pub struct Space {
    pub view: Markup,
    pub header: String,
    pub arrays: String,
}

/// The header of the shape and how to show it.
#[derive(Serialize)]
struct Shown<'h> {
    #[serde(flatten)]
    header: &'h Header,
    /// The upright axis.
    up: usize,
    colours: Vec<[u8; 3]>,
}

/// # Errors
/// Where the data cannot be packed.
pub fn space(inputs: &Inputs) -> Result<Space, OutputError> {
    let units = &inputs.summary.units;
    let shape = shape(
        inputs.scene,
        inputs.state,
        (inputs.recovered, inputs.pictures),
        units,
        places(inputs),
    )?;
    let shown = Shown {
        header: &shape.header,
        up: inputs.pictures.upright,
        colours: colours::table(),
    };
    let header = serde_json::to_string(&shown).map_err(|error| FileError::Write {
        path: PathBuf::from(FILE),
        source: error.into(),
    })?;
    Ok(Space {
        view: view(&shape.header),
        header,
        arrays: shape.arrays,
    })
}

/// Where every interface presses hardest, the hardest of all first.
fn places(inputs: &Inputs) -> Vec<Spot> {
    let mut found: Vec<(f64, Spot)> = Vec::new();
    for (name, interface) in &inputs.summary.answer.interfaces.0 {
        let Some(at) = interface.max_pressure_at else {
            continue;
        };
        let widths = interface.lines.iter().map(|line| line.half_width);
        let width = widths.fold(0.0, f64::max);
        let size = if width > 0.0 {
            16.0 * width
        } else {
            4.0 * interface.area.sqrt()
        };
        let spot = Spot {
            name: name.clone(),
            at,
            size,
        };
        found.push((interface.max_pressure, spot));
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found.into_iter().map(|(_, spot)| spot).collect()
}

fn view(header: &Header) -> Markup {
    let gradient: Vec<String> = (0..=16)
        .map(|k| colours::css(f64::from(k) / 16.0))
        .collect();
    let gradient = format!("background:linear-gradient(to top,{})", gradient.join(","));
    html! {
        noscript { p { "The view in space needs JavaScript; the pictures below do not." } }
        div id="view" {
            (controls())
            div class="stage" {
                canvas tabindex="0" role="img"
                    aria-label="The parts in space, in the colours of the chosen field. Arrow keys turn, plus and minus zoom." {}
                img class="still print-only" alt="The parts in space, as the page showed them.";
                div class="key" {
                    div data-control="quantity" {}
                    div class="bar" { div class="colours" style=(gradient) {} div class="ticks" data-control="ticks" {} }
                }
                p class="told" data-control="told" aria-live="polite" {}
                p class="note" { span data-control="note" {} "." }
            }
        }
        p class="note" {
            "Drag to turn, drag with Shift or the right button to move, turn the wheel to zoom; with the keys, arrows \
             and + −. The figure under the mouse is told below the picture. "
            @if header.elements == 0 {
                "This model has more than " (MOST_ELEMENTS) " elements: to keep the page small it holds the outer \
                 faces only, and cannot be cut. The VTK files beside it hold everything."
            } @else {
                "Cuts are made where the parts were before loading."
            }
        }
    }
}

fn controls() -> Markup {
    html! {
        form class="controls" autocomplete="off" {
            fieldset {
                legend { "Colour" }
                select data-control="field" aria-label="Field" {}
                label { "up to " input type="number" min="0" step="any" data-control="upper"; }
            }
            fieldset {
                legend { "Look at" }
                select data-control="look" aria-label="Place" {}
                div {
                    button type="button" data-control="reset" { "reset" }
                    button type="button" data-control="first" { "side" }
                    button type="button" data-control="second" { "front" }
                    button type="button" data-control="above" { "above" }
                }
                label { input type="checkbox" data-control="whole"; " whole, by symmetry" }
                label { input type="checkbox" data-control="mesh"; " mesh" }
            }
            fieldset {
                legend { "Cut" }
                select data-control="cut" aria-label="Direction of the cut" {
                    option value="" { "none" }
                    option value="0" { "across x" }
                    option value="1" { "across y" }
                    option value="2" { "across z" }
                }
                input type="range" min="0" max="1" step="any" value="0.5" data-control="at" aria-label="Place of the cut";
                output data-control="at-value" {}
                label { input type="checkbox" data-control="turned"; " the other side" }
            }
            fieldset {
                legend { "Displacement" }
                input type="range" min="0" max="1" step="0.01" value="0" data-control="deform" aria-label="Exaggeration of the displacement";
                output data-control="deform-value" {}
            }
            fieldset { legend { "Bodies" } div data-control="bodies" {} }
        }
    }
}
