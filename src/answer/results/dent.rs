//! The dent that a load leaves in a contact surface.

use crate::model::mesh::hexahedron::gauss_volumes;
use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};

use super::hex::{GaussRule, interpolate};
use super::load::cutting;
use crate::model::mesh::Surface;
use crate::model::scene::Scene;

/// The deepest point of a dent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dent {
    /// Inward displacement that stays, positive into the body.
    pub depth: f64,
    /// Undeformed position of the node.
    pub at: [f64; 3],
}

/// Depth of the dent in `surface` of `body` (an index of the mesh's bodies): the normal
/// displacement of its nodes, with the body's best-fit rigid motion removed.
///
/// Give the `displacement` of every node that stays after unloading, the elastic part taken off.
/// `None` for a surface without faces or a body that does not determine its rigid motion.
pub fn dent(
    scene: &Scene,
    displacement: &[[f64; 3]],
    body: usize,
    surface: &Surface,
) -> Option<Dent> {
    let motion = RigidMotion::fit(scene, displacement, body)?;
    let mut normals: BTreeMap<u32, Vector3<f64>> = BTreeMap::new();
    for face in &surface.faces {
        let normal = Vector3::from(face.area_vector(&scene.mesh));
        for node in face.nodes {
            *normals.entry(node).or_insert_with(Vector3::zeros) += normal;
        }
    }
    let mut deepest: Option<Dent> = None;
    for (node, mut normal) in normals {
        let at = scene.mesh.points[node as usize];
        // The mirrored faces cancel this component.
        scene
            .mirrors_through(&at)
            .for_each(|axis| normal[axis] = 0.0);
        let stays = Vector3::from(displacement[node as usize]) - motion.at(at);
        let depth = -stays.dot(&normal.normalize());
        if !depth.is_nan() && deepest.is_none_or(|dent| depth > dent.depth) {
            deepest = Some(Dent { depth, at });
        }
    }
    deepest
}

/// A small rigid motion: a translation and a rotation about a point.
struct RigidMotion {
    about: Vector3<f64>,
    translation: Vector3<f64>,
    rotation: Vector3<f64>,
}

impl RigidMotion {
    /// Least squares over the volume of the whole body, mirrored parts included.
    fn fit(scene: &Scene, displacement: &[[f64; 3]], body: usize) -> Option<Self> {
        let samples = samples(scene, displacement, body)?;
        let volume: f64 = samples.iter().map(|(w, _, _)| w).sum();
        let mean = |of: fn(&Sample) -> Vector3<f64>| {
            samples.iter().map(|s| s.0 * of(s)).sum::<Vector3<f64>>() / volume
        };
        let (about, translation) = (mean(|s| s.1), mean(|s| s.2));
        let (mut inertia, mut moment) = (Matrix3::zeros(), Vector3::zeros());
        for (weight, x, u) in &samples {
            let r = x - about;
            let square = Matrix3::from_diagonal_element(r.norm_squared()) - r * r.transpose();
            inertia += *weight * square;
            moment += *weight * r.cross(&(u - translation));
        }
        let rotation = inertia.lu().solve(&moment)?;
        Some(Self {
            about,
            translation,
            rotation,
        })
    }

    fn at(&self, x: [f64; 3]) -> Vector3<f64> {
        self.translation + self.rotation.cross(&(Vector3::from(x) - self.about))
    }
}

/// Volume, position and displacement of an integration point.
type Sample = (f64, Vector3<f64>, Vector3<f64>);

/// The integration points of the whole body: an image beside it is another body, and moves by itself.
fn samples(scene: &Scene, displacement: &[[f64; 3]], body: usize) -> Option<Vec<Sample>> {
    let rule = GaussRule::new();
    let elements = scene.mesh.bodies.get(body)?.elements.clone();
    let samples = elements.flat_map(|element| {
        let corners = scene.mesh.corners(element);
        let moved = scene.mesh.hexes[element].map(|n| displacement[n as usize]);
        let volumes = gauss_volumes(&corners);
        let points = rule.shape.iter().zip(volumes);
        let sample = |(shape, volume): (&[f64; 8], f64)| -> Sample {
            let [x, u] = [&corners, &moved].map(|nodal| interpolate(shape, nodal).into());
            (volume, x, u)
        };
        points.map(sample).collect::<Vec<Sample>>()
    });
    let mut samples: Vec<Sample> = samples.collect();
    for axis in cutting(scene, body) {
        let mirrored: Vec<Sample> = samples
            .iter()
            .map(|(volume, x, u)| {
                let (mut x, mut u) = (*x, *u);
                x[axis] = -x[axis];
                u[axis] = -u[axis];
                (*volume, x, u)
            })
            .collect();
        samples.extend(mirrored);
    }
    Some(samples)
}
