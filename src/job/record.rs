//! Writes each accepted increment to disk, and what a run can go on from, and keeps the history of
//! the iterations, while it passes the observer on.

use super::JobError;
use super::checkpoint::Checkpoint;
use super::clock::{Clock, Spent};
use crate::case::Case;
use crate::output::report::history::Iterate;
use crate::output::{Series, UnitLabels, paraview};
use crate::results::State;
use crate::results::recovery::recover;
use crate::scene::Scene;
use crate::solve::{Iteration, Observer, Restart};
use std::path::Path;

pub struct Recorder<'o> {
    inner: &'o mut dyn Observer,
    files: Option<(Series, Checkpoint)>,
    scene: Scene,
    spent: Spent,
    history: Vec<Iterate>,
}

impl<'o> Recorder<'o> {
    /// Writes the VTK files of `case` and its checkpoints into the folder of `files`, after those of
    /// an earlier run that goes on from `restart`.
    ///
    /// # Errors
    /// Where the earlier run's collection cannot be read, or the file of views not be written.
    pub fn new(
        case: &Case,
        files: Option<(&Path, Checkpoint)>,
        restart: Option<&Restart>,
        scene: Scene,
        inner: &'o mut dyn Observer,
    ) -> Result<Self, JobError> {
        let path = Path::new(case.source.name());
        let stem = path
            .file_stem()
            .map_or("case".into(), |s| s.to_string_lossy());
        let series = |out| match restart {
            Some(restart) => Series::resume(out, &stem, restart.after()),
            None => Ok(Series::new(out, &stem)),
        };
        let files = files.map(|(out, checkpoint)| {
            let series = series(out)?;
            let units = UnitLabels::of(case.units);
            paraview::write(out, series.name(), &case.title, &units, &scene)?;
            Ok::<_, JobError>((series, checkpoint))
        });
        Ok(Self {
            files: files.transpose()?,
            inner,
            scene,
            spent: Spent {
                cpu_s: Some(0.0),
                ..Spent::default()
            },
            history: Vec::new(),
        })
    }

    /// Spent on writing.
    pub fn spent(&self) -> Spent {
        self.spent
    }

    /// What the iterations told.
    pub fn into_history(self) -> Vec<Iterate> {
        self.history
    }
}

impl Observer for Recorder<'_> {
    fn iteration(&mut self, iteration: &Iteration) {
        self.history.push(iterate(iteration));
        self.inner.iteration(iteration);
    }

    fn moved(&mut self, scene: &Scene) {
        self.scene.mesh.points.clone_from(&scene.mesh.points);
        self.inner.moved(scene);
    }

    fn increment(&mut self, state: &State) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        let clock = Clock::start();
        if let Some((series, _)) = &mut self.files {
            series.write(&self.scene, state, &recover(&self.scene, state))?;
        }
        self.spent = self.spent.plus(clock.spent());
        self.inner.increment(state)
    }

    fn checkpoint(
        &mut self,
        make: &dyn Fn() -> Restart,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        let clock = Clock::start();
        if let Some((_, checkpoint)) = &self.files {
            checkpoint.write(&make())?;
        }
        self.spent = self.spent.plus(clock.spent());
        Ok(())
    }

    fn message(&mut self, text: &str) {
        self.inner.message(text);
    }

    fn cancelled(&self) -> bool {
        self.inner.cancelled()
    }
}

fn iterate(i: &Iteration) -> Iterate {
    Iterate {
        load: i.step as f64 + i.time,
        iteration: i.iteration,
        residual: i.residual,
        energy: i.energy,
        active: i.active,
        sticking: i.sticking,
        slipping: i.slipping,
        changed: i.changed,
        violation: i.penetration,
        flowing: i.flowing,
        directions: i.directions,
        refactored: i.refactored,
        line_search: i.line_search,
    }
}
