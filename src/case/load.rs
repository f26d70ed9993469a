//! Supports, rigid planes, pressures and tractions, and the steps that drive them.

use super::assumption::Assumption;
use super::axes::displacements;
use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::{Field, Table};
use super::place::Located;
use super::rigid_plane;
use super::steel::Steels;
use super::temperature::{self, name_of_its_own};
use crate::ground::units::Dimension;
use crate::model::scene::{
    PlaneMotion, PlaneTurn, RigidPlane, Step, Support, Temperature, Traction, TractionValue,
};

/// What acts on the surfaces of a scene. Each entry is marked at its surface.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Loads {
    /// Supports, with their places in the file.
    pub supports: Vec<Located<Support>>,
    /// Rigid planes.
    pub planes: Vec<Located<RigidPlane>>,
    /// Pressures and tractions.
    pub tractions: Vec<Located<Traction>>,
    /// Temperatures, marked at their bodies.
    pub temperatures: Vec<Located<Temperature>>,
    /// Steps, in their order.
    pub steps: Vec<Step>,
}

impl Loads {
    /// Reads `[[support]]`, `[[rigid_plane]]`, `[[pressure]]`, `[[traction]]`, `[[temperature]]` and `[[step]]`.
    /// `mirrors` are the axes of the symmetry planes: forces are given for the whole and come
    /// out for the modelled part.
    pub(super) fn read(
        root: &Table,
        mirrors: &[usize],
        (steels, assumptions): (&Steels, &mut Vec<Assumption>),
    ) -> Result<Self, CaseError> {
        let mut loads = Self::default();
        let mut names: Vec<String> = Vec::new();
        for table in root.tables("support")? {
            let table = table.only(&keys::SUPPORT)?;
            let (name, surface) = named(&table, &mut names)?;
            let components = displacements(&table)?;
            if components == [None; 3] {
                let message = format!("the support `{name}` holds nothing");
                let help = "give fixed = \"xyz\" or displacement = { z = … }";
                return Err(table.error(ErrorKind::MissingKey, message).help(help));
            }
            loads.supports.push(surface.map(|surface| Support {
                name,
                surface,
                components,
                ..Support::default()
            }));
        }
        for table in root.tables("rigid_plane")? {
            let table = table.only(&keys::RIGID_PLANE)?;
            let (name, surface) = named(&table, &mut names)?;
            let plane = rigid_plane::read(&table, mirrors)?;
            loads.planes.push(surface.map(|surface| RigidPlane {
                name,
                surface,
                ..plane
            }));
        }
        for (key, pressure) in [("pressure", true), ("traction", false)] {
            for table in root.tables(key)? {
                let table = table.only(&keys::LOAD)?;
                let (name, surface) = named(&table, &mut names)?;
                let field = table.need("value")?;
                let value = if pressure {
                    TractionValue::Pressure(field.quantity(Dimension::STRESS)?.value)
                } else {
                    TractionValue::Vector(field.vector(Dimension::STRESS)?.value)
                };
                let traction = surface.map(|surface| Traction {
                    name,
                    surface,
                    value,
                });
                loads.tractions.push(traction);
            }
        }
        let known = (&mut names, assumptions);
        loads.temperatures = temperature::read(root, steels, known)?;
        let help = "mesh the whole, and drop this axis from `symmetry`";
        temperature::check_symmetry(root, mirrors, help)?;
        loads.steps = steps(root, &names)?;
        if !loads.moves() {
            let message = "the case has no load: no pressure, traction, force, displacement or temperature that a step does not \
                 take to zero";
            let help = "an interference fit alone is no load by its mesh: mesh its bodies in touch, and warm the inner one by the interference \
                 over its size and thermal expansion";
            return Err(root.error(ErrorKind::MissingKey, message).help(help));
        }
        Ok(loads)
    }

    /// Is there anything that is not zero, in some step?
    fn moves(&self) -> bool {
        let acts = |name: &str| self.steps.iter().any(|step| step.factor_of(name) != 0.0);
        let moved = |d: &Option<f64>| d.is_some_and(|d| d != 0.0);
        let driven = |m: &PlaneMotion| match m {
            PlaneMotion::Held(v) | PlaneMotion::Driven(v) => *v != 0.0,
            PlaneMotion::Free => false,
        };
        let turned = |t: &PlaneTurn| match t {
            PlaneTurn::Held(v) | PlaneTurn::Driven(v) => *v != 0.0,
        };
        let mut supports = self.supports.iter().map(|s| &s.value);
        let mut planes = self.planes.iter().map(|p| &p.value);
        let mut tractions = self.tractions.iter().map(|t| &t.value);
        self.temperatures.iter().any(|t| acts(&t.value.name))
            || supports.any(|s| acts(&s.name) && s.components.iter().any(moved))
            || planes.any(|p| {
                acts(&p.name) && (p.motion.iter().any(driven) || p.turn.iter().any(turned))
            })
            || tractions.any(|t| {
                acts(&t.name)
                    && match t.value {
                        TractionValue::Pressure(p) => p != 0.0,
                        TractionValue::Vector(v) => v.iter().any(|c| *c != 0.0),
                    }
            })
    }
}

/// The name of an entry, and its surface.
fn named(table: &Table, names: &mut Vec<String>) -> Result<(String, Located<String>), CaseError> {
    let surface = table.need("surface")?.string()?;
    Ok((name_of_its_own(table, &surface, names)?, surface))
}

/// The steps; by default one, to the full load.
fn steps(root: &Table, names: &[String]) -> Result<Vec<Step>, CaseError> {
    let mut steps: Vec<Step> = Vec::new();
    for table in root.tables("step")? {
        let table = table.only(&keys::STEP)?;
        let name = table.need("name")?.string()?;
        if steps.iter().any(|step| step.name == name.value) {
            let why = format!("there are two steps called `{}`", name.value);
            return Err(name.place.error(ErrorKind::Duplicate, why));
        }
        let factor = table.maybe("factor", Field::ratio)?;
        let factors = table.maybe("factors", |field| factors(field, names))?;
        steps.push(Step {
            name: name.value,
            factor: factor.map_or(1.0, |f| f.value),
            factors: factors.unwrap_or_default(),
        });
    }
    if steps.is_empty() {
        steps.push(Step::to("load", 1.0));
    }
    Ok(steps)
}

fn factors(field: &Field, names: &[String]) -> Result<Vec<(String, f64)>, CaseError> {
    let table = field.table()?;
    let factor = |name: &str| {
        if !names.iter().any(|known| known == name) {
            let why = "is neither a support nor a rigid plane nor a load nor a temperature";
            let known = names.iter().map(String::as_str);
            return Err(table.place_of_key(name).unknown(why, name, known));
        }
        Ok((name.to_string(), table.need(name)?.ratio()?.value))
    };
    table.keys().into_iter().map(factor).collect()
}
