//! A case as a deck for another program, on the mesh that Brinell would solve it on.

use super::error::JobError;
use super::mesh::find_mesh;
use crate::answer::results::load;
use crate::case::Case;
use crate::ground::file::write_atomically;
use crate::model::scene::{PlaneMotion, Scene};
use crate::product::deck;
use crate::render::inp::Settings;
use crate::solver::solve::close_gaps;
use std::path::{Path, PathBuf};

/// A deck that was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// The file.
    pub path: PathBuf,
    /// Number of nodes in it.
    pub nodes: usize,
    /// Number of elements in it.
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
    let closings = close_gaps(&mut scene, 0.0);
    for closing in &closings {
        let [x, y, z] = closing.shift;
        say(&format!(
            "{} moved by [{x:.3e}, {y:.3e}, {z:.3e}] to close its gap",
            closing.body
        ));
    }
    if let Some(distance) = settings.closing
        && !has_driven_plane(&scene)
    {
        let bodies = closings.iter().map(|closing| closing.body.as_str());
        press_in(&mut scene, bodies, distance);
    }
    let units = case.units;
    settings.title = case.title.clone();
    settings.units = [units.length(), units.force(), units.stress()].map(str::to_string);
    let deck = deck::check(&scene, &settings)?;
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

/// Is a plane driven by force, so that a step of the deck can close the contact?
fn has_driven_plane(scene: &Scene) -> bool {
    let mut motions = scene.rigid_planes.iter().flat_map(|plane| plane.motion);
    motions.any(|motion| matches!(motion, PlaneMotion::Driven(force) if force != 0.0))
}

/// Moves `bodies`, in the order in which they were placed, along the load until each overlaps the
/// one before by `distance`.
fn press_in<'a>(scene: &mut Scene, bodies: impl Iterator<Item = &'a str>, distance: f64) {
    let along = load::direction(scene);
    for (count, body) in (1..).zip(bodies) {
        let Some(index) = scene.mesh.body(body) else {
            continue;
        };
        for node in scene.mesh.nodes_of_body(index) {
            let point = &mut scene.mesh.points[node as usize];
            *point = std::array::from_fn(|i| point[i] + f64::from(count) * distance * along[i]);
        }
    }
}
