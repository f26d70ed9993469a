//! Printed values and Hertz's figures beside those of a run. They decide nothing.

use super::error::JobError;
use super::even_load::EvenlyLoaded;
use crate::answer::certify::{Figure, Quantity};
use crate::answer::{Answer, Three};
use crate::case::{Case, ComparedMeasure, MisesRead, Printed};
use crate::ground::units::UnitLabels;
use crate::model::scene::Scene;
use crate::render::summary::{Comparison, Reported};

/// One row a printed value, then Hertz's figures of a bearing under an even line load.
pub fn rows(case: &Case, scene: &Scene, answer: &Answer) -> Result<Vec<Comparison>, JobError> {
    let hertz = (case.bearing()).map(|bearing| EvenlyLoaded::of(bearing, scene));
    let hertz = hertz.transpose()?;
    let units = UnitLabels::of(case.units);
    let mut rows = Vec::new();
    if let Some(comparison) = &case.comparison {
        for printed in &comparison.values {
            rows.push(printed_row(
                printed,
                comparison.mises_read,
                (answer, &units),
                hertz.as_ref(),
            ));
        }
    }
    if let Some(hertz) = &hertz {
        rows.extend(hertz_rows(hertz, (answer, &units)));
    }
    Ok(rows)
}

fn printed_row(
    printed: &Printed,
    read: MisesRead,
    (answer, units): (&Answer, &UnitLabels),
    hertz: Option<&EvenlyLoaded>,
) -> Comparison {
    let place = printed.place.as_str();
    let (what, value, hertz) = match printed.what {
        ComparedMeasure::Mises => {
            let plates = hertz.map(|h| h.plate_mises);
            let rollers = hertz.map(|h| h.roller_mises);
            let hertz = match place {
                p if p.contains("roller") => rollers,
                p if p.contains("plate") => plates,
                _ => plates.into_iter().chain(rollers).reduce(f64::max),
            };
            let (name, value) = match read {
                MisesRead::Centroid => ("centroid", mises(answer, place, |m| m.centroid)),
                MisesRead::IntegrationPoint => (
                    "integration point",
                    mises(answer, place, |m| m.integration_point),
                ),
                MisesRead::Nodal => ("nodal", mises(answer, place, |m| m.nodal)),
            };
            (format!("Mises, {name}, {}", units.stress), value, hertz)
        }
        ComparedMeasure::MaxPressure => {
            let at = |name: &str| place == "overall" || place == name;
            let pressures = answer.interfaces.0.iter().filter(|(name, _)| at(name));
            let value = pressures.map(|(_, i)| i.max_pressure).reduce(f64::max);
            let what = format!("peak pressure, {}", units.stress);
            (what, value, hertz.map(|h| h.peak_pressure))
        }
        ComparedMeasure::Descent => (format!("descent, {}", units.length), answer.descent, None),
    };
    let certified = certified(printed.what, read, place, answer);
    Comparison {
        what,
        place: place.to_owned(),
        report: Some(Reported::Value(printed.value)),
        value,
        error: certified.and_then(Figure::bar),
        resolved: certified.map(Figure::is_resolved),
        hertz,
        ..Comparison::default()
    }
}

/// The claim of the largest figure that is compared; of Mises peaks only the nodal one has one.
fn certified<'s>(
    what: ComparedMeasure,
    read: MisesRead,
    place: &str,
    answer: &'s Answer,
) -> Option<&'s Figure> {
    let what = match what {
        ComparedMeasure::Mises if read == MisesRead::Nodal => Quantity::PeakMises,
        ComparedMeasure::Mises => return None,
        ComparedMeasure::MaxPressure => Quantity::PeakPressure,
        ComparedMeasure::Descent => Quantity::Descent,
    };
    let claims = answer.certificate.iter();
    let meant = claims.filter(|c| c.what == what && means(place, &c.place));
    meant.max_by(|a, b| a.value.total_cmp(&b.value))
}

/// Is the body or interface `name` among what `place` means?
fn means(place: &str, name: &str) -> bool {
    match place {
        "overall" => true,
        "rollers" => name.contains("roller"),
        "plates" => name.contains("plate"),
        _ => name == place,
    }
}

/// Largest value over the bodies that `place` means.
fn mises(
    answer: &Answer,
    place: &str,
    read: impl Fn(&Three<Option<f64>>) -> Option<f64>,
) -> Option<f64> {
    let bodies = answer
        .bodies
        .0
        .iter()
        .filter(|(name, _)| means(place, name));
    bodies
        .filter_map(|(_, body)| read(&body.mises_max))
        .reduce(f64::max)
}

fn hertz_rows(hertz: &EvenlyLoaded, (answer, units): (&Answer, &UnitLabels)) -> Vec<Comparison> {
    let stress = &units.stress;
    let row = |what: &str, place: &str, value: Option<f64>, hertz: f64| Comparison {
        what: format!("{what}, {stress}"),
        place: place.to_owned(),
        value,
        hertz: Some(hertz),
        ..Comparison::default()
    };
    let pressures = answer.interfaces.0.iter().map(|(name, interface)| {
        let even = hertz.peak_pressure_of(name);
        let printed = row("peak pressure", name, Some(interface.max_pressure), even);
        let certified = certified(ComparedMeasure::MaxPressure, MisesRead::Nodal, name, answer);
        Comparison {
            error: certified.and_then(Figure::bar),
            resolved: certified.map(Figure::is_resolved),
            ..printed
        }
    });
    let bores = answer.rollers.0.iter().filter_map(|(name, roller)| {
        Some(row(
            "bore Mises",
            name,
            roller.bore_mises,
            hertz.bore_mises?,
        ))
    });
    pressures.chain(bores).collect()
}
