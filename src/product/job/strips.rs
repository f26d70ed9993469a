//! Are the fine elements of a bearing's mesh where its lines of contact are? Asked of the preset
//! `auto`, whose first mesh rests on statics, as soon as an increment tells.

use super::error::JobError;
use super::mesh::strips_file;
use crate::analytic::hertz::{LineContact, widening_in_flow};
use crate::answer::results::contact_lines::contact_lines;
use crate::answer::results::line_frame::LineFrame;
use crate::answer::results::load::{applied, full};
use crate::case::bearing::{FoundLine, Preset, Strips};
use crate::case::{BearingCase, Case};
use crate::ground::file::write_text;
use crate::ground::geometry::norm;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::solver::solve::{Iteration, Observer, Restart};
use std::io::ErrorKind;
use std::path::Path;

/// Share of the full load from which a state tells how wide the lines are at full load. Under less of it a crowned roller
/// touches over a part of its length only, and what rounded ends carry has not flowed.
const TELLING_SHARE: f64 = 0.5;
/// Lines that carry less than this share of what the heaviest line of their pair carries are left
/// as they are.
const LIGHT: f64 = 0.05;
/// A half-width is believed as measured at full load where it has this many elements; else it is that of the load per
/// length, which takes none.
const MEASURED: f64 = 2.0;

/// The bearing of a case that is meshed by its lines of contact.
pub fn sized_by_lines(case: &Case) -> Option<&BearingCase> {
    (case.bearing()).filter(|bearing| bearing.mesh.preset == Preset::Auto)
}

/// The lines of contact in `state`, as wide as at full load: a little before that a strip is as wide as its
/// share of the load makes it; none long before.
fn lines(bearing: &BearingCase, scene: &Scene, state: &State) -> Vec<FoundLine> {
    let share = applied(scene, state) / norm(full(scene));
    if !(TELLING_SHARE..=1.0 + 1e-9).contains(&share) {
        return Vec::new();
    }
    let whole = share >= 1.0 - 1e-9;
    let mut found = Vec::new();
    for (index, pair) in scene.contacts.iter().enumerate() {
        let Some(seat) = bearing.seat(&pair.name) else {
            continue;
        };
        let frame = LineFrame::of_axis(scene, seat.axis);
        let lines = frame.map_or_else(Vec::new, |frame| contact_lines(scene, state, index, &frame));
        let peak =
            |line: &crate::answer::results::contact_line::ContactLine| line.peak().map(|p| p.0);
        let heaviest = lines.iter().filter_map(peak).fold(0.0, f64::max);
        for line in &lines {
            let Some(load) = peak(line).filter(|load| *load >= LIGHT * heaviest) else {
                continue;
            };
            let hertz = (scene.compliance(pair))
                .and_then(|compliance| LineContact::new(load / share, seat.radius, compliance));
            let Ok(hertz) = hertz else { continue };
            let row = &line.heaviest;
            let measured = whole && row.half_width >= MEASURED * row.edge_spacing();
            let half_width = match measured {
                true => row.half_width,
                false => {
                    hertz.half_width
                        * widening_in_flow(hertz.peak_pressure, scene.yield_stress(pair))
                }
            };
            found.push(FoundLine::on(&seat, line.across, half_width));
        }
    }
    found
}

/// How the mesh of `case` should be made instead, for the lines in `state`; `None` where it serves
/// them, or no other one is possible.
fn better(case: &Case, scene: &Scene, state: &State) -> Option<Strips> {
    let bearing = sized_by_lines(case)?;
    let lines = lines(bearing, scene, state);
    if bearing.mesh.unserved(bearing.layout(), &lines).is_empty() {
        return None;
    }
    let strips = Strips::found(bearing.geometry.diameter(), &lines)?;
    let mut other = bearing.clone();
    other.mesh.strips = Some(strips);
    let possible = other.mesh.check(other.layout()).is_ok();
    (possible && other.fingerprint() != bearing.fingerprint()).then_some(strips)
}

/// What a reader must know where the mesh does not serve every line, in words.
pub fn shortcoming(case: &Case, scene: &Scene, state: &State) -> Option<String> {
    let bearing = sized_by_lines(case)?;
    let lines = lines(bearing, scene, state);
    let unserved = bearing.mesh.unserved(bearing.layout(), &lines).len();
    (unserved > 0).then(|| {
        format!(
            "the mesh `auto` has fewer than three elements across the half-width, or coarser ones \
             within 1.3 of it, at {unserved} of {} lines of contact: their pressures rest on few nodes",
            lines.len()
        )
    })
}

/// Passes an observer on, and stops the run where the mesh does not serve the lines of contact.
pub struct Watch<'o> {
    inner: &'o mut dyn Observer,
    /// Case and scene, as long as the mesh may still be changed.
    watched: Option<(Case, Scene)>,
    better: Option<Strips>,
}

impl<'o> Watch<'o> {
    /// Looks at `case`, or at nothing.
    pub fn new(inner: &'o mut dyn Observer, case: Option<(&Case, &Scene)>) -> Self {
        Self {
            inner,
            watched: case.map(|(case, scene)| (case.clone(), scene.clone())),
            better: None,
        }
    }

    /// What the mesh is to be made for instead, where it does not serve.
    pub fn better(&self) -> Option<Strips> {
        self.better
    }
}

impl Observer for Watch<'_> {
    fn iteration(&mut self, iteration: &Iteration) {
        self.inner.iteration(iteration);
    }

    fn moved(&mut self, scene: &Scene) {
        if let Some((_, watched)) = &mut self.watched {
            watched.mesh.points.clone_from(&scene.mesh.points);
        }
        self.inner.moved(scene);
    }

    fn increment(&mut self, state: &State) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        if let Some((case, scene)) = &self.watched
            && self.better.is_none()
            && state.step <= scene.reported_step()
        {
            self.better = better(case, scene, state);
        }
        self.inner.increment(state)
    }

    fn checkpoint(
        &mut self,
        make: &dyn Fn() -> Restart,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.inner.checkpoint(make)
    }

    fn message(&mut self, text: &str) {
        self.inner.message(text);
    }

    fn cancelled(&self) -> bool {
        self.better.is_some() || self.inner.cancelled()
    }
}

/// Keeps what the second mesh is made for in the folder of a run, which may go on from there.
pub fn keep(strips: &Strips, out: &Path) -> Result<(), JobError> {
    let text = format!("{:e} {:e}\n", strips.narrowest, strips.widest);
    Ok(write_text(&strips_file(out), &text)?)
}

/// What an earlier run into `out` has kept.
pub fn kept(out: &Path) -> Result<Option<Strips>, JobError> {
    let text = match std::fs::read_to_string(strips_file(out)) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(JobError::folder(out, error)),
    };
    let numbers: Vec<f64> = (text.split_whitespace())
        .filter_map(|word| word.parse().ok())
        .collect();
    // A file that is damaged tells nothing; the checkpoint is then found to be of another mesh.
    Ok(match numbers[..] {
        [narrowest, widest] => Some(Strips {
            narrowest,
            widest,
            found: true,
        }),
        _ => None,
    })
}
