//! (2-49) on every line of contact, under the largest load per length that it carries.

use super::check::{LimitCheck, LimitKind};
use super::limits::Limits;
use super::standing::{SizeStanding, UNRESOLVED};
use crate::render::Summary;
use crate::render::summary::SizedLine;
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
    let error = share.map(|share| share * line.hertz_pressure);
    let mut remarks = Vec::new();
    let at_edge = line.from_end <= AT_THE_END * limits.radius;
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
        line_load: Some(line.peak_line_load),
        along: Some(line.at),
        value: Some(line.hertz_pressure),
        error,
        at_edge,
        limit: Some(limit),
        utilisation: Some(line.hertz_pressure / limit),
        standing: SizeStanding::of(line.hertz_pressure, error, limit),
        remark: (!remarks.is_empty()).then(|| remarks.join("; ")),
    }
}
