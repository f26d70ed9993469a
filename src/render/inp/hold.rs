//! What holds the bodies: supports, rigid planes, and soft springs until contact does.

use super::contact::{diagonal, span};
use super::names::Names;
use super::{Deck, InpError, number};
use crate::answer::results::load;
use crate::model::mesh::Surface;
use crate::model::scene::{PlaneMotion, RigidPlane, Scene};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};

/// An axis along which the nodes of a rigid plane move as one.
pub(super) struct Driven {
    pub plane: String,
    pub axis: usize,
    /// On the modelled part, at factor one.
    pub force: f64,
    /// The node that stands for all, and the others.
    pub reference: u32,
    pub others: Vec<u32>,
    /// How far the closing step moves it, unless told: the shortening of a solid block.
    pub closing: f64,
}

/// Springs on a body along one axis.
pub(super) struct Springs {
    name: String,
    axis: usize,
    nodes: Vec<u32>,
    /// Of each spring, force per length.
    stiffness: f64,
}

/// The springs of a body and axis together would carry this share of the load if the body moved by
/// a thousandth of the model.
const SHARE: f64 = 1e-4;
/// Springs on a body along an axis, at most.
const SPRINGS: usize = 60;

const AXES: [char; 3] = ['x', 'y', 'z'];

fn surface<'a>(scene: &'a Scene, user: &str, name: &str) -> Result<&'a Surface, InpError> {
    let missing = || InpError::NoSurface {
        user: user.to_string(),
        surface: name.to_string(),
    };
    scene.mesh.surface(name).ok_or_else(missing)
}

/// The driven axes of all rigid planes.
pub(super) fn driven(scene: &Scene) -> Result<Vec<Driven>, InpError> {
    let mut held: BTreeMap<(u32, usize), &str> = BTreeMap::new();
    for support in &scene.supports {
        let nodes = surface(scene, &support.name, &support.surface)?.nodes();
        for axis in (0..3).filter(|a| support.components[*a].is_some()) {
            held.extend(nodes.iter().map(|n| ((*n, axis), support.name.as_str())));
        }
    }
    let mut list = Vec::new();
    for plane in &scene.rigid_planes {
        let face = surface(scene, &plane.name, &plane.surface)?;
        let nodes = face.nodes();
        for (axis, motion) in plane.motion.iter().enumerate() {
            let PlaneMotion::Driven(force) = *motion else {
                continue;
            };
            for node in &nodes {
                if let Some(other) = held.insert((*node, axis), &plane.name) {
                    return Err(InpError::HeldTwice {
                        node: *node as usize + 1,
                        plane: plane.name.clone(),
                        axis: AXES[axis],
                        other: other.to_string(),
                    });
                }
            }
            let [reference, others @ ..] = &nodes[..] else {
                continue;
            };
            list.push(Driven {
                plane: plane.name.clone(),
                axis,
                force,
                reference: *reference,
                others: others.to_vec(),
                closing: block_shortening(scene, plane, face, axis, force),
            });
        }
    }
    Ok(list)
}

/// Shortening of a solid block as long as the model, with the plane's area and its body's modulus.
fn block_shortening(
    scene: &Scene,
    plane: &RigidPlane,
    surface: &Surface,
    axis: usize,
    force: f64,
) -> f64 {
    let factor = scene
        .steps
        .first()
        .map_or(1.0, |s| s.factor_of(&plane.name));
    let area = crate::solver::fem::loads::area(&scene.mesh, surface);
    let body = surface
        .faces
        .first()
        .map_or(0, |f| scene.mesh.body_of(f.element as usize));
    let young = scene.materials.get(body).map_or(1.0, |s| s.youngs_modulus);
    (force * factor).abs() * span(scene, axis) / (young * area)
}

/// Springs for every body and axis that nothing but contact holds.
pub(super) fn springs(scene: &Scene, names: &mut Names) -> Vec<Springs> {
    let mesh = &scene.mesh;
    let mut free = vec![[true; 3]; mesh.bodies.len()];
    let mut taken: BTreeSet<u32> = BTreeSet::new();
    let supports = scene
        .supports
        .iter()
        .map(|s| (&s.surface, s.components.map(|c| c.is_some())));
    let planes = scene.rigid_planes.iter();
    let planes = planes.map(|p| (&p.surface, p.motion.map(|m| m != PlaneMotion::Free)));
    for (name, axes) in supports.chain(planes) {
        for face in mesh.surface(name).map_or(&[][..], |s| &s.faces) {
            taken.extend(face.nodes);
            let body = mesh.body_of(face.element as usize);
            for axis in (0..3).filter(|a| axes[*a]) {
                free[body][axis] = false;
            }
        }
    }
    for partner in scene
        .contacts
        .iter()
        .flat_map(|pair| [&pair.upper, &pair.lower])
    {
        if let crate::model::scene::Partner::Surface(name) = partner {
            taken.extend(mesh.surface(name).iter().flat_map(|s| s.nodes()));
        }
    }
    let total = total_stiffness(scene);
    let mut list = Vec::new();
    for (body, free) in mesh.bodies.iter().zip(free) {
        let hexes = mesh.hexes[body.elements.clone()].iter().flatten();
        let nodes: BTreeSet<u32> = hexes.copied().filter(|n| !taken.contains(n)).collect();
        let nodes: Vec<u32> = nodes.into_iter().collect();
        if nodes.is_empty() {
            continue;
        }
        let stride = nodes.len().div_ceil(SPRINGS);
        for axis in (0..3).filter(|a| free[*a]) {
            let nodes: Vec<u32> = nodes.iter().step_by(stride).copied().collect();
            list.push(Springs {
                name: names.unused(&format!("{}_spring_{}", body.name, AXES[axis])),
                axis,
                stiffness: total / nodes.len() as f64,
                nodes,
            });
        }
    }
    list
}

