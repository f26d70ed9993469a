//! The case file: TOML in, a validated [`Case`] out, and from it a scene.
//!
//! A case is either a *bearing*, described by its dimensions and meshed by the template, or a
//! *general scene* on a mesh file. Both come down to one [`MeshlessScene`]; the solver sees scenes only.
//! Quantities are turned into the unit system that the file declares (`units = "in-kip-ksi"`),
//! angles into radians. Every mistake is a [`CaseError`] that marks the culprit in the file.

mod assumption;
mod axes;
pub mod bearing;
mod change;
pub mod combinations;
mod comparison;
mod contact;
mod controls;
mod document;
mod error;
mod fits_mesh;
mod general;
pub mod grades;
#[doc(hidden)]
pub mod interfaces;
#[doc(hidden)]
pub mod keys;
mod load;
mod mesh_choice;
mod model;
pub(crate) mod named_files;
mod nearest;
mod parse;
mod place;
mod quantity;
mod reference;
mod rigid_plane;
mod source;
mod steel;
mod temperature;
mod template_loads;
mod tie;
mod title_block;
mod values;
pub mod variant;

use std::path::{Path, PathBuf};

pub use assumption::Assumption;
pub use bearing::BearingCase;
pub use comparison::{ComparedMeasure, MisesRead, Printed, PrintedValues};
pub use contact::Contact;
pub use error::{CaseError, ErrorKind};
pub use general::GeneralCase;
pub use load::Loads;
pub use mesh_choice::{Family, MeshOrigin, SceneMesh};
pub use model::MeshlessScene;
pub use place::{KeyPlace, Located};
pub use reference::Discrepancy;
pub use source::Source;
pub use steel::{SteelStrength, Steels, StrainIs};
pub use template_loads::{TemplateLoads, Top};
pub use title_block::TitleBlock;

use crate::ground::units::UnitSystem;
use crate::model::mesh::Mesh;
use crate::model::scene::{Controls, Scene};
use document::{Context, document};
use parse::{Field, Table};

/// The tables of the file that describe a bearing by its dimensions; a case has one of them, or none.
const TEMPLATE_TABLES: [&str; 2] = ["bearing", "line_bearing"];

/// A validated case.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its title.
    pub title: String,
    /// What it is about, where that is said.
    pub description: Option<String>,
    /// Whose calculation it is; empty where the case does not say.
    pub title_block: TitleBlock,
    /// The system all numbers of the case are in.
    pub units: UnitSystem,
    /// The published study the case belongs to.
    pub reference: Option<String>,
    /// Bearing or general scene.
    pub kind: Kind,
    /// Numerical controls.
    pub controls: Controls,
    /// Printed values to set beside the results.
    pub comparison: Option<PrintedValues>,
    /// What is taken for granted, echoed with the results.
    pub assumptions: Vec<Assumption>,
    /// Discrepancies of the published study that touch the result.
    pub discrepancies: Vec<Discrepancy>,
    /// The file.
    pub source: Source,
}

/// The two levels of a case.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// A bearing by its dimensions.
    Bearing(BearingCase),
    /// A general scene on a mesh file.
    General(GeneralCase),
}

/// Reads and validates the case file at `path`.
///
/// # Errors
/// Where the file cannot be read, is not TOML, or says something impossible.
pub fn read(path: &Path) -> Result<Case, CaseError> {
    parse(&path.display().to_string(), &text_of_file(path)?)
}

fn text_of_file(path: &Path) -> Result<String, CaseError> {
    crate::ground::input::text(path).map_err(|error| {
        let message = format!("the case file {} cannot be read: {error}", path.display());
        CaseError::new(ErrorKind::Read, message)
    })
}

/// Validates the text of a case file; `name` is its path, for messages and to find its mesh.
///
/// # Errors
/// As [`read`], but for reading.
pub fn parse(name: &str, text: &str) -> Result<Case, CaseError> {
    let source = Source::new(name, text);
    let document = document(&source)?;
    let context = Context {
        source: &source,
        units: UnitSystem::MNPa,
    };
    let root = Table::root(context, &document).only_either(&[&keys::ROOT, &keys::SCENE])?;
    let units = read_units(&root)?;
    Case::from_table(&root.with_units(units))
}

fn read_units(root: &Table) -> Result<UnitSystem, CaseError> {
    let choices = UnitSystem::ALL.map(|system| (system.name(), system));
    let help = format!("one of: {}", choices.map(|(name, _)| name).join(", "));
    let field = root.need("units").map_err(|error| error.help(help))?;
    Ok(field.choice(&choices)?.value)
}

