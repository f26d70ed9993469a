//! Writes each accepted increment to disk while it passes the observer on.

use super::clock::{Clock, Spent};
use crate::case::Case;
use crate::output::Series;
use crate::results::State;
use crate::results::recovery::recover;
use crate::scene::Scene;
use crate::solve::{Iteration, Observer};
use std::path::Path;

pub struct Recorder<'o> {
    inner: &'o mut dyn Observer,
    series: Option<Series>,
    scene: Scene,
    spent: Spent,
}

impl<'o> Recorder<'o> {
    pub fn new(case: &Case, out: Option<&Path>, scene: Scene, inner: &'o mut dyn Observer) -> Self {
        let path = Path::new(case.source.name());
        let stem = path
            .file_stem()
            .map_or("case".into(), |s| s.to_string_lossy());
        Self {
            series: out.map(|out| Series::new(out, &stem)),
            inner,
            scene,
            spent: Spent {
                cpu_s: Some(0.0),
                ..Spent::default()
            },
        }
    }

    /// Spent on writing.
    pub fn spent(&self) -> Spent {
        self.spent
    }
}

impl Observer for Recorder<'_> {
    fn iteration(&mut self, iteration: &Iteration) {
        self.inner.iteration(iteration);
    }

    fn moved(&mut self, scene: &Scene) {
        self.scene.mesh.points.clone_from(&scene.mesh.points);
        self.inner.moved(scene);
    }

    fn increment(&mut self, state: &State) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        let clock = Clock::start();
        if let Some(series) = &mut self.series {
            series.write(&self.scene, state, &recover(&self.scene, state))?;
        }
        self.spent = self.spent.plus(clock.spent());
        self.inner.increment(state)
    }

    fn message(&mut self, text: &str) {
        self.inner.message(text);
    }

    fn cancelled(&self) -> bool {
        self.inner.cancelled()
    }
}
