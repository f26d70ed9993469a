//! A scene, said piece by piece.

use super::axis::Axis;
use super::check::{
    check_controls, check_loads, check_loads_in_mirror, check_mirror, check_names, check_sides,
    check_steels, check_steps, check_supports, check_surface, check_temperatures, check_ties,
};
use super::contact::Contact;
use super::error::BuildError;
use super::load::{Load, Placed};
use super::shape::Shape;
use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::scene::{
    ContactPair, Controls, Partner, Scene, Side, Step, Support, Temperature, Tie, carrier,
};

/// Says a scene piece by piece, and checks it in [`build`](Self::build).
///
/// All numbers are in one consistent unit system, whatever it is: mm, N and MPa; in, kip and ksi; m, N and Pa. What is
/// not said is this: contacts are frictionless, there is one step in which all loads grow to their full size, nothing
/// is mirrored, and the controls are [`Controls::default`].
///
/// ```
/// use brinell::prelude::*;
/// // A steel cube of 10 mm, squeezed by 100 MPa.
/// let side = || uniform(0.0, 10.0, 2);
/// let scene = SceneBuilder::new("cube")
///     .body(Block::new("cube", side(), side(), side()), Steel::elastic(210e3, 0.3))
///     .hold("cube_x_min", Axis::X)
///     .hold("cube_y_min", Axis::Y)
///     .hold("cube_z_min", Axis::Z)
///     .load(Load::pressure("cube_z_max", 100.0))
///     .build()?;
/// assert_eq!(scene.steps.len(), 1);
/// # Ok::<(), BuildError>(())
/// ```
#[derive(Debug, Default)]
pub struct SceneBuilder {
    name: String,
    parts: Vec<Mesh>,
    /// What went wrong first; [`build`](Self::build) tells it.
    wrong: Option<BuildError>,
    steels: Vec<(String, Steel)>,
    contacts: Vec<Contact>,
    ties: Vec<Tie>,
    supports: Vec<Support>,
    loads: Vec<Load>,
    temperatures: Vec<Temperature>,
    steps: Vec<Step>,
    mirrors: Vec<Axis>,
    plane_strain: Vec<Axis>,
    controls: Controls,
}

impl SceneBuilder {
    /// A scene of that name, empty.
    pub fn new(name: &str) -> Self {
        Self {
            name: name.into(),
            ..Self::default()
        }
    }

    /// Adds the bodies of `shape`, all of `steel`.
    pub fn body(mut self, shape: impl Shape, steel: Steel) -> Self {
        match shape.mesh() {
            Ok(mesh) => {
                let named = mesh.bodies.iter().map(|body| (body.name.clone(), steel));
                self.steels.extend(named);
                self.parts.push(mesh);
            }
            Err(error) => self.wrong = self.wrong.or(Some(error)),
        }
        self
    }

    /// Makes the body called `body` of `steel`, whatever it was of before.
    pub fn steel(mut self, body: &str, steel: Steel) -> Self {
        self.steels.push((body.into(), steel));
        self
    }

    /// Adds a contact.
    pub fn contact(mut self, contact: Contact) -> Self {
        self.contacts.push(contact);
        self
    }

    /// Joins two surfaces for good, whether their nodes meet or not.
    pub fn tie(mut self, tie: Tie) -> Self {
        self.ties.push(tie);
        self
    }

    /// Holds a surface along all axes.
    pub fn fix(self, surface: &str) -> Self {
        self.displace(surface, [Some(0.0); 3])
    }

    /// Holds a surface along `axis`.
    pub fn hold(self, surface: &str, axis: Axis) -> Self {
        let mut components = [None; 3];
        components[axis.index()] = Some(0.0);
        self.displace(surface, components)
    }

    /// Prescribes displacements of a surface, `None` where it is free; they grow with the factor of the step.
    pub fn displace(self, surface: &str, components: [Option<f64>; 3]) -> Self {
        self.support(Support {
            name: surface.into(),
            surface: surface.into(),
            components,
            ..Support::default()
        })
    }

    /// Adds a support as the scene knows it: with a name of its own, or linear in position.
    pub fn support(mut self, support: Support) -> Self {
        self.supports.push(support);
        self
    }

    /// Adds a load.
    pub fn load(mut self, load: Load) -> Self {
        self.loads.push(load);
        self
    }

    /// Makes a body warmer by `kelvin` than where it is free of stress; `expansion` is the coefficient of its steel, per
    /// kelvin. Steps call it by the name of the body.
    pub fn warm(self, body: &str, kelvin: f64, expansion: f64) -> Self {
        self.temperature(Temperature {
            name: body.into(),
            body: body.into(),
            expansion,
            value: kelvin,
            gradient: [0.0; 3],
        })
    }

    /// Adds a difference of temperature as the scene knows it: with a name of its own, or linear across the body.
    pub fn temperature(mut self, temperature: Temperature) -> Self {
        self.temperatures.push(temperature);
        self
    }

    /// Adds a step at whose end every load and displacement has the factor `factor`.
    pub fn step(self, name: &str, factor: f64) -> Self {
        self.step_but(name, factor, &[])
    }

    /// Adds a step at whose end all have the factor `factor`, but those that are named here theirs.
    pub fn step_but(mut self, name: &str, factor: f64, factors: &[(&str, f64)]) -> Self {
        let own = factors.iter().map(|(name, f)| ((*name).into(), *f));
        self.steps.push(Step {
            name: name.into(),
            factor,
            factors: own.collect(),
        });
        self
    }

