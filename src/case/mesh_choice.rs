//! `[mesh]`: a file, or the preset of the bearing template and what overrides it.

use std::path::PathBuf;

use super::assumption::Assumption;
use super::bearing::{Kind, MESH_KEYS, MeshKey, MeshRequest, Preset};
use super::error::{CaseError, ErrorKind};
use super::parse::Table;
use super::source::Located;
use crate::units::Dimension;

/// A mesh file of a general scene.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile {
    /// As it stands in the case file, relative to the directory of that file.
    pub path: Located<PathBuf>,
    /// Turns the coordinates of the file into the length unit of the case.
    pub scale: f64,
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

/// Reads `[mesh]` of a bearing.
pub(super) fn request(
    root: &Table,
    full: bool,
    assumptions: &mut Vec<Assumption>,
) -> Result<MeshRequest, CaseError> {
    let mut request = MeshRequest {
        full,
        ..MeshRequest::default()
    };
    let mut given = false;
    if let Some(field) = root.get("mesh") {
        let mut keys = vec!["preset"];
        keys.extend(MESH_KEYS.iter().map(|key| key.key));
        let table = field.table()?.only(&keys)?;
        if let Some(field) = table.get("preset") {
            request.preset = field.choice(&Preset::ALL.map(|p| (p.name(), p)))?.value;
            given = true;
        }
        for MeshKey { key, kind, .. } in MESH_KEYS {
            let Some(field) = table.get(key) else {
                continue;
            };
            let value = match kind {
                Kind::Length => field.quantity(Dimension::LENGTH)?.value,
                Kind::Count => field.count()?.value as f64,
                Kind::Ratio => field.ratio()?.value,
            };
            request.overrides.push((key.to_string(), value));
        }
    }
    let name = request.preset.name();
    let text = match request.overrides.len() {
        0 => name.to_string(),
        n => format!("{name}, {n} of its numbers overridden"),
    };
    let why = "peak stresses near a contact line depend on the mesh";
    assumptions.push(Assumption::new("mesh.preset", text, why, given));
    Ok(request)
}
