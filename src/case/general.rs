//! A general scene: bodies and surfaces of a mesh file, contacts, supports and loads by name.

use super::assumption::Assumption;
use super::contact;
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::load::Loads;
use super::mesh_choice::SceneMesh;
use super::model::MeshlessScene;
use super::parse::Table;
use super::place::Located;
use super::steel::Steels;
use super::tie;
use crate::model::mesh::Mesh;
use crate::model::scene::Controls;

/// A general scene before it meets its mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct GeneralCase {
    /// Where its mesh comes from.
    pub mesh: SceneMesh,
    /// Everything but the mesh.
    pub model: MeshlessScene,
    /// The bodies of `[[body]]`.
    pub bodies: Vec<Located<String>>,
}

impl GeneralCase {
    pub(super) fn read(
        root: &Table,
        name: &str,
        controls: Controls,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<Self, CaseError> {
        let mut steels = Steels::read(root, assumptions)?;
        let bodies = read_bodies(root, &mut steels, assumptions)?;
        let mirrors = read_mirrors(root)?;
        let contacts = contact::read(root)?;
        for (i, contact) in contacts.iter().enumerate() {
            if contact.friction_is_default {
                let key = format!("contact#{}.friction", i + 1);
                let why = format!("no friction is given for `{}`", contact.name.value);
                assumptions.push(Assumption::default(&key, "0", &why));
            }
        }
        let ties = tie::read(root)?;
        let loads = Loads::read(root, &mirrors, (&steels, assumptions))?;
        let name = name.to_string();
        let model = MeshlessScene {
            name,
            steels,
            contacts,
            ties,
            loads,
            mirrors,
            controls,
        };
        Ok(Self {
            mesh: SceneMesh::read(root)?,
            model,
            bodies,
        })
    }

    /// Refuses `[[body]]` entries that the mesh does not have.
    pub(super) fn check_bodies(&self, mesh: &Mesh) -> Result<(), CaseError> {
        match self
            .bodies
            .iter()
            .find(|body| mesh.body(&body.value).is_none())
        {
            None => Ok(()),
            Some(body) => {
                let why = format!("the mesh {} has no such body", mesh.source);
                let names = mesh.bodies.iter().map(|b| b.name.as_str());
                Err(body.place.unknown(why, &body.value, names))
            }
        }
    }
}

fn read_bodies(
    root: &Table,
    steels: &mut Steels,
    assumptions: &mut Vec<Assumption>,
) -> Result<Vec<Located<String>>, CaseError> {
    let mut bodies: Vec<Located<String>> = Vec::new();
    for table in root.tables("body")? {
        let table = table.only(&keys::BODY)?;
        let body = table.need("name")?.string()?;
        if bodies.iter().any(|other| other.value == body.value) {
            let why = format!("two steels for one body: `{}` is given twice", body.value);
            return Err(body.place.error(ErrorKind::Duplicate, why));
        }
        if let Some(field) = table.get("steel") {
            steels.add(&body, (root, &field), assumptions)?;
        }
        bodies.push(body);
    }
    Ok(bodies)
}

fn read_mirrors(root: &Table) -> Result<Vec<usize>, CaseError> {
    let mut mirrors = Vec::new();
    let Some(field) = root.get("symmetry") else {
        return Ok(mirrors);
    };
    for item in field.list()? {
        let axis = item.choice(&[("x", 0), ("y", 1), ("z", 2)])?;
        if mirrors.contains(&axis.value) {
            return Err(axis.place.error(ErrorKind::Duplicate, "is given twice"));
        }
        mirrors.push(axis.value);
    }
    mirrors.sort_unstable();
    Ok(mirrors)
}
