//! The mesh of a case: its file, the one that is shipped with it, or a new one by gmsh.

use super::error::JobError;
use super::files::forget;
use crate::case::bearing::{gmsh_parameters, write_with_fingerprint};
use crate::case::{BearingCase, Case, Family, Kind, MeshOrigin};
use crate::ground::file::write_atomically;
use crate::ground::memory::available;
use crate::model::mesh::family::problem_h;
use crate::model::mesh::{Mesh, gmsh, msh};
use crate::solver::solve::{self, Forecast};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Reads or makes the mesh of `case`. A new mesh is kept in `out`, where one is given.
///
/// # Errors
/// Where the file of a general scene is missing or wrong, or gmsh is needed and fails.
pub fn find_mesh(
    case: &Case,
    out: Option<&Path>,
    say: &mut dyn FnMut(&str),
) -> Result<Mesh, JobError> {
    let bearing = match &case.kind {
        Kind::General(general) => {
            return match &general.mesh.origin {
                MeshOrigin::File(_) => {
                    let path = case.mesh_file().unwrap_or_default();
                    let reading = msh::read_with_notes(&path)?;
                    reading.notes.iter().for_each(|note| say(note));
                    Ok(reading.mesh)
                }
                MeshOrigin::Family {
                    family: Family::ProblemH,
                    level,
                } => Ok(problem_h::half(&problem_h::Sizes::nested(*level))?),
            };
        }
        Kind::Bearing(bearing) => bearing,
    };
    let wanted = bearing.fingerprint();
    let fresh = out.map(|out| out.join(FRESH));
    for path in known_places(case, bearing, out)
        .into_iter()
        .chain(fresh.clone())
    {
        // A file that is no mesh, or one of another bearing, is never used.
        if let Ok(mesh) = msh::read(&path)
            && mesh.fingerprint.as_deref() == Some(&wanted)
        {
            if let Some(fresh) = fresh.filter(|fresh| *fresh != path) {
                forget(&fresh)?;
            }
            say(&format!("mesh {}", path.display()));
            return Ok(mesh);
        }
    }
    say(&format!(
        "no mesh of this bearing ({wanted}) is at hand: calling gmsh"
    ));
    let scratch = ScratchFolder::new()?;
    let kept = out.unwrap_or(&scratch.0).join(FILE);
    // The mesh of an earlier run stays as long as its results do.
    let kept = fresh.filter(|_| kept.exists()).unwrap_or(kept);
    make(bearing, &kept)
}

/// The mesh of the bearing of `case` in the file `kept`: as it is there, copied from where one is at
/// hand, or made by gmsh. The file is whole at any moment.
///
/// # Errors
/// As [`make_mesh`], and where the file cannot be written.
pub fn keep_mesh(case: &Case, kept: &Path) -> Result<Mesh, JobError> {
    let Some(bearing) = case.bearing() else {
        return make_mesh(case, kept);
    };
    let wanted = bearing.fingerprint();
    let failed = |error| JobError::folder(kept, error);
    for path in std::iter::once(kept.to_owned()).chain(known_places(case, bearing, None)) {
        let Some(mesh) = msh::read(&path)
            .ok()
            .filter(|m| m.fingerprint.as_deref() == Some(&wanted))
        else {
            continue;
        };
        if path != kept {
            let bytes = std::fs::read(&path).map_err(failed)?;
            write_atomically(kept, |out| out.write_all(&bytes))?;
        }
        return Ok(mesh);
    }
    let mut partial = kept.as_os_str().to_owned();
    partial.push(".part.gz");
    let partial = PathBuf::from(partial);
    let mesh = make(bearing, &partial)?;
    std::fs::rename(&partial, kept).map_err(failed)?;
    Ok(mesh)
}

/// What solving `case` on `mesh` will take.
///
/// # Errors
/// Where the two do not fit, or the case cannot be solved.
pub fn forecast(case: &Case, mesh: Mesh) -> Result<Forecast, JobError> {
    let mut scene = case.scene(mesh)?;
    Ok(solve::forecast(&mut scene)?)
}

/// Meshes a bearing by gmsh into the file `kept`.
///
/// # Errors
/// Where the case is a general scene, `kept` is a file of another kind, or gmsh is missing or fails.
pub fn make_mesh(case: &Case, kept: &Path) -> Result<Mesh, JobError> {
    match &case.kind {
        Kind::Bearing(_) if is_no_mesh(kept) => Err(JobError::NoMesh {
            path: kept.to_owned(),
        }),
        Kind::Bearing(bearing) => make(bearing, kept),
        Kind::General(_) => Err(JobError::NoTemplate {
            case: case.title.clone(),
        }),
    }
}

