//! Where a job writes and what it may leave out.

use super::error::JobError;
use super::folder::Folder;
use std::path::PathBuf;

/// Where a job writes and what it may leave out.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Folder of the VTK files and `summary.json`; `None` writes nothing.
    pub out: Option<PathBuf>,
    /// Solve once more without plasticity where a body has yielded, for the elastic peaks.
    pub elastic_peaks: bool,
    /// Go on after the last increment of an earlier run of the same scene into the same folder.
    pub resume: bool,
    /// Write `report.html` beside the summary.
    pub report: bool,
}

impl Options {
    /// The folder to write into, this job's alone from now on.
    pub(in crate::product) fn open(&self) -> Result<Option<Folder>, JobError> {
        let out = self.out.as_deref();
        out.map(Folder::open).transpose()
    }
}
