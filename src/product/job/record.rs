//! Writes each accepted increment to disk, and what a run can go on from, and keeps the history of
//! the iterations, while it passes the observer on.

use super::checkpoint::Checkpoint;
use super::clock::{Clock, Spent};
use super::error::JobError;
use super::files::forget;
use super::folder;
use super::mesh::STRIPS;
use super::saving::Saving;
use crate::answer::results::load::upward;
use crate::answer::results::recovery::recover;
use crate::case::Case;
use crate::ground::units::UnitLabels;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::report::history::Iterate;
use crate::render::{VtkSeries, paraview};
use crate::solver::solve::{Iteration, Observer, Restart};
use std::path::{Path, PathBuf};

/// What a run writes increment by increment.
struct Files {
    folder: PathBuf,
    series: VtkSeries,
    saving: Saving,
    /// What an earlier run left is there as long as nothing of this one is.
    earlier: Option<Earlier>,
    title: String,
    units: UnitLabels,
}

/// What is done about an earlier run.
struct Earlier {
    /// Does this one go on from it?
    resumed: bool,
    /// Is this its second mesh, or one that goes on with that?
    strips: bool,
}

impl Files {
    fn write(&mut self, scene: &Scene, state: &State) -> Result<(), JobError> {
        if let Some(earlier) = self.earlier.take() {
            folder::clear(&self.folder, earlier.resumed)?;
            if !earlier.resumed && !earlier.strips {
                forget(&self.folder.join(STRIPS))?;
            }
            self.write_views(scene, scene.reported_step())?;
        }
        (self.series).write(scene, state, &recover(scene, state))?;
        Ok(())
    }

    fn write_views(&self, scene: &Scene, reported: usize) -> Result<(), JobError> {
        let (name, title, up) = (self.series.name(), &self.title, upward(scene));
        paraview::write(&self.folder, name, title, &self.units, scene, reported, up)?;
        Ok(())
    }
}

pub struct Recorder<'o> {
    inner: &'o mut dyn Observer,
    files: Option<Files>,
    scene: Scene,
    spent: Spent,
    history: Vec<Iterate>,
}

impl<'o> Recorder<'o> {
    /// Writes the VTK files of `case` and its checkpoints into the folder of `files`, after those of
    /// an earlier run that goes on from `restart`.
    ///
    /// # Errors
    /// Where the earlier run's collection cannot be read.
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
            Some(restart) => VtkSeries::resume(out, &stem, restart.after()),
            None => Ok(VtkSeries::new(out, &stem)),
        };
        let strips = case.bearing().and_then(|bearing| bearing.mesh.strips);
        let strips = strips.is_some_and(|strips| strips.found);
        let files = files.map(|(out, checkpoint)| {
            Ok::<_, JobError>(Files {
                folder: out.to_owned(),
                series: series(out)?.in_units(UnitLabels::of(case.units)),
                saving: Saving::new(checkpoint),
                earlier: Some(Earlier {
                    resumed: restart.is_some(),
                    strips,
                }),
                title: case.title.clone(),
                units: UnitLabels::of(case.units),
            })
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

    /// Writes the checkpoint of the last increment, where it is not there yet.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn save(&mut self) -> Result<(), JobError> {
        let clock = Clock::start();
        if let Some(files) = &mut self.files {
            files.saving.write()?;
        }
        self.spent = self.spent.plus(clock.spent());
        Ok(())
    }

    /// Spent on writing.
    pub fn spent(&self) -> Spent {
        self.spent
    }

    /// What the iterations told; `reported` is the step that the figures of all steps are of, where they are done. Whether
    /// a motion that goes back takes the load off is known only now.
    ///
    /// # Errors
    /// Where the views cannot be written anew.
    pub fn finish(self, reported: Option<usize>) -> Result<Vec<Iterate>, JobError> {
        let other = reported.filter(|step| *step != self.scene.reported_step());
        let written = self.files.filter(|files| files.earlier.is_none());
        if let (Some(files), Some(step)) = (written, other) {
            files.write_views(&self.scene, step)?;
        }
        Ok(self.history)
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
        if let Some(files) = &mut self.files {
            files.write(&self.scene, state)?;
        }
        self.spent = self.spent.plus(clock.spent());
        self.inner.increment(state)
    }

    fn checkpoint(
        &mut self,
        make: &dyn Fn() -> Restart,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        let clock = Clock::start();
        if let Some(files) = &mut self.files {
            files.saving.take(make())?;
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
