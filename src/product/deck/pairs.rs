//! The contact pairs of a deck, each cut down to the faces that may touch.

use super::bounds::diagonal;
use super::error::InpError;
use crate::model::mesh::Face;
use crate::model::scene::{ContactPair, Partner, Scene, Side};
use crate::render::inp::{DeckPair, Names};
use crate::solver::contact::search::FacetTree;
use crate::solver::solve::travel;

/// Faces further apart than this share of the model, and what is made to travel, are left out: far more than bodies
/// approach.
const NEAR_SHARE: f64 = 0.01;
/// Default pressure per overclosure, in Young's moduli over the shortest edge of a carrier's face.
const STIFFNESS_IN_MODULI: f64 = 20.0;

/// Contact stiffness in stress per length that makes the overclosure a small part of the approach,
/// and is not so stiff that coarse meshes find no balance.
pub fn default_stiffness(scene: &Scene, pairs: &[DeckPair]) -> f64 {
    let moduli = scene.materials.iter().map(|steel| steel.youngs_modulus);
    let edges = pairs
        .iter()
        .flat_map(|pair| &pair.faces[0])
        .flat_map(|face| face.sides(&scene.mesh));
    STIFFNESS_IN_MODULI * moduli.fold(0.0, f64::max) / edges.fold(diagonal(scene), f64::min)
}

/// The pairs of the scene, each cut down to the faces that may touch.
pub fn pairs(scene: &Scene, names: &mut Names) -> Result<Vec<DeckPair>, InpError> {
    let near = NEAR_SHARE * diagonal(scene) + travel(scene);
    scene
        .contacts
        .iter()
        .map(|pair| cut(scene, pair, near, names))
        .collect()
}

fn cut(
    scene: &Scene,
    pair: &ContactPair,
    near: f64,
    names: &mut Names,
) -> Result<DeckPair, InpError> {
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
    Ok(DeckPair {
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