/// Is there a file with something in it that begins as no mesh does?
fn is_no_mesh(path: &Path) -> bool {
    const GZIP: &[u8] = &[0x1f, 0x8b];
    let mut start = Vec::new();
    let file = path.is_file().then(|| File::open(path).ok()).flatten();
    // Where it cannot be read, writing will tell.
    let read = file.and_then(|file| file.take(11).read_to_end(&mut start).ok());
    read.is_some_and(|n| n > 0) && ![GZIP, b"$MeshFormat"].iter().any(|m| start.starts_with(m))
}

/// What an element costs at least: seconds of gmsh and bytes of the solution.
///
/// Measured on 242 thousand elements: 7 s, and 15 kB where the model is divided.
const SECONDS: f64 = 3e-5;
const BYTES: f64 = 5e3;

/// Refuses a mesh that could not be solved here, before hours are spent on making it.
fn check_size(bearing: &BearingCase) -> Result<(), JobError> {
    let elements = bearing.elements();
    let needed = BYTES * elements;
    match available().filter(|available| needed > *available) {
        Some(available) => Err(JobError::MeshSize {
            elements,
            seconds: SECONDS * elements,
            needed,
            available,
        }),
        None => Ok(()),
    }
}

fn make(bearing: &BearingCase, kept: &Path) -> Result<Mesh, JobError> {
    check_size(bearing)?;
    let scratch = ScratchFolder::new()?;
    let failed = |error| JobError::folder(&scratch.0, error);
    let template = bearing.geometry.template();
    let template = template.write(&scratch.0).map_err(failed)?;
    let raw = scratch.0.join("bearing.msh");
    gmsh::run(
        &template,
        &gmsh_parameters(bearing.layout(), &bearing.mesh),
        &raw,
    )?;
    write_with_fingerprint(&raw, &bearing.fingerprint(), kept)?;
    Ok(msh::read(kept)?)
}

/// Name of a mesh that a job made, in its folder.
pub const FILE: &str = "mesh.msh.gz";

/// The same while results of an earlier run, on another mesh, are still there.
pub(super) const FRESH: &str = "mesh-new.msh.gz";

/// Where a run keeps what its second mesh is made for, in its folder.
pub(super) fn strips_file(out: &Path) -> PathBuf {
    out.join(STRIPS)
}

/// Name of that file.
pub(super) const STRIPS: &str = "mesh-strips.txt";

/// Where a mesh of the bearing may already be: shipped beside the case (`cases/a/b.toml` has its
/// meshes in `meshes/a/b-<preset>.msh.gz`), or left by an earlier run.
fn known_places(case: &Case, bearing: &BearingCase, out: Option<&Path>) -> Vec<PathBuf> {
    let path = Path::new(case.source.name());
    let mut places: Vec<PathBuf> = out.map(|out| out.join(FILE)).into_iter().collect();
    let Some(stem) = path.file_stem().and_then(|s| s.to_str()) else {
        return places;
    };
    let file = format!("{stem}-{}.msh.gz", bearing.mesh.preset);
    // Where the command is given inside of `cases`, only the absolute path tells.
    let shipped = shipped_folder(path)
        .or_else(|| shipped_folder(&std::path::absolute(path).unwrap_or_default()));
    places.extend(shipped.map(|folder| folder.join(file)));
    places
}

/// Folder of the meshes that belong to the case at `path`, if that lies below a folder `cases`.
fn shipped_folder(path: &Path) -> Option<PathBuf> {
    let parts: Vec<_> = path.parent()?.components().collect();
    let at = parts.iter().rposition(|p| p.as_os_str() == "cases")?;
    let mut folder: PathBuf = parts[..at].iter().collect();
    folder.push("meshes");
    folder.extend(&parts[at + 1..]);
    Some(folder)
}

/// A folder of its own that is removed at the end.
struct ScratchFolder(PathBuf);

impl ScratchFolder {
    fn new() -> Result<Self, JobError> {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("brinell-{}-{number}", std::process::id());
        let path = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&path).map_err(|error| JobError::folder(&path, error))?;
        Ok(Self(path))
    }
}

impl Drop for ScratchFolder {
    fn drop(&mut self) {
        // Best effort: a scratch folder left behind harms nobody.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