impl Case {
    fn from_table(root: &Table) -> Result<Self, CaseError> {
        let mut assumptions = Vec::new();
        let text = |key| root.maybe(key, Field::string);
        let title = text("title")?.map_or_else(|| stem(root.source().name()), |t| t.value);
        let description = text("description")?.map(|d| d.value);
        let studies = reference::STUDIES.map(|name| (name, name));
        let reference = root.maybe("reference", |field| field.choice(&studies))?;
        let reference = reference.map(|r| r.value.to_string());
        let controls = controls::read(root)?;
        refuse_combinations(root)?;
        let given = TEMPLATE_TABLES
            .into_iter()
            .filter(|key| root.get(key).is_some());
        let kind = match given.collect::<Vec<_>>().as_slice() {
            [_, second, ..] => {
                let why = "and `[bearing]` are two bearings, and a case is of one";
                let place = root.place_of_key(second);
                return Err(place
                    .error(ErrorKind::Conflict, why)
                    .help("drop one of the two"));
            }
            [table] => {
                refuse_scene_keys(root, table)?;
                Kind::Bearing(BearingCase::read(root, &mut assumptions)?)
            }
            [] => {
                let case = GeneralCase::read(root, &title, controls, &mut assumptions)?;
                Kind::General(case)
            }
        };
        let comparison = PrintedValues::read(root, &mut assumptions)?;
        let displaced = matches!(&kind, Kind::Bearing(bearing) if bearing.geometry.offset() != 0.0);
        let study = reference.as_deref().unwrap_or_default();
        let case = Self {
            title,
            description,
            title_block: title_block::read(root)?,
            units: root.units(),
            discrepancies: reference::discrepancies(study, displaced),
            reference,
            kind,
            controls,
            comparison,
            assumptions,
            source: root.source().clone(),
        };
        if let Kind::Bearing(bearing) = &case.kind {
            let bodies = bearing.geometry.bodies();
            let bodies: Vec<&str> = bodies.iter().map(|(body, _)| body.as_str()).collect();
            case.check_comparison(&bodies)?;
        }
        Ok(case)
    }

    /// The scene on `mesh`, as it stands in its file. Its coordinates are brought to the length
    /// unit of the case here: from the `unit` of a general scene's mesh file, or by the size of
    /// the bearing, whose rollers also get their ends.
    ///
    /// # Errors
    /// Where a name of the case is not in the mesh, the mesh does not fit the symmetry, or it is
    /// not the mesh of this bearing.
    pub fn scene(&self, mut mesh: Mesh) -> Result<Scene, CaseError> {
        match &self.kind {
            Kind::Bearing(bearing) => self.model().scene(bearing.fit(mesh)?),
            Kind::General(general) => {
                let bodies: Vec<&str> = mesh.bodies.iter().map(|b| b.name.as_str()).collect();
                self.check_comparison(&bodies)?;
                general.check_bodies(&mesh)?;
                if general.mesh.scale != 1.0 {
                    for coordinate in mesh.points.iter_mut().flatten() {
                        *coordinate *= general.mesh.scale;
                    }
                }
                self.model().scene(mesh)
            }
        }
    }

    /// Everything of the scene but its mesh.
    pub fn model(&self) -> MeshlessScene {
        match &self.kind {
            Kind::Bearing(bearing) => bearing.model(&self.title, &self.source, self.controls),
            Kind::General(general) => general.model.clone(),
        }
    }

    /// The bearing that it is of; `None` for a general scene.
    pub fn bearing(&self) -> Option<&BearingCase> {
        match &self.kind {
            Kind::Bearing(bearing) => Some(bearing),
            Kind::General(_) => None,
        }
    }

    /// The steels of its bodies.
    pub fn steels(&self) -> &Steels {
        match &self.kind {
            Kind::Bearing(bearing) => &bearing.steels,
            Kind::General(general) => &general.model.steels,
        }
    }

    /// The mesh file of a general scene, relative paths taken from the directory of the case;
    /// `None` for a bearing, which is meshed by the template, and for a mesh that is built in.
    pub fn mesh_file(&self) -> Option<PathBuf> {
        let Kind::General(general) = &self.kind else {
            return None;
        };
        let MeshOrigin::File(path) = &general.mesh.origin else {
            return None;
        };
        let directory = Path::new(self.source.name())
            .parent()
            .unwrap_or(Path::new(""));
        Some(directory.join(&path.value))
    }

    fn check_comparison(&self, bodies: &[&str]) -> Result<(), CaseError> {
        let Some(comparison) = &self.comparison else {
            return Ok(());
        };
        let model = self.model();
        let pairs = model.contacts.iter();
        let pairs: Vec<&str> = pairs.map(|pair| pair.name.value.as_str()).collect();
        comparison.check_places(bodies, &pairs)
    }
}

/// The file name without directory and ending.
fn stem(name: &str) -> String {
    let stem = Path::new(name).file_stem();
    stem.map_or_else(
        || name.to_string(),
        |stem| stem.to_string_lossy().into_owned(),
    )
}

/// A file with combinations is several cases.
fn refuse_combinations(root: &Table) -> Result<(), CaseError> {
    let keys = ["action", "combination"];
    match keys.into_iter().find(|key| root.get(key).is_some()) {
        None => Ok(()),
        Some(key) => {
            let why = "the file has combinations of actions, each a case of its own";
            let help = "`brinell run` solves all of them; leave them out where one case is wanted";
            Err(root
                .place_of_key(key)
                .error(ErrorKind::Conflict, why)
                .help(help))
        }
    }
}

/// The template writes the contacts, supports and loads of a bearing itself.
fn refuse_scene_keys(root: &Table, table: &str) -> Result<(), CaseError> {
    let names = keys::SCENE.names().into_iter();
    // Bodies of a bearing have temperatures, too.
    let mut names = names.filter(|key| *key != "temperature");
    match names.find(|key| root.get(key).is_some()) {
        None => Ok(()),
        Some(key) => {
            let place = root.place_of_key(key);
            let why = format!("does not go with `[{table}]`, which makes its own scene");
            let help = format!("describe the bearing by [{table}], or the whole scene without it");
            Err(place.error(ErrorKind::Conflict, why).help(help))
        }
    }
}
