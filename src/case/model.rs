//! A scene before it meets its mesh: what both kinds of case come down to.

use super::contact::Contact;
use super::error::{CaseError, ErrorKind};
use super::fits_mesh::{check_mirrors, check_turns};
use super::load::Loads;
use super::place::{KeyPlace, Located};
use super::steel::Steels;
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::scene::{self, ContactPair, Controls, Partner, Scene, Tie};

/// Everything of a scene but the mesh, with the places where names stand in the case file.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshlessScene {
    /// Name of the scene.
    pub name: String,
    /// Steels by body.
    pub steels: Steels,
    /// Contact pairs.
    pub contacts: Vec<Contact>,
    /// Pairs of surfaces that are joined.
    pub ties: Vec<Located<Tie>>,
    /// Supports, planes, tractions and steps.
    pub loads: Loads,
    /// Axes (0, 1, 2) across which the model is mirrored.
    pub mirrors: Vec<usize>,
    /// Numerical controls.
    pub controls: Controls,
}

impl MeshlessScene {
    /// The scene on `mesh`, whose coordinates are in the units of the case.
    pub fn scene(&self, mesh: Mesh) -> Result<Scene, CaseError> {
        let bodies: Vec<&str> = mesh.bodies.iter().map(|body| body.name.as_str()).collect();
        self.steels.check_names(&bodies)?;
        let materials = bodies
            .iter()
            .map(|body| self.steels.of(body))
            .collect::<Result<Vec<Steel>, _>>()?;
        let contacts = self
            .contacts
            .iter()
            .map(|c| c.pair(&mesh, &materials))
            .collect::<Result<Vec<_>, _>>()?;
        for tie in &self.ties {
            for surface in &tie.value.surfaces {
                check_surface(&mesh, surface, &tie.place)?;
            }
        }
        let loads = &self.loads;
        for support in &loads.supports {
            check_surface(&mesh, &support.value.surface, &support.place)?;
        }
        for plane in &loads.planes {
            check_surface(&mesh, &plane.value.surface, &plane.place)?;
        }
        for traction in &loads.tractions {
            check_surface(&mesh, &traction.value.surface, &traction.place)?;
        }
        for temperature in &loads.temperatures {
            if mesh.body(&temperature.value.body).is_none() {
                let name = &temperature.value.body;
                let why = format!("the mesh {} has no body called `{name}`", mesh.source);
                let known = bodies.iter().copied();
                return Err(temperature.place.unknown(why, name, known));
            }
        }
        check_mirrors((loads, &self.mirrors), &mesh)?;
        check_turns((loads, &self.mirrors), &mesh)?;
        let mut scene = Scene {
            name: self.name.clone(),
            materials,
            contacts,
            supports: values(&loads.supports),
            rigid_planes: values(&loads.planes),
            tractions: values(&loads.tractions),
            temperatures: values(&loads.temperatures),
            steps: loads.steps.clone(),
            mirrors: self.mirrors.clone(),
            ties: values(&self.ties),
            half_turn: Vec::new(),
            controls: self.controls,
            mesh,
        };
        scene.hold_mirrors();
        Ok(scene)
    }
}

fn values<T: Clone>(located: &[Located<T>]) -> Vec<T> {
    located.iter().map(|entry| entry.value.clone()).collect()
}

fn check_surface(mesh: &Mesh, name: &str, place: &KeyPlace) -> Result<(), CaseError> {
    let Some(surface) = mesh.surface(name) else {
        let why = format!("the mesh {} has no surface called `{name}`", mesh.source);
        let known = mesh.surfaces.iter().map(|s| s.name.as_str());
        return Err(place.unknown(why, name, known));
    };
    if surface.faces.is_empty() {
        Err(place.error(
            ErrorKind::Mesh,
            format!("the surface `{name}` has no faces"),
        ))
    } else {
        Ok(())
    }
}

impl Contact {
    fn pair(&self, mesh: &Mesh, steels: &[Steel]) -> Result<ContactPair, CaseError> {
        for side in [&self.upper, &self.lower] {
            if let Partner::Surface(name) = &side.value {
                check_surface(mesh, name, &side.place)?;
            }
        }
        let sides = [&self.upper.value, &self.lower.value];
        let carrier = self
            .carrier
            .unwrap_or_else(|| scene::carrier::choose(mesh, steels, sides, self.preferred));
        Ok(ContactPair {
            name: self.name.value.clone(),
            upper: self.upper.value.clone(),
            lower: self.lower.value.clone(),
            carrier,
            friction: self.friction,
            penalty_factor: self.penalty_factor,
            true_geometry: self.true_geometry,
        })
    }
}
