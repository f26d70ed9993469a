//! A bearing, solved on one mesh, and what is claimed of it.

use crate::case::Case;
use crate::converge::cost::Meter;
use crate::job::{self, JobError, Options, Outcome};
use crate::output::Summary;
use crate::results::contact_lines::contact_lines;
use crate::results::line_load::Slices;
use crate::solve::Observer;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A claim, as a reader of `summary.json` finds it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Reading {
    /// Such as `peak_mises`.
    pub what: String,
    #[serde(rename = "where")]
    pub place: String,
    pub value: f64,
    /// Half the length of the bar; none where the figure is not resolved.
    pub bar: Option<f64>,
    pub note: Option<String>,
    /// A figure of the summary that nothing is claimed of.
    #[serde(default)]
    pub unclaimed: bool,
}

/// How the line of an interface that carries most is meshed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Strip {
    pub half_width: f64,
    /// Mean distance of its nodes.
    pub spacing: f64,
    /// Largest load per length, and how far that is from the end of the line.
    pub line_load: f64,
    pub from_end: f64,
    /// Lines of the interface.
    pub lines: usize,
}

/// What came of a solution.
#[derive(Debug, Clone)]
pub struct Solved {
    pub readings: Vec<Reading>,
    /// By interface.
    pub strips: BTreeMap<String, Strip>,
    /// Largest plastic strain of every body.
    pub flow: BTreeMap<String, f64>,
    pub unknowns: usize,
    pub cpu_s: f64,
}

/// Where solutions are kept, and whether those that are there are read again.
#[derive(Debug, Clone, Default)]
pub struct Keep {
    pub folder: Option<PathBuf>,
    pub resume: bool,
}

impl Keep {
    fn options(&self, name: &str, elastic_peaks: bool) -> Options {
        let out = self.folder.as_ref().map(|folder| folder.join(name));
        let kept = out.as_deref().is_some_and(job::has_checkpoint);
        Options {
            resume: self.resume && kept,
            out,
            elastic_peaks,
            report: false,
        }
    }
}

/// Solves `case`; `name` is that of its folder where solutions are kept.
///
/// # Errors
/// As [`job::run`], and [`JobError::Interrupted`] where the observer wanted to stop.
pub fn solve(
    case: &Case,
    (keep, name): (&Keep, &str),
    elastic_peaks: bool,
    observer: &mut dyn Observer,
) -> Result<Solved, JobError> {
    let meter = Meter::start();
    let options = keep.options(name, elastic_peaks);
    let run = match job::run(case, &options, observer) {
        // What is kept belongs to another mesh, or another version of the program.
        Err(JobError::Checkpoint { .. }) => {
            let anew = Options {
                resume: false,
                ..options.clone()
            };
            job::run(case, &anew, observer)
        }
        run => run,
    };
    if let Some(out) = &options.out {
        remove_fields(out);
    }
    let outcome = run?;
    if outcome.interrupted {
        return Err(JobError::Interrupted);
    }
    let summary = &outcome.summary;
    Ok(Solved {
        readings: readings(summary),
        strips: strips(&outcome),
        flow: (summary.bodies.0.iter())
            .map(|(name, body)| (name.clone(), body.peeq_max))
            .collect(),
        unknowns: summary.dofs,
        cpu_s: meter.stop().cpu_s,
    })
}

/// Fields are large, and nothing here looks at them. What cannot be removed harms nobody.
fn remove_fields(folder: &Path) {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let fields = files.filter(|file| file.path().extension().is_some_and(|e| e == "vtu"));
    for file in fields {
        let _ = std::fs::remove_file(file.path());
    }
}

/// The claims of a summary. Peaks at loaded edges belong to their mesh and are none.
fn readings(summary: &Summary) -> Vec<Reading> {
    let Ok(Value::Array(claims)) = serde_json::to_value(&summary.certificate) else {
        return Vec::new();
    };
    let mut readings: Vec<Reading> = claims.iter().filter_map(reading).collect();
    for other in others(summary) {
        let same = |r: &Reading| r.what == other.what && r.place == other.place;
        if !readings.iter().any(same) {
            readings.push(other);
        }
    }
    readings
}

/// Figures that are no claims, or not yet.
fn others(summary: &Summary) -> Vec<Reading> {
    let reading = |what: &str, place: &str, value: Option<f64>| {
        Some(Reading {
            what: what.to_owned(),
            place: place.to_owned(),
            value: value?,
            bar: None,
            note: None,
            unclaimed: true,
        })
    };
    let mut list = Vec::new();
    for (name, interface) in &summary.interfaces.0 {
        let lines = &interface.lines;
        let heaviest = lines.iter().map(|line| line.peak).reduce(f64::max);
        let length = lines.iter().map(|line| line.length * line.images as f64);
        let length = (!lines.is_empty()).then(|| length.sum());
        list.push(reading("line_load", name, heaviest));
        list.push(reading("contact_length", name, length));
        let [x, y, _] = interface.force;
        list.push(reading("horizontal_force", name, Some(x.hypot(y))));
    }
    for (name, roller) in &summary.rollers.0 {
        list.push(reading("bore_mises", name, roller.bore_mises));
        list.push(reading("bore_mises_nodal", name, roller.bore_mises_nodal));
    }
    let dents = summary.unloaded.iter().flat_map(|u| &u.dents.0);
    list.extend(dents.map(|(name, dent)| reading("dent", name, Some(dent.depth))));
    list.into_iter().flatten().collect()
}

fn reading(claim: &Value) -> Option<Reading> {
    let text = |key: &str| claim.get(key).and_then(Value::as_str).map(str::to_owned);
    let note = text("note");
    let singular = note.as_deref().is_some_and(|n| n.contains("singular"));
    let resolved = claim.get("resolved").and_then(Value::as_bool) != Some(false);
    (!singular).then_some(())?;
    Some(Reading {
        what: text("what")?,
        place: text("where")?,
        value: claim.get("value")?.as_f64()?,
        bar: claim.get("error").filter(|_| resolved).and_then(total),
        note,
        unclaimed: false,
    })
}

/// An error, or the sum of its causes; that of the mesh must be known.
fn total(error: &Value) -> Option<f64> {
    let Some(causes) = error.as_object() else {
        return error.as_f64();
    };
    causes.get("discretisation")?.as_f64()?;
    Some(causes.values().filter_map(Value::as_f64).sum())
}

fn strips(outcome: &Outcome) -> BTreeMap<String, Strip> {
    let (scene, state) = (&outcome.scene, outcome.state());
    let pairs = outcome.summary.interfaces.0.iter().enumerate();
    let strip = |pair: usize| {
        let axis = Slices::equal(scene, pair, 1)?.axis;
        let lines = contact_lines(scene, state, pair, axis);
        let loaded = lines.iter().filter_map(|line| Some((line.peak()?, line)));
        let ((load, at), line) = loaded.max_by(|a, b| a.0.0.total_cmp(&b.0.0))?;
        let mirrored = scene.mirrors.contains(&axis);
        let to = |end: Option<&f64>| end.map_or(f64::INFINITY, |end| (end - at).abs());
        let (first, last) = (to(line.at.first()), to(line.at.last()));
        Some(Strip {
            half_width: line.heaviest.half_width,
            spacing: line.heaviest.edge_spacing(),
            line_load: load,
            // At a mirror plane the line goes on.
            from_end: if mirrored {
                first.max(last)
            } else {
                first.min(last)
            },
            lines: lines.iter().map(|line| line.images).sum(),
        })
    };
    pairs
        .filter_map(|(pair, (name, _))| Some((name.clone(), strip(pair)?)))
        .collect()
}
