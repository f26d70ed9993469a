//! Which bodies are held: motions that neither supports nor contact at first touch resists.

use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use crate::solver::solve::params::{DRIVEN_MODE_LOAD, UNRESISTED_EIGENVALUE};
use crate::solver::solve::rigid::resistance::Resistance;
use crate::solver::solve::rigid::rigid_bodies::RigidBodies;
use crate::solver::solve::rows::contact_row::ContactRow;

/// A motion of bodies that nothing resists.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeMotion {
    /// The body that moves most.
    pub body: String,
    /// Translation and turn about its middle, the larger of the two of length one.
    pub translation: Vec3,
    pub turn: Vec3,
    /// Does the load drive it? Then there is no balance; else nothing but rounding moves it.
    pub driven: bool,
}

/// The motions of `scene`, its bodies in touch at `rows`, that nothing resists.
pub fn free_motions(scene: &Scene, rows: &[ContactRow]) -> Vec<FreeMotion> {
    let frames = RigidBodies::new(scene);
    let mut seen = Resistance::new(scene.mesh.bodies.len());
    seen.supports(scene, &frames);
    seen.planes(scene, &frames);
    seen.contacts(scene, rows, &frames);
    seen.shared_nodes(&frames);
    let load = frames.load(scene, &|_| 1.0);
    let whole = load.iter().map(|f| f * f).sum::<f64>().sqrt();
    let free = seen.unresisted(UNRESISTED_EIGENVALUE);
    let motions = free.iter().filter_map(|motion| {
        let work: f64 = motion.iter().zip(&load).map(|(v, f)| v * f).sum();
        frames.motion(
            scene,
            motion.as_slice(),
            work.abs() > DRIVEN_MODE_LOAD * whole,
        )
    });
    motions.collect()
}

impl RigidBodies {
    /// The motion of the body that takes most part in `vector`.
    pub fn motion(&self, scene: &Scene, vector: &[f64], driven: bool) -> Option<FreeMotion> {
        let of = |body: usize| &vector[6 * body..6 * body + 6];
        let amount = |body: usize| of(body).iter().map(|c| c * c).sum::<f64>();
        let bodies = 0..self.middles.len();
        let body = bodies.max_by(|a, b| amount(*a).total_cmp(&amount(*b)))?;
        let most = of(body).iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let part = |from: usize| std::array::from_fn(|i| of(body)[from + i] / most);
        Some(FreeMotion {
            body: scene.mesh.bodies.get(body)?.name.clone(),
            translation: part(0),
            turn: part(3),
            driven,
        })
    }
}
