//! Contact pairs: the faces that may touch, and the law between them.

use super::mesh::face_number;
use super::names::Names;
use super::{ContactType, Deck, InpError, number};
use crate::ground::geometry::{norm, sub};
use crate::model::mesh::Face;
use crate::model::scene::{ContactPair, Partner, Scene, Side};
use crate::solver::contact::search::FacetTree;
use std::io::{self, Write};

/// A pair as the deck has it.
pub(super) struct Pair {
    /// Of the law.
    pub name: String,
    /// Of the face sets: carrier (slave) and the other side (master).
    pub sides: [String; 2],
    faces: [Vec<Face>; 2],
    friction: f64,
    pub true_geometry: bool,
}

/// Faces further apart than this share of the model are left out: far more than bodies approach.
const NEAR: f64 = 0.01;
/// Default pressure per overclosure, in Young's moduli over the shortest edge of a carrier's face.
const STIFFNESS: f64 = 20.0;
/// Shear per slip where the nodes stick, as a share of the pressure per overclosure.
const STICK: f64 = 0.1;

/// Contact stiffness in stress per length that makes the overclosure a small part of the approach,
/// and is not so stiff that coarse meshes find no balance.
pub(super) fn default_stiffness(scene: &Scene, pairs: &[Pair]) -> f64 {
    let moduli = scene.materials.iter().map(|steel| steel.youngs_modulus);
    let edges = pairs
        .iter()
        .flat_map(|pair| &pair.faces[0])
        .flat_map(|face| {
            let corners = face.corners(&scene.mesh);
            (0..4).map(move |k| norm(sub(corners[k], corners[(k + 1) % 4])))
        });
    STIFFNESS * moduli.fold(0.0, f64::max) / edges.fold(diagonal(scene), f64::min)
}

/// Diagonal of the box around the model.
pub(super) fn diagonal(scene: &Scene) -> f64 {
    (0..3)
        .map(|axis| span(scene, axis).powi(2))
        .sum::<f64>()
        .sqrt()
}

/// Length of the box around the model along `axis`.
pub(super) fn span(scene: &Scene, axis: usize) -> f64 {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let points = scene.mesh.points.iter();
    let (low, high) = points.fold(ends, |(l, h), p| (l.min(p[axis]), h.max(p[axis])));
    high - low
}

/// The pairs of the scene, each cut down to the faces that may touch.
pub(super) fn pairs(scene: &Scene, names: &mut Names) -> Result<Vec<Pair>, InpError> {
    let near = NEAR * diagonal(scene);
    scene
        .contacts
        .iter()
        .map(|pair| cut(scene, pair, near, names))
        .collect()
}

fn cut(scene: &Scene, pair: &ContactPair, near: f64, names: &mut Names) -> Result<Pair, InpError> {
    let faces = |partner: &Partner| match partner {
        Partner::Surface(name) => match scene.mesh.surface(name) {
            Some(surface) => Ok(surface.faces.clone()),
            None => Err(InpError::NoSurface {
                user: pair.name.clone(),
                surface: name.clone(),
            }),
        },
        Partner::Plane { .. } => Err(InpError::Plane {
            pair: pair.name.clone(),
        }),
    };
    let (upper, lower) = (faces(&pair.upper)?, faces(&pair.lower)?);
    let (carrier, other) = match pair.carrier {
        Side::Upper => (upper, lower),
        Side::Lower => (lower, upper),
    };
    let kept = [
        close_to(scene, &carrier, &other, near),
        close_to(scene, &other, &carrier, near),
    ];
    if kept.iter().any(Vec::is_empty) {
        return Err(InpError::Apart {
            pair: pair.name.clone(),
        });
    }
    Ok(Pair {
        name: names.unused(&pair.name),
        sides: ["carrier", "other"].map(|side| names.unused(&format!("{}_{side}", pair.name))),
        faces: kept,
        friction: pair.friction,
        true_geometry: pair.true_geometry,
    })
}

/// The `faces` whose boxes come within `near` of one of `others`.
fn close_to(scene: &Scene, faces: &[Face], others: &[Face], near: f64) -> Vec<Face> {
    let corners: Vec<_> = others
        .iter()
        .map(|face| face.corners(&scene.mesh))
        .collect();
    let tree = FacetTree::new(&corners);
    let touches = |face: &&Face| !tree.near(&face.corners(&scene.mesh), [near; 3]).is_empty();
    faces.iter().filter(touches).copied().collect()
}

impl Deck<'_> {
    pub(super) fn contact(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.pairs.is_empty() {
            return Ok(());
        }
        let [length, _, stress] = &self.settings.units;
        let mesh = &self.scene.mesh;
        let moduli = self.scene.materials.iter().map(|s| s.youngs_modulus);
        let young = moduli.fold(0.0, f64::max);
        writeln!(
            out,
            "** Contact: pressure = K times overclosure, K = {:.4e} {stress}/{length} = {:.4e} E per\n\
             ** {length}. Softer contact adds to the approach and spreads the pressure; stiffer\n\
             ** contact makes the pressure of coarse meshes oscillate.",
            self.stiffness,
            self.stiffness / young
        )?;
        for pair in &self.pairs {
            for (name, faces) in pair.sides.iter().zip(&pair.faces) {
                writeln!(out, "*SURFACE,NAME={name},TYPE=ELEMENT")?;
                for face in faces {
                    let number = face_number(mesh, face);
                    writeln!(out, "{},S{number}", face.element + 1)?;
                }
            }
            let name = &pair.name;
            writeln!(out, "*SURFACE INTERACTION,NAME={name}")?;
            writeln!(out, "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR")?;
            writeln!(out, "{}", number(self.stiffness))?;
            if pair.friction > 0.0 {
                let stick = STICK * self.stiffness;
                writeln!(
                    out,
                    "*FRICTION\n{},{}",
                    number(pair.friction),
                    number(stick)
                )?;
            }
            let [carrier, other] = &pair.sides;
            let kind = match self.settings.contact {
                ContactType::SurfaceToSurface => "SURFACE TO SURFACE",
                ContactType::NodeToSurface => "NODE TO SURFACE",
                ContactType::Mortar => "MORTAR",
            };
            writeln!(out, "*CONTACT PAIR,INTERACTION={name},TYPE={kind}")?;
            writeln!(out, "{carrier},{other}")?;
        }
        Ok(())
    }
}
