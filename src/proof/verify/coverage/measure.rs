//! Claims of ordinary runs beside true values.

use super::bearing::Bearing;
use super::pair::Truth;
use super::reference::Stored;
use super::solution::{self, ClaimReading, Keep, SolvedBearing, StripMesh};
use crate::product::job::JobError;
use crate::solver::solve::Observer;
use serde::Serialize;
use std::collections::BTreeMap;

/// Is what is claimed true?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum BarVerdict {
    /// The bar, and the uncertainty of the true value beside it, hold that value.
    Holds,
    Missed,
    /// The true value is not known well enough: its uncertainty exceeds a third of the bar.
    Undecidable,
    /// The claim says itself that it is not resolved.
    Unresolved,
    /// There are no true values of the bearing: other meshes may still exclude the claim.
    Unknown,
}

/// A claim of a run and the truth about it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ClaimRecord {
    pub bearing: String,
    pub preset: String,
    pub elastic: bool,
    #[serde(flatten)]
    pub reading: ClaimReading,
    #[serde(flatten)]
    pub truth: Option<Truth>,
    pub verdict: BarVerdict,
    /// Are there true values of the bearing?
    pub compared: bool,
    /// The mesh at the interface, or at those of the body that carry most.
    pub strip: Option<StripMesh>,
    pub unknowns: usize,
    pub cpu_s: f64,
}

impl ClaimRecord {
    /// Of the value, relative to the true one.
    pub fn error(&self) -> Option<f64> {
        let truth = self.truth.filter(|t| t.value != 0.0)?;
        Some(((self.reading.value - truth.value) / truth.value).abs())
    }

    /// The bar, relative to the true value.
    pub fn bar(&self) -> Option<f64> {
        let truth = self.truth.filter(|t| t.value != 0.0)?;
        Some(self.reading.bar? / truth.value.abs())
    }
}

/// What an ordinary run claims, judged.
pub struct JudgedRun {
    pub records: Vec<ClaimRecord>,
    /// See [`SolvedBearing`].
    pub beyond_limits: Vec<String>,
}

/// A claim holds if the value is within bar and uncertainty of the true one; beyond both it is missed, however uncertain the
/// true one is.
pub fn judge(reading: &ClaimReading, truth: Option<Truth>) -> BarVerdict {
    let Some(bar) = reading.bar else {
        return BarVerdict::Unresolved;
    };
    match truth {
        Some(truth) if (reading.value - truth.value).abs() > bar + truth.uncertainty => {
            BarVerdict::Missed
        }
        Some(truth) if truth.uncertainty <= bar / 3.0 => BarVerdict::Holds,
        _ => BarVerdict::Undecidable,
    }
}

/// Solves `bearing` on `preset`, elastic or as drawn, and judges what it claims by what is `stored` of it.
///
/// # Errors
/// [`JobError`].
pub fn measure(
    bearing: &Bearing,
    preset: &str,
    elastic: bool,
    (stored, scatter): (Option<&Stored>, &BTreeMap<String, f64>),
    keep: &Keep,
    observer: &mut dyn Observer,
) -> Result<JudgedRun, JobError> {
    let mut case = if elastic {
        bearing.twin()?
    } else {
        bearing.case()?
    };
    case.set_preset(preset)?;
    let steel = if elastic { "elastic" } else { "own" };
    let name = format!("{}/{preset}-{steel}", bearing.name);
    let solved = solution::solve(&case, (keep, &name), true, observer)?;
    let record = |reading: &ClaimReading| {
        let of = |reading: &ClaimReading| truth(reading, elastic, stored?, scatter);
        let truth = of(reading).or_else(|| by_load(reading, &solved.readings, of));
        let verdict = match judge(reading, truth) {
            BarVerdict::Undecidable if stored.is_none() => BarVerdict::Unknown,
            verdict => verdict,
        };
        ClaimRecord {
            bearing: bearing.name.clone(),
            preset: preset.to_owned(),
            elastic,
            verdict,
            compared: stored.is_some(),
            reading: reading.clone(),
            truth,
            strip: strip(&solved, &reading.place),
            unknowns: solved.unknowns,
            cpu_s: solved.cpu_s,
        }
    };
    Ok(JudgedRun {
        records: solved.readings.iter().map(record).collect(),
        beyond_limits: solved.beyond_limits,
    })
}

/// The true value of what `reading` is about. Elastic peaks of a run that yields are those of the twin;
/// where no Mises peak is at a loaded edge, that away from edges is the peak. Of pressures that would be another
/// figure: fine meshes may show a peak at a fillet that coarse ones leave out.
fn truth(
    reading: &ClaimReading,
    elastic: bool,
    stored: &Stored,
    scatter: &BTreeMap<String, f64>,
) -> Option<Truth> {
    let (what, pair) = match reading.what.strip_prefix("elastic_") {
        Some(what) => (what, &stored.elastic),
        None if elastic => (reading.what.as_str(), &stored.elastic),
        None => (reading.what.as_str(), &stored.own),
    };
    let of = |what: &str| pair.as_ref()?.truth(what, &reading.place, scatter);
    match what {
        "mises_away" => of(what).or_else(|| of("peak_mises")),
        _ => of(what),
    }
}

/// The true value of Hertz's pressure, which goes with the root of the line load.
fn by_load(
    reading: &ClaimReading,
    readings: &[ClaimReading],
    truth: impl Fn(&ClaimReading) -> Option<Truth>,
) -> Option<Truth> {
    if reading.what != "hertz_pressure" {
        return None;
    }
    let at = |r: &&ClaimReading| r.what == "line_load" && r.place == reading.place;
    let load = readings.iter().find(at)?;
    let of_load = truth(load)?;
    let value = reading.value * (of_load.value / load.value).sqrt();
    Some(Truth {
        value,
        uncertainty: 0.5 * value * of_load.uncertainty / of_load.value,
    })
}

fn strip(solved: &SolvedBearing, place: &str) -> Option<StripMesh> {
    let touches = |name: &str| name == place || name.split('-').any(|body| body == place);
    let strips = (solved.strips.iter()).filter(|(name, _)| touches(name));
    let heaviest = strips.max_by(|a, b| a.1.line_load.total_cmp(&b.1.line_load));
    heaviest.map(|(_, strip)| *strip)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bar plus uncertainty, the latter at most a third of the bar.
    #[test]
    fn claims_are_judged() {
        let reading = |bar| ClaimReading {
            what: "descent".into(),
            place: "overall".into(),
            value: 10.0,
            bar,
            note: None,
        };
        let truth = |value, uncertainty| Some(Truth { value, uncertainty });
        let judged = |bar, truth| judge(&reading(bar), truth);
        assert_eq!(judged(Some(0.9), truth(11.1, 0.3)), BarVerdict::Holds);
        assert_eq!(judged(Some(0.9), truth(11.3, 0.3)), BarVerdict::Missed);
        assert_eq!(
            judged(Some(0.9), truth(10.0, 0.31)),
            BarVerdict::Undecidable
        );
        assert_eq!(judged(Some(0.9), None), BarVerdict::Undecidable);
        assert_eq!(judged(None, truth(10.0, 0.0)), BarVerdict::Unresolved);
    }
}
