//! Which bodies are held: motions that neither supports nor contact at first touch resists.
//!
//! Contact counts both ways here, as if it could pull: the load keeps it shut. So a motion that is found free has no
//! stiffness against it at all, and a solution would fail, but for what closes under the load: crowned rollers and
//! spheres touch at a point first.

use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use crate::solver::solve::params::{
    CLOSING_EIGENVALUE, DRIVEN_MODE_LOAD, TOUCHING_GAP, UNRESISTED_EIGENVALUE,
};
use crate::solver::solve::rigid::resistance::Resistance;
use crate::solver::solve::rigid::rigid_bodies::RigidBodies;
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::start::extent::extent;

/// A motion of bodies that nothing resists.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeMotion {
    /// The body that moves most.
    pub body: String,
    /// Translation of its middle; the largest component of translation and turn is one.
    pub translation: Vec3,
    /// Turn about its middle, times half the size of the model.
    pub turn: Vec3,
    /// Does the load drive it? Then there is no balance; else nothing but rounding moves it.
    pub driven: bool,
    /// Does contact resist it that is likely to close under the load?
    pub closes: bool,
}

impl FreeMotion {
    /// Would a solution fail by it?
    pub fn is_fatal(&self) -> bool {
        self.driven && !self.closes
    }
}

/// The motions of `scene`, its bodies in touch, that nothing resists; at `rows` contact is likely to close.
pub fn free_motions(scene: &Scene, rows: &[ContactRow]) -> Vec<FreeMotion> {
    let bodies = RigidBodies::new(scene);
    let resisted = |gap: f64| {
        let mut seen = Resistance::new(scene.mesh.bodies.len());
        seen.supports(scene, &bodies);
        seen.planes(scene, &bodies);
        seen.half_turn(scene, &bodies);
        seen.ties(scene, &bodies);
        seen.contacts(scene, (rows, gap), &bodies);
        seen.shared_nodes(&bodies);
        seen
    };
    let load = bodies.load(scene, &|_| 1.0);
    let whole = load.iter().map(|f| f * f).sum::<f64>().sqrt();
    let free = resisted(TOUCHING_GAP * extent(scene)).unresisted(UNRESISTED_EIGENVALUE);
    if free.is_empty() {
        return Vec::new();
    }
    let motions = resisted(f64::INFINITY).among(&free);
    let motions = motions.iter().filter_map(|(motion, resistance)| {
        let work: f64 = motion.iter().zip(&load).map(|(v, f)| v * f).sum();
        let driven = work.abs() > DRIVEN_MODE_LOAD * whole;
        Some(FreeMotion {
            closes: *resistance > CLOSING_EIGENVALUE,
            ..bodies.motion(scene, motion.as_slice(), driven)?
        })
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
            closes: false,
        })
    }
}
