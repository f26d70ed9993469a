//! Forces, pressures and lines of the interfaces.

use crate::answer::InterfaceFigures;
use crate::answer::certify::Quantity;
use crate::render::report::figures::{certified, share};
use crate::render::report::html::{row, table};
use crate::render::summary::Summary;
use crate::render::text::{place, significant};
use maud::{Markup, html};

pub fn contact(summary: &Summary) -> Markup {
    if summary.answer.interfaces.0.is_empty() {
        return Markup::default();
    }
    html! {
        (pressures(summary))
        (forces(summary))
        (lines(summary))
        (checks(summary))
    }
}

fn pressures(summary: &Summary) -> Markup {
    let units = &summary.units;
    let figure = |what, name: &str, value: f64| certified(value, summary.answer.figure(what, name));
    let rows: Vec<Vec<Markup>> = (summary.answer.interfaces.0.iter())
        .map(|(name, i)| {
            let half = summary.answer.figure(Quantity::HalfWidth, name);
            let half = half.map(|c| certified(c.value, Some(c)));
            let counts = &i.status_counts;
            row([
                html! { (name) },
                html! { (figure(Quantity::PeakPressure, name, i.max_pressure)) },
                html! { (i.max_pressure_at.map_or_else(|| "–".to_string(), place)) },
                html! { (half.unwrap_or_else(|| "–".to_string())) },
                html! { (figure(Quantity::ContactArea, name, i.area)) },
                html! { (share(summary.answer.descent.filter(|d| *d != 0.0).map(|d| i.max_penetration / d.abs()))) },
                html! { (i.max_slip.map_or_else(|| "–".to_string(), |s| significant(s, 3))) },
                html! { (counts.open) " / " (counts.stick) " / " (counts.slip) },
            ])
        })
        .collect();
    let peak = format!("peak pressure, {}", units.stress);
    let at = format!("at, {}", units.length);
    let half = format!("half-width, {}", units.length);
    let area = format!("area, {}", units.area());
    let slip = format!("slip, {}", units.length);
    let headings = [
        "interface",
        &peak,
        &at,
        &half,
        &area,
        "penetration of descent",
        &slip,
        "nodes open / stick / slip",
    ];
    table("Pressure", &headings, &rows)
}

fn forces(summary: &Summary) -> Markup {
    let units = &summary.units;
    let rows: Vec<Vec<Markup>> = (summary.answer.interfaces.0.iter())
        .map(|(name, i)| {
            let [x, y, z] = i.force.map(|f| rounded(f, i.normal_force));
            row([
                html! { (name) },
                html! { (significant(i.normal_force, 4)) },
                html! { (share(Some(i.normal_force / summary.answer.applied_load))) },
                html! { (x) },
                html! { (y) },
                html! { (z) },
                html! { (significant(i.pressure_integral, 4)) },
                html! { (acts_at(i)) },
            ])
        })
        .collect();
    let caption = format!("Force on the lower body, {}, of the whole", units.force);
    let at = format!("acts at, {}", units.length);
    let headings = [
        "interface",
        "along the load",
        "share",
        "x",
        "y",
        "z",
        "∫ p dA",
        &at,
    ];
    table(&caption, &headings, &rows)
}

fn acts_at(interface: &InterfaceFigures) -> String {
    (interface.centre_of_force).map_or_else(|| "–".to_string(), place)
}

/// A component of a force, as zero where it is noise beside the whole.
fn rounded(component: f64, whole: f64) -> String {
    match component.abs() < 1e-9 * whole.abs() {
        true => "0".to_string(),
        false => significant(component, 4),
    }
}

fn lines(summary: &Summary) -> Markup {
    let units = &summary.units;
    let interfaces = summary.answer.interfaces.0.iter();
    let lines = interfaces.flat_map(|(name, i)| i.lines.iter().map(move |line| (name, line)));
    let rows: Vec<Vec<Markup>> = lines
        .map(|(name, line)| {
            row([
                html! { (name) ", along " (line.axis) },
                html! { (significant(line.across, 3)) },
                html! { (line.images) },
                html! { (significant(line.peak, 4)) },
                html! { (significant(line.peak_at, 3)) },
                html! { (significant(line.half_width, 3)) },
                html! { (significant(line.mean, 4)) },
                html! { (significant(line.length, 3)) },
                html! { (significant(line.lifted_off, 3)) },
            ])
        })
        .collect();
    let length = &units.length;
    let across = format!("across at, {length}");
    let largest = format!("largest load, {}", units.line_load());
    let at = format!("at, {length}");
    let half = format!("half-width there, {length}");
    let even = format!("evenly, {}", units.line_load());
    let touching = format!("in contact, {length}");
    let off = format!("lifted off, {length}");
    let headings = [
        "line",
        &across,
        "lines alike",
        &largest,
        &at,
        &half,
        &even,
        &touching,
        &off,
    ];
    table("Lines of contact", &headings, &rows)
}

fn checks(summary: &Summary) -> Markup {
    let checks = &summary.answer.checks;
    let rows: Vec<Vec<Markup>> = [
        ("force balance, of the load", checks.force_balance),
        (
            "penetration, of the descent",
            checks.max_penetration_relative,
        ),
        ("Coulomb violation, of μ p", checks.coulomb_violation),
        (
            "carried by stabilisation, of the load",
            checks.stabilisation_share,
        ),
    ]
    .into_iter()
    .map(|(name, value)| {
        let value = value.map_or_else(|| "–".to_string(), |v| format!("{v:.1e}"));
        row([name.to_string(), value])
    })
    .collect();
    table("Checks", &["", "relative"], &rows)
}
