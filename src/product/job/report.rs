//! The page of a run.

use super::calculation::calculation;
use super::error::JobError;
use super::limits;
use crate::answer::pictures::Pictures;
use crate::answer::results::recovery::Recovered;
use crate::case::Case;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::Summary;
use crate::render::report::history::Iterate;
use crate::render::report::{self, Inputs};
use std::path::Path;
use std::time::Instant;

/// Writes the page into the folder `out`, and says how large it is and how long that took.
pub fn write(
    case: &Case,
    (summary, scene, state, recovered): (&Summary, &Scene, &State, &Recovered),
    history: &[Iterate],
    out: &Path,
) -> Result<String, JobError> {
    let start = Instant::now();
    let pictures = Pictures::of(scene, state, recovered, &summary.answer);
    let bytes = report::write(
        &Inputs {
            summary,
            scene,
            state,
            recovered,
            pictures: &pictures,
            calculation: &calculation(case, scene),
            history,
            missed: &limits::missed(case, &summary.answer),
            case: (case.source.name(), case.source.text()),
            setting: &[(
                "threads".to_owned(),
                rayon::current_num_threads().to_string(),
            )],
        },
        &out.join(report::FILE),
    )?;
    let seconds = start.elapsed().as_secs_f64();
    let share = 100.0 * seconds / (seconds + summary.timing.total_s);
    let megabytes = 1e-6 * bytes as f64;
    let page = report::FILE;
    Ok(format!(
        "{page}: {megabytes:.1} MB, written in {seconds:.2} s, {share:.1} % of the time"
    ))
}
