//! The load per length along every line of contact, of the whole bearing.

use crate::render::line_load::{WholeLine, whole_lines};
use crate::render::report::drawing::axes::Axis;
use crate::render::report::drawing::chart::{Chart, Mark, Series, extent, from_zero};
use crate::render::summary::Summary;
use crate::render::text::significant;
use maud::{Markup, html};

/// A diagram an interface.
pub fn charts(summary: &Summary) -> Markup {
    let lines = whole_lines(summary);
    if lines.is_empty() {
        return Markup::default();
    }
    let interfaces = lines.chunk_by(|a, b| a.interface == b.interface);
    html! {
        p class="note" { "Force normal to the surface per length at each row of nodes; dashed, the same force spread \
                          evenly over the length. The figures are in line-load.csv." }
        div class="pair" { @for of in interfaces { (chart(of, summary).draw()) } }
    }
}

fn chart(lines: &[WholeLine], summary: &Summary) -> Chart {
    let units = &summary.units;
    let axis = lines.first().map_or("", |line| line.axis);
    let mut series = Vec::new();
    for (colour, line) in lines.iter().enumerate() {
        let at = significant(line.across, 3);
        series.push(Series {
            name: format!("line at {at} {}", units.length),
            mark: Mark::LineAndDots,
            colour,
            points: line.rows.clone(),
        });
        let ends = extent(line.rows.iter().map(|r| r.0));
        series.push(Series {
            name: format!(
                "{} {}, evenly",
                significant(line.mean, 4),
                units.line_load()
            ),
            mark: Mark::Dashed,
            colour,
            points: vec![(ends.start, line.mean), (ends.end, line.mean)],
        });
    }
    let all = || series.iter().flat_map(|s| s.points.iter());
    Chart {
        title: lines
            .first()
            .map_or_else(String::new, |line| line.interface.to_string()),
        axes: [
            Axis::linear(
                format!("{axis}, {}", units.length),
                extent(all().map(|p| p.0)),
            ),
            Axis::linear(
                format!("line load, {}", units.line_load()),
                from_zero(all().map(|p| p.1)),
            ),
        ],
        series,
    }
}
