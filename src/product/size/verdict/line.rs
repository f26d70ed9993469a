//! (2-49) on every line of contact, under the largest load per length that it carries, away from rounded ends that the mesh does not resolve.

use super::check::{LimitCheck, LimitKind};
use super::limits::Limits;
use super::standing::{SizeStanding, UNRESOLVED};
use crate::answer::certify::Quantity;
use crate::render::Summary;
use crate::render::summary::SizedLine;
use crate::render::text::significant;
use std::f64::consts::FRAC_1_SQRT_2;

/// Nearer to the end of a roller than this share of its radius, a peak is made by the end.
const AT_THE_END: f64 = 0.02;

pub fn checks(limits: &Limits, summary: &Summary) -> Vec<LimitCheck> {
    let lines = summary.sizing.iter().flat_map(|sizing| &sizing.lines);
    lines.map(|line| check(limits, summary, line)).collect()
}

fn check(limits: &Limits, summary: &Summary, line: &SizedLine) -> LimitCheck {
    let limit = limits.pressure;
    let share = match line.merged {
        // Each of two lines in one carries half of the load at least.
        true => Some(1.0 - FRAC_1_SQRT_2),
        false => summary.answer.hertz_pressure_bar(&line.interface),
    };
    let at_all = line.hertz_pressure;
    let away = share.map_or_else(|| away(summary, line), |_| None);
    let (value, share) = away.map_or((at_all, share), |(value, share)| (value, Some(share)));
    // p0 goes with the root of the load.
    let line_load = line.peak_line_load * (value / at_all).powi(2);
    let error = share.map(|share| share * value);
    let mut remarks = Vec::new();
    let of_fillet = away.map(|_| {
        format!(
            "away from rounded ends; where a fillet begins it is {} on this mesh, which does not resolve it",
            significant(at_all, 3)
        )
    });
    remarks.extend(of_fillet.as_deref());
    let at_edge = away.is_none() && line.from_end <= AT_THE_END * limits.radius;
    if at_edge {
        remarks.push("at the very end of the roller, which makes the peak: it belongs to the mesh");
    }
    if line.merged {
        remarks.push("both lines of the V in one, which the mesh does not tell apart: p0 as if one line carried all");
    }
    if error.is_none() {
        remarks.push(UNRESOLVED);
    }
    LimitCheck {
        kind: LimitKind::ContactPressure,
        place: line.interface.clone(),
        across: Some(line.across),
        line_load: Some(line_load),
        along: away.is_none().then_some(line.at),
        value: Some(value),
        error,
        at_edge,
        limit: Some(limit),
        utilisation: Some(value / limit),
        standing: SizeStanding::of(value, error, limit),
        remark: (!remarks.is_empty()).then(|| remarks.join("; ")),
    }
}

/// p0 under the load away from where a fillet begins that the mesh does not resolve, and the share that it may be off by.
fn away(summary: &Summary, line: &SizedLine) -> Option<(f64, f64)> {
    let figure = |what| summary.answer.figure(what, &line.interface);
    let (at_all, away) = (figure(Quantity::LineLoad)?, figure(Quantity::LineLoadAway)?);
    let value = line.hertz_pressure * (away.value / at_all.value).sqrt();
    Some((value, 0.5 * away.relative_bar()?))
}