/// Stiffness of all springs on one body along one axis.
fn total_stiffness(scene: &Scene) -> f64 {
    let force = crate::ground::geometry::norm(load::full(scene)) / load::copies(scene);
    let moduli = scene.materials.iter().map(|s| s.youngs_modulus);
    match force > 0.0 {
        true => SHARE * force / (1e-3 * diagonal(scene)),
        // Nothing but prescribed motion.
        false => 1e-9 * moduli.fold(0.0, f64::max) * diagonal(scene),
    }
}

impl Deck<'_> {
    /// Springs and the equations of rigid planes; boundary conditions stand in the steps.
    pub(super) fn hold(&self, out: &mut dyn Write) -> io::Result<()> {
        if !self.springs.is_empty() {
            writeln!(
                out,
                "** Soft springs where nothing but contact holds a body. All on one body along one\n\
                 ** axis carry {SHARE:e} of the load for a motion of a thousandth of the model."
            )?;
        }
        let mut element = self.scene.mesh.hexes.len();
        for springs in &self.springs {
            let name = &springs.name;
            writeln!(out, "*ELEMENT,TYPE=SPRING1,ELSET={name}")?;
            for node in &springs.nodes {
                element += 1;
                writeln!(out, "{element},{}", node + 1)?;
            }
            writeln!(out, "*SPRING,ELSET={name}\n{}", springs.axis + 1)?;
            writeln!(out, "{}", number(springs.stiffness))?;
        }
        for plane in self.driven.iter().filter(|plane| !plane.others.is_empty()) {
            let (name, axis) = (super::one_line(&plane.plane), AXES[plane.axis]);
            writeln!(out, "** The nodes of {name} move along {axis} as one.")?;
            let (reference, dof) = (plane.reference + 1, plane.axis + 1);
            writeln!(out, "*EQUATION")?;
            for node in &plane.others {
                writeln!(out, "2\n{},{dof},1.,{reference},{dof},-1.", node + 1)?;
            }
        }
        Ok(())
    }

    /// Node sets of the supports and rigid planes, in the order of the mesh.
    pub(super) fn held_sets(&self) -> impl Iterator<Item = &str> {
        let scene = self.scene;
        let supports = scene.supports.iter().map(|s| s.surface.as_str());
        let planes = scene.rigid_planes.iter().map(|p| p.surface.as_str());
        let held: BTreeSet<&str> = supports.chain(planes).collect();
        let surfaces = scene.mesh.surfaces.iter().enumerate();
        let held = surfaces.filter(move |(_, s)| held.contains(s.name.as_str()));
        held.map(|(index, _)| self.names.surface(index))
    }

    /// Everything that is prescribed, at the factors `factor` of supports and planes by name.
    pub(super) fn boundary(
        &self,
        out: &mut dyn Write,
        factor: impl Fn(&str) -> f64,
    ) -> io::Result<()> {
        let mesh = &self.scene.mesh;
        let index = |name: &str| mesh.surfaces.iter().position(|s| s.name == name);
        writeln!(out, "*BOUNDARY,OP=NEW")?;
        for support in &self.scene.supports {
            let Some(index) = index(&support.surface) else {
                continue;
            };
            let factor = factor(&support.name);
            for axis in 0..3 {
                let Some(value) = support.components[axis] else {
                    continue;
                };
                let dof = axis + 1;
                if support.gradient[axis] == [0.0; 3] {
                    let (set, value) = (self.names.surface(index), value * factor);
                    writeln!(out, "{set},{dof},{dof},{}", number(value))?;
                    continue;
                }
                for node in mesh.surfaces[index].nodes() {
                    let value = support.displacement(axis, &mesh.points[node as usize]);
                    let value = number(value.unwrap_or(0.0) * factor);
                    writeln!(out, "{},{dof},{dof},{value}", node + 1)?;
                }
            }
        }
        for plane in &self.scene.rigid_planes {
            let Some(index) = index(&plane.surface) else {
                continue;
            };
            for (axis, motion) in plane.motion.iter().enumerate() {
                if let PlaneMotion::Held(value) = motion {
                    let (set, dof) = (self.names.surface(index), axis + 1);
                    let value = number(value * factor(&plane.name));
                    writeln!(out, "{set},{dof},{dof},{value}")?;
                }
            }
        }
        Ok(())
    }
}
