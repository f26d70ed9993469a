//! What is read from each run of the study.

use crate::answer::certify::{Figure, Quantity};
use crate::answer::{BodyFigures, LineFigures, RollerFigures};
use crate::render::Summary;
use crate::render::summary::Demand;

/// A figure and, where the certificate has one, its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowReading {
    pub value: f64,
    pub error: Option<f64>,
}

/// A quantity: its name with its unit, and how to read it.
pub struct QuantityRow {
    pub name: &'static str,
    pub read: fn(&Summary) -> Option<RowReading>,
}

/// Interfaces of a roller with its flat plate and with its V; the other roller has the same.
const FLAT: &str = "upper_plate-upper_roller";
const VALLEY: &str = "upper_roller-intermediate_plate";

const fn row(name: &'static str, read: fn(&Summary) -> Option<RowReading>) -> QuantityRow {
    QuantityRow { name, read }
}

/// The quantities, in the order of their printing.
pub const ROWS: [QuantityRow; 26] = [
    row("Mises, centroid, overall, ksi", |s| mises(s, "", 0)),
    row("Mises, nodal, overall, ksi", |s| mises(s, "", 2)),
    row("Mises, centroid, rollers, ksi", |s| mises(s, "roller", 0)),
    row("Mises, nodal, rollers, ksi", |s| mises(s, "roller", 2)),
    row("Mises away from loaded edges, elastic, ksi", |s| {
        scaled(elastic(s), 1.0)
    }),
    row("largest plastic strain, %", |s| {
        scaled(largest(s, &[Quantity::PeakPlasticStrain]), 100.0).or(plain(Some(0.0)))
    }),
    row("yielded share of all volume, %", |s| {
        let sum = |of: fn(&BodyFigures) -> f64| {
            s.answer
                .bodies
                .0
                .iter()
                .map(|(_, body)| of(body))
                .sum::<f64>()
        };
        plain(Some(100.0 * sum(|b| b.yielded_volume) / sum(|b| b.volume)))
    }),
    row("descent, 1e-3 in", |s| {
        scaled(s.answer.figure(Quantity::Descent, "overall"), 1e3)
    }),
    row("stiffness, kip/in", |s| plain(s.answer.stiffness)),
    row("bore Mises, recovered, ksi", |s| {
        bore(s, |roller| roller.bore_mises)
    }),
    row("bore Mises, nodal, ksi", |s| {
        bore(s, |roller| roller.bore_mises_nodal)
    }),
    row("p0, flat side, ksi", |s| {
        read(s, Quantity::PeakPressure, FLAT)
    }),
    row("p0, V side, ksi", |s| {
        read(s, Quantity::PeakPressure, VALLEY)
    }),
    row("half-width, flat side, in", |s| {
        read(s, Quantity::HalfWidth, FLAT)
    }),
    row("contact area, flat side, in²", |s| {
        read(s, Quantity::ContactArea, FLAT)
    }),
    row("largest line load, flat side, kip/in", |s| {
        line(s, FLAT, |l| l.peak)
    }),
    row("largest line load, a V line, kip/in", |s| {
        line(s, VALLEY, |l| l.peak)
    }),
    row("in contact, flat side, in", |s| line(s, FLAT, |l| l.length)),
    row("lifted off, flat side, in", |s| {
        line(s, FLAT, |l| l.lifted_off)
    }),
    row("lifted off, V side, in", |s| {
        line(s, VALLEY, |l| l.lifted_off)
    }),
    row("p0 of the heaviest line over 1.65 yield, %", |s| {
        let lines = s.sizing.iter().flat_map(|sizing| &sizing.lines);
        let used = lines.filter_map(|line| line.utilisation);
        plain(used.reduce(f64::max).map(|share| 100.0 * share))
    }),
    row("D L over that of (2-50), printed constant", |s| {
        rule(s).and_then(|[printed, _]| provided(printed))
    }),
    row("D L over that of (2-50), exact constant", |s| {
        rule(s).and_then(|[_, exact]| provided(exact))
    }),
    row("dent in the plates, 1e-3 in", |s| dent(s, "plate")),
    row("dent in the rollers, 1e-3 in", |s| dent(s, "roller")),
    row("descent left after unloading, 1e-3 in", |s| {
        let left = s.answer.unloaded.as_ref().and_then(|u| u.descent);
        plain(left.map(|d| 1e3 * d))
    }),
];

fn plain(value: Option<f64>) -> Option<RowReading> {
    value.map(|value| RowReading { value, error: None })
}

/// A claim as it is.
fn read(summary: &Summary, what: Quantity, place: &str) -> Option<RowReading> {
    scaled(summary.answer.figure(what, place), 1.0)
}

/// A claim in a unit `scale` times as small.
fn scaled(claim: Option<&Figure>, scale: f64) -> Option<RowReading> {
    claim.map(|claim| RowReading {
        value: scale * claim.value,
        error: claim.bar().map(|error| scale * error),
    })
}

/// The largest of some claims.
fn largest<'s>(summary: &'s Summary, of: &[Quantity]) -> Option<&'s Figure> {
    let claims = summary.answer.certificate.iter();
    let asked = claims.filter(|c| of.contains(&c.what));
    asked.max_by(|a, b| a.value.total_cmp(&b.value))
}

/// The largest elastic Mises stress that no loaded edge makes.
fn elastic(summary: &Summary) -> Option<&Figure> {
    let yielded = largest(summary, &[Quantity::PeakPlasticStrain]).is_some();
    let names = match yielded {
        true => [Quantity::ElasticPeakMises, Quantity::ElasticMisesAway],
        false => [Quantity::PeakMises, Quantity::MisesAway],
    };
    let claims = summary.answer.certificate.iter();
    let regular = claims.filter(|c| names.contains(&c.what) && c.is_resolved());
    regular.max_by(|a, b| a.value.total_cmp(&b.value))
}

/// The largest Mises stress of the bodies whose names hold `part`, in reading `reading` of three.
fn mises(summary: &Summary, part: &str, reading: usize) -> Option<RowReading> {
    let bodies = summary
        .answer
        .bodies
        .0
        .iter()
        .filter(|(name, _)| name.contains(part));
    let values = bodies.filter_map(|(_, body)| body.mises_max.each()[reading]);
    plain(values.reduce(f64::max))
}

fn bore(summary: &Summary, read: fn(&RollerFigures) -> Option<f64>) -> Option<RowReading> {
    let values = summary.answer.rollers.0.iter().filter_map(|(_, r)| read(r));
    plain(values.reduce(f64::max))
}

/// Of the line that carries most per length.
fn line(summary: &Summary, interface: &str, read: fn(&LineFigures) -> f64) -> Option<RowReading> {
    let lines = summary.answer.interfaces.get(interface)?.lines.iter();
    let heaviest = lines.max_by(|a, b| a.peak.total_cmp(&b.peak));
    plain(heaviest.map(read))
}

/// The sizing rule with the printed constant and with the exact one.
fn rule(summary: &Summary) -> Option<[&Demand; 2]> {
    let rule = summary.sizing.as_ref()?.rule.as_ref()?;
    Some([&rule.printed, &rule.exact])
}

fn provided(demand: &Demand) -> Option<RowReading> {
    plain(Some(
        demand.provided / demand.required_diameter_times_length,
    ))
}

fn dent(summary: &Summary, part: &str) -> Option<RowReading> {
    let dents = summary.answer.unloaded.as_ref()?.dents.0.iter();
    let depths = dents
        .filter(|(_, d)| d.body.contains(part))
        .map(|(_, d)| 1e3 * d.depth);
    plain(depths.reduce(f64::max))
}
