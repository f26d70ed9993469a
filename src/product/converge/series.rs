//! Which meshes a case is solved on, coarse to fine.

use super::ConvergeError;
use crate::case::{Case, Kind, MeshOrigin};
use crate::model::mesh::{Mesh, msh};
use crate::product::job::{JobError, find_mesh};
use crate::solver::solve::Observer;
use std::path::{Path, PathBuf};

/// A series of meshes.
#[derive(Debug, Clone, PartialEq)]
pub enum MeshSeries {
    /// Levels of a built-in family: every element is split into four (or eight) from one to the
    /// next, so that each mesh holds the one before.
    Family,
    /// The bearing template with every size divided by this factor from level to level, and those at
    /// the contact by `contact` once more.
    Template { factor: f64, contact: f64 },
    /// The mesh file of the case, every hexahedron split into eight from level to level. New nodes
    /// on a surface that fits a cylinder or sphere are put on it.
    Split,
    /// These files.
    Files(Vec<PathBuf>),
}

impl MeshSeries {
    /// The series that suits `case`: the `files` where there are any, else by its kind of mesh.
    ///
    /// # Errors
    /// Files for a bearing, which has a template, and a factor that refines nothing.
    pub fn of(case: &Case, files: &[PathBuf], factor: f64) -> Result<Self, ConvergeError> {
        if !(factor > 1.0 && factor <= 4.0) {
            return Err(ConvergeError::Factor { factor });
        }
        match &case.kind {
            Kind::Bearing(_) if files.is_empty() => Ok(Self::Template {
                factor,
                contact: 1.0,
            }),
            Kind::Bearing(_) => Err(ConvergeError::Choice {
                what: "mesh files",
                why: format!("`{}` is a bearing, meshed by its template", case.title),
                help: "give one preset with --mesh, as the coarsest of the series",
            }),
            Kind::General(_) if files.len() == 1 => Err(ConvergeError::TooFew { count: 1 }),
            Kind::General(_) if !files.is_empty() => Ok(Self::Files(files.to_vec())),
            Kind::General(general) => Ok(match general.mesh.origin {
                MeshOrigin::File(_) => Self::Split,
                MeshOrigin::Family { .. } => Self::Family,
            }),
        }
    }

    /// Levels where the user does not say: as many as the series has files, or as take minutes.
    pub fn levels(&self) -> usize {
        match self {
            Self::Family => 5,
            Self::Template { .. } | Self::Split => 3,
            Self::Files(files) => files.len(),
        }
    }

    /// In words.
    pub fn words(&self) -> String {
        match self {
            Self::Family => "nested: every element side halved from level to level".into(),
            Self::Template { factor, .. } => {
                format!("template: every element size divided by {factor} from level to level")
            }
            Self::Split => "split: every hexahedron into eight from level to level".into(),
            Self::Files(_) => {
                "mesh files; size is the cube root of the mean volume of an element".into()
            }
        }
    }

    /// Element size relative to level 0 (of files: to one element), given the number of elements.
    pub fn size(&self, level: usize, elements: usize) -> f64 {
        match self {
            Self::Family | Self::Split => 0.5f64.powi(level as i32),
            Self::Template { factor, .. } => factor.powi(-(level as i32)),
            Self::Files(_) => (elements.max(1) as f64).powf(-1.0 / 3.0),
        }
    }

    /// The case and the mesh of level `level`; a mesh that gmsh makes is kept below `out`.
    ///
    /// # Errors
    /// Where the mesh cannot be read, made or split.
    pub fn mesh(
        &self,
        case: &Case,
        level: usize,
        out: &Path,
        observer: &mut dyn Observer,
    ) -> Result<(Case, Mesh), ConvergeError> {
        let mut case = case.clone();
        let mut find = |case: &Case, out: Option<&Path>| {
            find_mesh(case, out, &mut |line| observer.message(line))
        };
        let mesh = match self {
            Self::Family => {
                case.set_level(level as u32);
                find(&case, None)?
            }
            Self::Template { contact, .. } => {
                case.scale_mesh(self.size(level, 0), contact.powi(-(level as i32)))?;
                let kept = out.join(format!("level-{level}"));
                std::fs::create_dir_all(&kept).map_err(|error| JobError::folder(&kept, error))?;
                find(&case, Some(&kept))?
            }
            Self::Split => {
                let mut mesh = find(&case, None)?;
                for _ in 0..level {
                    mesh = mesh.split()?;
                }
                mesh
            }
            Self::Files(files) => match files.get(level) {
                Some(path) => {
                    let reading = msh::read_with_notes(path)?;
                    (reading.notes.iter()).for_each(|note| observer.message(note));
                    reading.mesh
                }
                None => return Err(ConvergeError::TooFew { count: files.len() }),
            },
        };
        Ok((case, mesh))
    }
}
