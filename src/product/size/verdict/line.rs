//! (2-49) on every line of contact, under the largest load per length that it carries.

use super::check::{LimitCheck, LimitKind};
use super::limits::Limits;
use super::standing::Standing;
use crate::answer::LineFigures;
use crate::render::Summary;
use crate::render::summary::SizedLine;

/// Nearer to the end of a roller than this share of its radius, a peak is made by the end.
const AT_THE_END: f64 = 0.02;

pub fn checks(limits: &Limits, summary: &Summary) -> Vec<LimitCheck> {
    let lines = summary.sizing.iter().flat_map(|sizing| &sizing.lines);
    lines.map(|line| check(limits, summary, line)).collect()
}

fn check(limits: &Limits, summary: &Summary, line: &SizedLine) -> LimitCheck {
    let limit = limits.pressure;
    let rows = summary.answer.interfaces.get(&line.interface);
    let rows = rows.and_then(|i| i.lines.iter().find(|l| l.across == line.across));
    // p0 goes with the root of the load per length.
    let error = rows.and_then(missed_between_rows);
    let error = error.map(|share| 0.5 * share * line.hertz_pressure);
    let mut remarks = Vec::new();
    let at_edge = line.from_end <= AT_THE_END * limits.radius;
    if at_edge {
        remarks.push("at the very end of the roller, which makes the peak: it belongs to the mesh");
    }
    if line.merged {
        remarks.push("both lines of the V in one: the mesh is too coarse to tell them apart");
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
        standing: Standing::of(line.hertz_pressure, error, limit),
        remark: (!remarks.is_empty()).then(|| remarks.join("; ")),
    }
}

/// What the rows of nodes may miss of the largest load per length, relative to it: how far the
/// parabola through the row of the peak and its neighbours bends away from straight pieces between
/// them. None at the end of a line, where there is one neighbour.
fn missed_between_rows(line: &LineFigures) -> Option<f64> {
    let peak = line.load.iter().position(|q| *q == line.peak)?;
    let mirrored = || (line.mirrored && line.at.get(peak) == Some(&0.0)).then_some(peak + 1);
    let before = peak.checked_sub(1).or_else(mirrored)?;
    let row = |i: usize| Some((*line.at.get(i)?, *line.load.get(i)?));
    let ((a, qa), (b, qb), (c, qc)) = (row(before)?, row(peak)?, row(peak + 1)?);
    let (left, right) = ((b - a).abs(), (c - b).abs());
    if !(left > 0.0 && right > 0.0 && qb > 0.0) {
        return None;
    }
    let curvature = 2.0 * ((qb - qa) / left + (qb - qc) / right) / (left + right);
    let widest = left.max(right);
    Some(curvature.abs() * widest * widest / 8.0 / qb)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(at: &[f64], load: &[f64], mirrored: bool) -> LineFigures {
        LineFigures {
            axis: "y",
            across: 0.0,
            images: 1,
            mirrored,
            at: at.to_vec(),
            load: load.to_vec(),
            peak: load.iter().copied().fold(0.0, f64::max),
            peak_at: 0.0,
            half_width: 0.1,
            mean: 1.0,
            length: 1.0,
            lifted_off: 0.0,
            relative_radius: None,
        }
    }

    /// q = 10 - x² on rows half a length apart: between rows a straight piece misses x²/8 · 2.
    #[test]
    fn a_parabola_is_missed_by_its_curvature() {
        let share = missed_between_rows(&line(&[-0.5, 0.0, 0.5], &[9.75, 10.0, 9.75], false));
        assert!((share.unwrap() - 2.0 * 0.25 / 8.0 / 10.0).abs() < 1e-12);
        let half = missed_between_rows(&line(&[0.0, 0.5, 1.0], &[10.0, 9.75, 9.0], true));
        assert_eq!(half, share);
        assert_eq!(
            missed_between_rows(&line(&[0.0, 0.5], &[9.0, 10.0], false)),
            None
        );
    }
}
