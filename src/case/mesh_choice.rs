//! `[mesh]`: a file, a family of meshes that is built in, or the preset of the bearing template
//! and what overrides it.

use std::path::PathBuf;

use super::assumption::Assumption;
use super::bearing::{Layout, MESH_KEYS, MeshKey, MeshRequest, Preset, SizeKind};
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::Table;
use super::place::Located;
use crate::ground::units::Dimension;

/// The mesh of a general scene.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneMesh {
    /// A file, or a family.
    pub origin: MeshOrigin,
    /// Turns the coordinates of the mesh into the length unit of the case.
    pub scale: f64,
}

/// Where the mesh of a general scene comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum MeshOrigin {
    /// A file, as it stands in the case file, relative to the directory of that file.
    File(Located<PathBuf>),
    /// A level of a family that is built in.
    Family {
        /// Which family.
        family: Family,
        /// How often it is refined.
        level: u32,
    },
}

/// Nested meshes that are built in: from level to level every element is split.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// The half model of problem H, in inches; 2 · 2^level elements across the half-width.
    ProblemH,
}

/// The level of a built-in mesh where the case gives none.
const DEFAULT_LEVEL: u32 = 2;
/// The finest level of a built-in mesh: those beyond have more elements than can be solved.
const FINEST_LEVEL: usize = 8;

impl SceneMesh {
    pub(super) fn read(root: &Table) -> Result<Self, CaseError> {
        let table = root.need("mesh")?.table()?;
        if table.get("family").is_some() {
            return Self::family(root, &table.only(&keys::FAMILY_MESH)?);
        }
        let table = table.only(&keys::FILE_MESH)?;
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
            origin: MeshOrigin::File(table.need("file")?.string()?.map(PathBuf::from)),
            scale,
        })
    }

    fn family(root: &Table, table: &Table) -> Result<Self, CaseError> {
        let family = table.need("family")?;
        let family = family.choice(&[("problem-h", Family::ProblemH)])?.value;
        let level = match table.get("level") {
            None => DEFAULT_LEVEL,
            Some(field) => {
                let level = field.count()?.require(
                    |l| *l <= FINEST_LEVEL,
                    format!("must lie between 1 and {FINEST_LEVEL}"),
                )?;
                level.value as u32
            }
        };
        Ok(Self {
            origin: MeshOrigin::Family { family, level },
            scale: root.units().length_factor("in").unwrap_or(1.0),
        })
    }
}

/// Reads `[mesh]` of a bearing.
pub(super) fn request(
    root: &Table,
    (full, layout): (bool, &dyn Layout),
    assumptions: &mut Vec<Assumption>,
) -> Result<MeshRequest, CaseError> {
    let mut request = MeshRequest {
        full,
        ..MeshRequest::default()
    };
    let mut given = false;
    if let Some(field) = root.get("mesh") {
        let keys = match layout.table() {
            "line_bearing" => &keys::LINE_BEARING_MESH,
            _ => &keys::BEARING_MESH,
        };
        let table = field.table()?.only(keys)?;
        if let Some(field) = table.get("preset") {
            let presets = layout.presets().iter();
            let choices: Vec<(&str, Preset)> = presets.map(|p| (p.name(), *p)).collect();
            request.preset = field.choice(&choices)?.value;
            given = true;
        }
        if let Some(field) = table.get("scale") {
            request.scale = field.ratio()?.value;
        }
        for MeshKey { key, kind, .. } in MESH_KEYS {
            let Some(field) = table.get(key) else {
                continue;
            };
            let value = match kind {
                SizeKind::Length => field.quantity(Dimension::LENGTH)?.value,
                SizeKind::Count => field.count()?.value as f64,
                SizeKind::Ratio => field.ratio()?.value,
            };
            request.overrides.push((key.to_string(), value));
        }
    }
    let name = request.preset.name();
    let mut text = match request.overrides.len() {
        0 => name.to_string(),
        n => format!("{name}, {n} of its numbers overridden"),
    };
    if request.scale != 1.0 {
        text.push_str(&format!(", every element {} times as large", request.scale));
    }
    let why = "peak stresses near a contact line depend on the mesh";
    assumptions.push(Assumption::new("mesh.preset", text, why, given));
    Ok(request)
}
