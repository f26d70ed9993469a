//! A case as a deck for another program, on the mesh that Brinell would solve it on.

use super::{JobError, find_mesh};
use crate::case::Case;
use crate::output::file::write_atomically;
use crate::output::inp::{self, Settings};
use crate::solve::close_gaps;
use std::path::{Path, PathBuf};

/// A deck that was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    pub path: PathBuf,
    pub nodes: usize,
    pub elements: usize,
}

/// Writes `case` to `<folder>/<name of the case file>.inp`, its bodies moved into touch. The title
/// and the units of `settings` are set to those of the case. A new mesh is kept in the folder.
///
/// # Errors
/// [`JobError`]: no mesh, a scene that a deck cannot express, or a folder that cannot be written.
pub fn export(
    case: &Case,
    mut settings: Settings,
    folder: &Path,
    say: &mut dyn FnMut(&str),
) -> Result<Exported, JobError> {
    std::fs::create_dir_all(folder).map_err(|error| JobError::folder(folder, error))?;
    let mut scene = case.scene(find_mesh(case, Some(folder), say)?)?;
    for closing in close_gaps(&mut scene, 0.0) {
        let [x, y, z] = closing.shift;
        say(&format!(
            "{} moved by [{x:.3e}, {y:.3e}, {z:.3e}] to close its gap",
            closing.body
        ));
    }
    let units = case.units;
    settings.title = case.title.clone();
    settings.units = [units.length(), units.force(), units.stress()].map(str::to_string);
    let deck = inp::check(&scene, &settings)?;
    let stem = Path::new(case.source.name()).file_stem();
    let stem = stem.map_or_else(|| "case".into(), |s| s.to_string_lossy());
    let path = folder.join(format!("{stem}.inp"));
    write_atomically(&path, |out| deck.write(out))?;
    Ok(Exported {
        path,
        nodes: scene.mesh.points.len(),
        elements: scene.mesh.hexes.len(),
    })
}
