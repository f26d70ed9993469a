//! Writes each accepted increment to disk while it passes the observer on.

use crate::case::Case;
use crate::output::Series;
use crate::results::State;
use crate::results::recovery::recover;
use crate::scene::Scene;
use crate::solve::{Iteration, Observer};
use std::path::Path;
use std::time::Instant;

pub struct Recorder<'o> {
    inner: &'o mut dyn Observer,
    series: Option<Series>,
    scene: Scene,
    seconds: f64,
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
            seconds: 0.0,
        }
    }

    /// Time spent on writing.
    pub fn seconds(&self) -> f64 {
        self.seconds
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
        let start = Instant::now();
        if let Some(series) = &mut self.series {
            series.write(&self.scene, state, &recover(&self.scene, state))?;
        }
        self.seconds += start.elapsed().as_secs_f64();
        self.inner.increment(state)
    }

    fn message(&mut self, text: &str) {
        self.inner.message(text);
    }

    fn cancelled(&self) -> bool {
        self.inner.cancelled()
    }
}
