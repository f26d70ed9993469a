//! `[mesh]`: a file, or the preset of the bearing template and what overrides it.

use std::path::PathBuf;

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::parse::Table;
use super::source::Located;
use super::template::{MESH_KEYS, PRESETS};
use crate::units::Dimension;

/// A mesh file of a general scene.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile {
    /// As it stands in the case file, relative to the directory of that file.
    pub path: Located<PathBuf>,
    /// Turns the coordinates of the file into the length unit of the case.
    pub scale: f64,
}

/// How the bearing template is to be meshed.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingMesh {
    pub preset: &'static str,
    /// Keys of [`MESH_KEYS`] with their values, lengths in the unit of the case.
    pub overrides: Vec<(&'static str, f64)>,
}

impl MeshFile {
    pub(super) fn read(root: &Table) -> Result<Self, CaseError> {
        let table = root.need("mesh")?.table()?.only(&["file", "unit"])?;
        let scale = match table.get("unit") {
            None => 1.0,
            Some(field) => {
                let unit = field.string()?;
                root.units().length_factor(&unit.value).ok_or_else(|| {
                    let why = format!("must be a unit of length: {}", Dimension::LENGTH.examples());
                    unit.place.error(ErrorKind::Unit, why)
                })?
            }
        };
        Ok(Self {
            path: table.need("file")?.string()?.map(PathBuf::from),
            scale,
        })
    }
}

impl BearingMesh {
    pub(super) fn read(root: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
        let mut mesh = Self {
            preset: PRESETS[0],
            overrides: Vec::new(),
        };
        let mut given = false;
        if let Some(field) = root.get("mesh") {
            let mut keys = vec!["preset"];
            keys.extend(MESH_KEYS.iter().map(|(key, _)| *key));
            let table = field.table()?.only(&keys)?;
            if let Some(field) = table.get("preset") {
                mesh.preset = field.choice(&PRESETS.map(|name| (name, name)))?.value;
                given = true;
            }
            for (key, dimension) in MESH_KEYS {
                let Some(field) = table.get(key) else {
                    continue;
                };
                let value = field.quantity(dimension)?.positive()?;
                let value = match key {
                    "fine_elements" | "fine_layers" => field.count()?.value as f64,
                    "growth" | "depth_growth" | "along_growth" => {
                        value
                            .require(|ratio| *ratio >= 1.0, "must be 1 or more")?
                            .value
                    }
                    _ => value.value,
                };
                mesh.overrides.push((key, value));
            }
        }
        let changed = match mesh.overrides.len() {
            0 => mesh.preset.to_string(),
            n => format!("{}, {n} of its sizes overridden", mesh.preset),
        };
        let why = "peak stresses near a contact line depend on the mesh";
        assumptions.push(Assumption::new("mesh.preset", changed, why, given));
        Ok(mesh)
    }
}
