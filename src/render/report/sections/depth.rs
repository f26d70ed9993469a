//! The Mises stress below each line of contact, against the closed form.

use super::strip::Line;
use crate::analytic::subsurface::LineField;
use crate::answer::results::depth::mises_along;
use crate::render::report::Inputs;
use crate::render::report::drawing::axes::Axis;
use crate::render::report::drawing::chart::{Chart, Mark, Series, from_zero};
use maud::{Markup, html};

/// As deep as so many half-widths.
const REACH: f64 = 6.0;

/// A diagram a line.
pub fn charts(inputs: &Inputs, lines: &[Line]) -> Markup {
    if lines.is_empty() {
        return Markup::default();
    }
    html! {
        h3 { "Mises stress against depth" }
        p class="note" {
            "Into both bodies, square to the surface below the centre of pressure at the same place. Closed form: \
             an elastic half space in plane strain under Hertz's pressure, without friction. Where steel has \
             yielded the computed stress is capped by it."
        }
        div class="pair" { @for line in lines { (chart(inputs, line).draw()) } }
    }
}

fn chart(inputs: &Inputs, line: &Line) -> Chart {
    let units = &inputs.summary.units;
    let half_width = line.hertz.map_or(line.half_width, |hertz| hertz.half_width);
    let reach = REACH * half_width;
    let normal = line.profile.normal;
    let mut series = Vec::new();
    let mut ratios: Vec<f64> = Vec::new();
    for (colour, (body, sign)) in line.bodies.iter().zip([-1.0, 1.0]).enumerate() {
        let Some(body) = *body else { continue };
        let into = normal.map(|n| sign * n);
        let ray = (line.profile.centre, into);
        series.push(Series {
            name: inputs.scene.mesh.bodies[body].name.clone(),
            mark: Mark::LineAndDots,
            colour: [0, 2][colour],
            points: mises_along(inputs.scene, inputs.recovered, body, ray, reach),
        });
        let ratio = inputs.scene.materials[body].poissons_ratio;
        if !ratios.contains(&ratio) {
            ratios.push(ratio);
        }
    }
    let several = ratios.len() > 1;
    for ratio in ratios {
        let Some(field) = line.hertz.and_then(|h| LineField::below(&h, ratio).ok()) else {
            continue;
        };
        series.push(Series {
            name: match several {
                true => format!("closed form, elastic, ν = {ratio}"),
                false => "closed form, elastic".to_string(),
            },
            mark: Mark::Line,
            colour: 1,
            points: below(&field, reach),
        });
    }
    let largest = from_zero(series.iter().flat_map(|s| s.points.iter().map(|p| p.1)));
    Chart {
        title: line.name(&units.length),
        axes: [
            Axis::linear(format!("depth, {}", units.length), 0.0..reach),
            Axis::linear(format!("Mises stress, {}", units.stress), largest),
        ],
        series,
    }
}

fn below(field: &LineField, reach: f64) -> Vec<(f64, f64)> {
    const POINTS: u32 = 90;
    let depths = (0..=POINTS).map(|k| reach * f64::from(k) / f64::from(POINTS));
    let points = depths.filter_map(|z| Some((z, field.stress(0.0, z).ok()?.mises())));
    points.collect()
}
