//! The load per length along every line of contact, of the whole bearing.

use crate::render::line_load::{figure, whole_lines};
use crate::render::plot::charts;
use crate::render::summary::Summary;
use maud::{Markup, html};

/// A diagram an interface: those of line-load.svg.
pub fn loads(summary: &Summary) -> Markup {
    let lines = whole_lines(summary);
    if lines.is_empty() {
        return Markup::default();
    }
    html! {
        p class="note" { "Force normal to the surface per length at each row of nodes; dashed, the same force spread \
                          evenly over the length. The figures are in line-load.csv." }
        (charts([&figure(&lines, &summary.units)]))
    }
}
