//! A bearing, solved on one mesh, and what is claimed of it.

use crate::answer::certify::{Figure, is_replaced};
use crate::answer::results::edges::LoadedEdges;
use crate::answer::results::hertz::{Departure, HeaviestLine};
use crate::answer::results::line_frame::is_mirrored;
use crate::case::Case;
use crate::product::converge::cost::Meter;
use crate::product::job::{self, JobError, Options, Outcome};
use crate::render::Summary;
use crate::solver::solve::Observer;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A claim, as `summary.json` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ClaimReading {
    /// Such as `peak_mises`.
    pub what: String,
    #[serde(rename = "where")]
    pub place: String,
    pub value: f64,
    /// Half the length of the bar; none where the figure is not resolved.
    pub bar: Option<f64>,
    pub note: Option<String>,
}

/// How the line of an interface that carries most is meshed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct StripMesh {
    pub half_width: f64,
    /// Distance of its nodes in its middle, and of the last one that presses from the first open one.
    pub middle: f64,
    pub edge: f64,
    /// Largest load per length, and how far that is from the end of the line.
    pub line_load: f64,
    pub from_end: f64,
    /// Does it carry most at a loaded edge, or merge with the line beside it? Then no load per length is Hertz's.
    pub no_hertz: bool,
}

/// What came of a solution.
#[derive(Debug, Clone)]
pub struct SolvedBearing {
    pub readings: Vec<ClaimReading>,
    /// By interface.
    pub strips: BTreeMap<String, StripMesh>,
    /// Largest plastic strain of every body.
    pub flow: BTreeMap<String, f64>,
    /// That of the nodes.
    pub descent_of_mesh: Option<f64>,
    /// Limits of every run that it does not keep to, in words.
    pub beyond_limits: Vec<String>,
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
) -> Result<SolvedBearing, JobError> {
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
    Ok(SolvedBearing {
        readings: readings(summary),
        strips: strips(&outcome),
        flow: (summary.answer.bodies.0.iter())
            .map(|(name, body)| (name.clone(), body.peeq_max))
            .collect(),
        beyond_limits: outcome.missed_limits(case),
        descent_of_mesh: summary.answer.descent_of_mesh,
        unknowns: summary.counters.dofs,
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

/// The claims of a summary. A peak at a loaded edge has no limit, and is none where another stands in
/// its place.
fn readings(summary: &Summary) -> Vec<ClaimReading> {
    let claims = &summary.answer.certificate;
    let stand = claims.iter().filter(|claim| !is_replaced(claims, claim));
    stand.filter_map(reading).collect()
}

fn reading(claim: &Figure) -> Option<ClaimReading> {
    Some(ClaimReading {
        what: serde_json::to_value(claim.what).ok()?.as_str()?.to_owned(),
        place: claim.place.clone(),
        value: claim.value,
        bar: claim.bar(),
        note: claim.note.map(str::to_owned),
    })
}

fn strips(outcome: &Outcome) -> BTreeMap<String, StripMesh> {
    let (scene, state) = (&outcome.scene, outcome.state());
    let pairs = outcome.summary.answer.interfaces.0.iter().enumerate();
    let edges = LoadedEdges::find(scene, state);
    let strip = |pair: usize| {
        let heaviest = HeaviestLine::find(scene, state, pair, &edges)?;
        let (frame, line) = (&heaviest.frame, &heaviest.line);
        let at = line.heaviest.at;
        let mirrored = is_mirrored(&frame.along, &scene.mirrors);
        let to = |end: Option<&f64>| end.map_or(f64::INFINITY, |end| (end - at).abs());
        let (first, last) = (to(line.at.first()), to(line.at.last()));
        Some(StripMesh {
            half_width: line.heaviest.half_width,
            middle: line.heaviest.middle_spacing(),
            edge: line.heaviest.edge_spacing(),
            line_load: heaviest.line_load,
            // At a mirror plane the line goes on.
            from_end: if mirrored {
                first.max(last)
            } else {
                first.min(last)
            },
            no_hertz: matches!(
                heaviest.departs,
                Some(Departure::LoadedEdge | Departure::Width)
            ),
        })
    };
    pairs
        .filter_map(|(pair, (name, _))| Some((name.clone(), strip(pair)?)))
        .collect()
}