    /// Takes the model as one half of a whole that the plane through the origin across `axis` divides: holds the outer
    /// faces in that plane along `axis`. Forces on planes and surfaces are those on the modelled part.
    pub fn mirror(mut self, axis: Axis) -> Self {
        if !self.mirrors.contains(&axis) {
            self.mirrors.push(axis);
        }
        self
    }

    /// Holds along `axis` all outer faces whose nodes have the smallest or the largest coordinate along it.
    pub fn plane_strain(mut self, axis: Axis) -> Self {
        if !self.plane_strain.contains(&axis) {
            self.plane_strain.push(axis);
        }
        self
    }

    /// Changes the controls.
    pub fn controls(mut self, change: impl FnOnce(&mut Controls)) -> Self {
        change(&mut self.controls);
        self
    }

    /// The scene, checked: every name leads to something, and every number is in its range.
    ///
    /// # Errors
    /// [`BuildError`] names the culprit.
    pub fn build(mut self) -> Result<Scene, BuildError> {
        if let Some(error) = self.wrong.take() {
            return Err(error);
        }
        let mut mesh = Mesh::join(std::mem::take(&mut self.parts))?;
        if mesh.bodies.is_empty() {
            return Err(BuildError::Empty { scene: self.name });
        }
        let materials = check_steels(&mesh, &self.steels)?;
        self.mirrors.sort_by_key(|axis| axis.index());
        for axis in &self.mirrors {
            check_mirror(&mesh, *axis, &self.name)?;
        }
        for axis in std::mem::take(&mut self.plane_strain) {
            for surface in ends(&mut mesh, axis) {
                self = self.hold(&surface, axis);
            }
        }
        check_supports(&mesh, &self.supports)?;
        check_controls(&self.controls, &self.name)?;
        check_loads(&mesh, &self.loads)?;
        for axis in &self.mirrors {
            check_loads_in_mirror(&mesh, &self.loads, *axis)?;
        }
        check_ties(&mesh, &self.ties)?;
        check_temperatures(&mesh, &self.temperatures, &self.mirrors)?;
        let names = self.loads.iter().map(|load| &load.name);
        let names = names.chain(self.temperatures.iter().map(|warm| &warm.name));
        check_steps(&self.steps, &names.collect::<Vec<_>>(), &self.supports)?;
        let contacts = self.contacts.into_iter();
        let contacts = contacts.map(|contact| pair(contact, &mesh, &materials));
        let contacts: Vec<ContactPair> = contacts.collect::<Result<_, _>>()?;
        check_names("contact", contacts.iter().map(|pair| &pair.name))?;
        let joined = contacts
            .iter()
            .filter_map(|pair| match (&pair.upper, &pair.lower) {
                (Partner::Surface(upper), Partner::Surface(lower)) => {
                    Some((&pair.name, [upper, lower]))
                }
                _ => None,
            });
        check_sides(joined)?;
        let (mut rigid_planes, mut tractions) = (Vec::new(), Vec::new());
        for load in self.loads {
            match load.placed(&mesh) {
                Placed::Plane(plane) => rigid_planes.push(plane),
                Placed::Traction(traction) => tractions.push(traction),
            }
        }
        if self.steps.is_empty() {
            self.steps.push(Step::to("load", 1.0));
        }
        let mut scene = Scene {
            name: self.name,
            materials,
            contacts,
            supports: self.supports,
            rigid_planes,
            tractions,
            steps: self.steps,
            mirrors: self.mirrors.iter().map(|axis| axis.index()).collect(),
            temperatures: self.temperatures,
            ties: self.ties,
            half_turn: Vec::new(),
            controls: self.controls,
            mesh,
        };
        scene.hold_mirrors();
        Ok(scene)
    }
}

/// Marks the two ends of the model along `axis`, each as a surface of its own: what looks for edges takes the faces of a
/// support for one plane.
fn ends(mesh: &mut Mesh, axis: Axis) -> [String; 2] {
    let names = ["low", "high"].map(|end| {
        let mut name = format!("{}_{end}_end", axis.letter());
        while mesh.surface(&name).is_some() {
            name.push('_');
        }
        name
    });
    let [low, high] = mesh.range_along(axis.index());
    let near = 1e-6 * (high - low);
    mesh.mark_all(&names[0], |p| p[axis.index()] < low + near);
    mesh.mark_all(&names[1], |p| p[axis.index()] > high - near);
    names
}

/// The pair, its surfaces and numbers checked, and its carrier chosen.
fn pair(contact: Contact, mesh: &Mesh, steels: &[Steel]) -> Result<ContactPair, BuildError> {
    let Contact { mut pair, carrier } = contact;
    let user = format!("the contact `{}`", pair.name);
    let wrong = |what, value, allowed| BuildError::Number {
        what,
        of: pair.name.clone(),
        value,
        allowed,
    };
    for partner in [&pair.upper, &pair.lower] {
        match partner {
            Partner::Surface(name) => check_surface(mesh, &user, name)?,
            Partner::Plane { point, normal } => {
                if let Some(value) = point.iter().chain(normal).find(|c| !c.is_finite()) {
                    return Err(wrong(
                        "a coordinate",
                        *value,
                        "finite, and a normal not zero",
                    ));
                }
            }
        }
    }
    if !(pair.friction >= 0.0 && pair.friction.is_finite()) {
        return Err(wrong("the friction", pair.friction, "zero or positive"));
    }
    let sides = [&pair.upper, &pair.lower];
    let chosen = carrier::choose(mesh, steels, sides, Side::Upper);
    let is_plane = matches!(pair.lower, Partner::Plane { .. });
    pair.carrier = match (is_plane, carrier) {
        (true, _) => Side::Upper,
        (false, wish) => wish.unwrap_or(chosen),
    };
    Ok(pair)
}
