//! The pressure across each line of contact where it carries most, against Hertz.

use crate::analytic::hertz::LineContact;
use crate::answer::results::contact_lines::contact_lines;
use crate::answer::results::hertz::line_contact;
use crate::answer::results::line_load::Slices;
use crate::answer::results::strip_profile::{StripProfile, strip_profile};
use crate::ground::geometry::AXES;
use crate::model::scene::Scene;
use crate::render::report::Inputs;
use crate::render::report::drawing::axes::Axis;
use crate::render::report::drawing::chart::{Chart, Mark, Series, extent, from_zero};
use crate::render::text::significant;
use maud::{Markup, html};

/// A line of contact, what was computed across it, and Hertz's contact under the same load per
/// length.
#[derive(Debug, Clone)]
pub struct Line {
    pub interface: String,
    /// The axis along which it runs, and its mean coordinate across.
    pub axis: usize,
    pub across: f64,
    pub half_width: f64,
    pub profile: StripProfile,
    /// `None` where the curvature of a surface is not known, or the two do not curve apart.
    pub hertz: Option<LineContact>,
    /// The bodies on the carrier's side and on the other, where there are such.
    pub bodies: [Option<usize>; 2],
}

impl Line {
    /// Such as "upper_plate-upper_roller, line at x = 0 in, at y = 4 in".
    pub fn name(&self, length: &str) -> String {
        let row = significant(self.profile.at, 3);
        let along = AXES[self.axis];
        let across = significant(self.across, 3);
        format!(
            "{}, line at {across} {length}, where {along} = {row} {length}",
            self.interface
        )
    }
}

/// Every line of contact of the modelled part.
pub fn lines(inputs: &Inputs) -> Vec<Line> {
    let (scene, state) = (inputs.scene, inputs.state);
    let mut all = Vec::new();
    for (pair, contact) in scene.contacts.iter().enumerate() {
        let Some(axis) = Slices::equal(scene, pair, 1).map(|s| s.axis) else {
            continue;
        };
        for line in contact_lines(scene, state, pair, axis) {
            let Some(profile) = strip_profile(scene, state, pair, axis, &line) else {
                continue;
            };
            all.push(Line {
                interface: contact.name.clone(),
                axis,
                across: line.across,
                half_width: line.heaviest.half_width,
                hertz: line_contact(scene, contact, (axis, &line.heaviest), profile.line_load),
                profile,
                bodies: bodies(scene, pair),
            });
        }
    }
    all
}

fn bodies(scene: &Scene, pair: usize) -> [Option<usize>; 2] {
    let partners = scene.contacts[pair].carrier_first();
    partners.map(|partner| partner.body(&scene.mesh))
}

/// A diagram a line.
pub fn charts(inputs: &Inputs, lines: &[Line]) -> Markup {
    if lines.is_empty() {
        return Markup::default();
    }
    html! {
        h3 { "Pressure across the strip" }
        p class="note" {
            "Across each line where it carries most, along the surface from the centre of pressure. Hertz: an \
             elastic half space under the same load per length there."
        }
        div class="pair" { @for line in lines { (chart(inputs, line).draw()) } }
    }
}

fn chart(inputs: &Inputs, line: &Line) -> Chart {
    let units = &inputs.summary.units;
    let computed = line.profile.points.clone();
    let largest = computed.iter().map(|p| p.1).fold(0.0, f64::max);
    let load = significant(line.profile.line_load, 4);
    let mut series = vec![Series {
        name: format!(
            "computed, nodes: p max {} {}, half-width {} {}",
            significant(largest, 4),
            units.stress,
            significant(line.half_width, 3),
            units.length
        ),
        mark: Mark::LineAndDots,
        colour: 0,
        points: computed,
    }];
    if let Some(hertz) = &line.hertz {
        series.push(Series {
            name: format!(
                "Hertz for {load} {}: p0 {} {}, a {} {}",
                units.line_load(),
                significant(hertz.peak_pressure, 4),
                units.stress,
                significant(hertz.half_width, 3),
                units.length
            ),
            mark: Mark::Line,
            colour: 1,
            points: ellipse(hertz),
        });
    }
    let all = || series.iter().flat_map(|s| s.points.iter());
    let x = Axis::linear(
        format!("distance from the centre, {}", units.length),
        extent(all().map(|p| p.0)),
    );
    let y = Axis::linear(
        format!("pressure, {}", units.stress),
        from_zero(all().map(|p| p.1)),
    );
    Chart {
        title: line.name(&units.length),
        axes: [x, y],
        series,
    }
}

/// Dense where it is steep.
fn ellipse(hertz: &LineContact) -> Vec<(f64, f64)> {
    const POINTS: u32 = 60;
    let place = |k: u32| -(std::f64::consts::PI * f64::from(k) / f64::from(POINTS)).cos();
    let points = (0..=POINTS).map(place).filter_map(|share| {
        let x = share * hertz.half_width;
        Some((x, hertz.pressure(x).ok()?))
    });
    points.collect()
}
