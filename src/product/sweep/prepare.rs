//! What a row needs before it runs: its folder, its mesh, and how much memory it will take.

use super::place::SweepFolder;
use super::rows::{Sweep, SweepRow};
use crate::ground::file::write_text;
use crate::product::job::{self, JobError, MESH_FILE};
use std::path::Path;

/// The case file of a row, in its folder.
pub const CASE: &str = "case.toml";

/// What a row will take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Need {
    pub unknowns: usize,
    /// Bytes.
    pub memory: f64,
}

/// Bytes of a run beside its model: program, mesh, fields and what is written.
const MEMORY_BESIDE_MODEL: f64 = 40e6;
/// The estimate is that of the first model; where steel flows or contact widens, larger ones follow.
/// Largest resident memory over it: 1.2 at 25 and 1.6 at 36 thousand unknowns, with plastic flow.
const MEMORY_GROWTH: f64 = 1.5;

/// Writes the case of `row` and puts its mesh beside it. Rows with the same mesh share one, made once
/// by gmsh where none is at hand.
///
/// # Errors
/// [`JobError`] where the row cannot be meshed, or does not fit its mesh.
pub fn prepare(sweep: &Sweep, row: &SweepRow, place: &SweepFolder) -> Result<Need, JobError> {
    let case = sweep.case_of(row)?;
    let folder = place.row(row);
    let mesh = match case.bearing() {
        Some(bearing) => {
            let kept = place.mesh(&bearing.fingerprint());
            let parent = kept.parent().unwrap_or(&place.0);
            for needed in [parent, &folder] {
                std::fs::create_dir_all(needed).map_err(|e| JobError::folder(needed, e))?;
            }
            let mesh = job::keep_mesh(&case, &kept)?;
            share(&kept, &folder.join(MESH_FILE))?;
            mesh
        }
        None => job::find_mesh(&case, None, &mut |_| {})?,
    };
    let forecast = job::forecast(&case, mesh)?;
    write_text(&folder.join(CASE), &row.text)?;
    Ok(Need {
        unknowns: forecast.unknowns,
        memory: MEMORY_GROWTH * forecast.memory + MEMORY_BESIDE_MODEL,
    })
}

/// Makes `link` the same file as `kept`, or a copy of it where the file system has no links. A run
/// that reads an older one meanwhile keeps what it has opened.
fn share(kept: &Path, link: &Path) -> Result<(), JobError> {
    let failed = |error| JobError::folder(link, error);
    let fresh = link.with_extension("new");
    let _ = std::fs::remove_file(&fresh);
    if std::fs::hard_link(kept, &fresh).is_err() {
        std::fs::copy(kept, &fresh).map_err(failed)?;
    }
    std::fs::rename(&fresh, link).map_err(failed)?;
    // Renaming one name of a file to another of its names does nothing.
    let _ = std::fs::remove_file(&fresh);
    Ok(())
}
