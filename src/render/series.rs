//! The VTK files of a run, increment by increment.

use std::path::PathBuf;

use super::fields;
use super::pvd::{Collection, Entry};
use crate::answer::results::recovery::Recovered;
use crate::ground::units::UnitLabels;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::OutputError;

/// Writes `<name>_0001.vtu`, `<name>_contact_0001.vtu`, ... and `<name>.pvd` into a folder.
///
/// The collection is rewritten after each increment, so that what an interrupted run leaves can
/// be opened.
#[derive(Debug, Clone)]
pub struct VtkSeries {
    folder: PathBuf,
    name: String,
    written: usize,
    collection: Collection,
    units: Option<UnitLabels>,
}

impl VtkSeries {
    /// A new series in `folder`; characters of `name` that file systems dislike become `_`.
    pub fn new(folder: impl Into<PathBuf>, name: &str) -> Self {
        let plain = |c: char| {
            if c.is_alphanumeric() || "-_.".contains(c) {
                c
            } else {
                '_'
            }
        };
        let (folder, name) = (folder.into(), name.chars().map(plain).collect::<String>());
        let collection = Collection::new(folder.join(format!("{name}.pvd")));
        Self {
            folder,
            name,
            written: 0,
            collection,
            units: None,
        }
    }

    /// The units of all arrays, which the files then say in their field data.
    pub fn in_units(mut self, units: UnitLabels) -> Self {
        self.units = Some(units);
        self
    }

    /// What its files are called by.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Goes on with the series of an earlier run after the increment `after` (its step, and share of
    /// that): later files leave the collection and are written over. Without an earlier collection
    /// the series is new.
    ///
    /// # Errors
    /// [`FileError::Read`] or [`OutputError::NotACollection`] for a collection of other make.
    pub fn resume(
        folder: impl Into<PathBuf>,
        name: &str,
        (step, time): (usize, f64),
    ) -> Result<Self, OutputError> {
        let mut series = Self::new(folder, name);
        if series.collection.path().exists() {
            series.collection = Collection::open(series.collection.path())?;
            series.collection.drop_after(step as f64 + time);
            series.written = series
                .collection
                .entries()
                .iter()
                .filter(|e| e.part == 0)
                .count();
        }
        Ok(series)
    }

    /// Writes the files of an increment and then the collection; returns the paths written.
    ///
    /// # Errors
    /// [`OutputError`] with the path that could not be written; the collection then still holds
    /// the increments before.
    pub fn write(
        &mut self,
        scene: &Scene,
        state: &State,
        recovered: &Recovered,
    ) -> Result<Vec<PathBuf>, OutputError> {
        let number = self.written + 1;
        let time = time_of(state);
        let mut collection = self.collection.clone();
        let mut paths = Vec::new();
        let bodies = (
            0,
            "bodies",
            "",
            Some(fields::bodies(scene, state, recovered)?),
        );
        let contacts = if scene.contacts.is_empty() {
            None
        } else {
            Some(fields::contacts(scene, state)?)
        };
        for (part, name, infix, grid) in [bodies, (1, "contact surfaces", "_contact", contacts)] {
            let Some(mut grid) = grid else { continue };
            if let Some(units) = &self.units {
                grid.names.push(fields::units(&grid, units));
            }
            let file = format!("{}{infix}_{number:04}.vtu", self.name);
            let path = self.folder.join(&file);
            grid.write(&path)?;
            collection.add(Entry {
                time,
                part,
                name: name.to_string(),
                file,
            });
            paths.push(path);
        }
        collection.write()?;
        paths.push(collection.path().to_path_buf());
        self.collection = collection;
        self.written = number;
        Ok(paths)
    }
}

/// Steps done so far.
fn time_of(state: &State) -> f64 {
    state.step as f64 + state.time
}
