//! The model as the solver sees it: bodies, contact pairs, supports, loads and steps.
//!
//! A scene knows nothing of bearings, case files or units: all numbers are in one consistent
//! unit system, whatever it is.

pub mod carrier;
mod controls;
pub mod held_planes;
mod joined;
mod loads;
mod mirrors;
mod pair;
mod rigid_plane;
mod step;
mod temperature;
mod tie;
mod unloading;

use crate::analytic::{DomainError, Elastic, contact_compliance};
use crate::ground::geometry::planes_through;
use crate::model::material::Steel;
use crate::model::mesh::{Mesh, Surface};
pub use controls::{Controls, ElementKind, SolverKind};
pub use joined::{joined, joined_to};
pub use loads::{PlaneMotion, Support, Traction, TractionValue};
pub use mirrors::{OFF_PLANE, faces_in_plane, reaches_into_plane};
pub use pair::{ContactPair, EDGE_REACH, Partner, Side};
pub use rigid_plane::{PlaneTurn, Pose, RigidPlane};
use serde::Serialize;
pub use step::Step;
pub use temperature::Temperature;
pub use tie::{TOLERANCE_SHARE, Tie};
pub use unloading::UNLOADED_SHARE;

/// Everything the solver needs.
#[derive(Debug, Clone, Serialize)]
pub struct Scene {
    /// What messages and results call it.
    pub name: String,
    /// The bodies, undeformed.
    pub mesh: Mesh,
    /// One steel a body, in the order of [`Mesh::bodies`].
    pub materials: Vec<Steel>,
    /// Pairs of surfaces that may touch.
    pub contacts: Vec<ContactPair>,
    /// Pairs of surfaces that are joined.
    pub ties: Vec<Tie>,
    /// Prescribed displacements.
    pub supports: Vec<Support>,
    /// Surfaces that move as rigid planes.
    pub rigid_planes: Vec<RigidPlane>,
    /// Forces per area on surfaces.
    pub tractions: Vec<Traction>,
    /// Differences of temperature of bodies.
    pub temperatures: Vec<Temperature>,
    /// Load steps, one after the other.
    pub steps: Vec<Step>,
    /// Axes (0, 1, 2) that the model is mirrored along: `[0, 1]` is a quarter model.
    pub mirrors: Vec<usize>,
    /// Nodes of a cut that is its own image under a [half turn](crate::model::half_turn), and the image of each: the same
    /// node on the axis. Empty where there is no such cut.
    pub half_turn: Vec<[u32; 2]>,
    /// Tolerances and choices of the solver.
    pub controls: Controls,
}

impl Scene {
    /// Bodies of one steel and one step to the full load, with nothing on them yet.
    pub fn bare(name: impl Into<String>, mesh: Mesh, steel: Steel) -> Self {
        Self {
            name: name.into(),
            materials: vec![steel; mesh.bodies.len()],
            mesh,
            steps: vec![Step::to("load", 1.0)],
            contacts: Vec::new(),
            ties: Vec::new(),
            supports: Vec::new(),
            rigid_planes: Vec::new(),
            tractions: Vec::new(),
            temperatures: Vec::new(),
            mirrors: Vec::new(),
            half_turn: Vec::new(),
            controls: Controls::default(),
        }
    }

    /// The surface whose nodes carry the pressure of contact pair `pair`; `None` where the mesh has none.
    pub fn carrier(&self, pair: usize) -> Option<&Surface> {
        let [carrier, _] = self.contacts.get(pair)?.carrier_first();
        carrier.surface(&self.mesh)
    }

    /// Does a prescribed motion load it?
    pub fn is_moved(&self) -> bool {
        let moves = |motion: &PlaneMotion| matches!(motion, PlaneMotion::Held(u) if *u != 0.0);
        let mut planes = self.rigid_planes.iter();
        planes.any(|plane| plane.motion.iter().any(moves))
            || self.supports.iter().any(Support::moves)
    }

    /// Is there a body that may yield?
    pub fn may_yield(&self) -> bool {
        self.controls.plasticity && self.materials.iter().any(|steel| !steel.is_elastic())
    }

    /// Do bodies rub, wherever they touch?
    pub fn rubs(&self) -> bool {
        self.contacts.iter().any(|pair| pair.friction > 0.0)
    }

    /// Axes whose mirror plane the point `at` of the mesh lies on.
    pub fn mirrors_through(&self, at: &[f64; 3]) -> impl Iterator<Item = usize> {
        planes_through(&self.mirrors, at)
    }

    /// Axes whose mirror plane some of these `nodes` of the mesh lie on.
    pub fn mirrors_that_cut(&self, nodes: impl Iterator<Item = u32> + Clone) -> Vec<usize> {
        let cuts = |axis: &usize| {
            let mut points = nodes.clone().map(|node| &self.mesh.points[node as usize]);
            points.any(|at| self.mirrors_through(at).any(|through| through == *axis))
        };
        self.mirrors.iter().copied().filter(cuts).collect()
    }

    /// C_E of Hertz's contact between the steels of `pair`; a rigid plane does not give.
    ///
    /// # Errors
    /// [`DomainError`] where both sides are rigid, or a steel is none.
    pub fn compliance(&self, pair: &ContactPair) -> Result<f64, DomainError> {
        contact_compliance(self.elastic_of(&pair.upper)?, self.elastic_of(&pair.lower)?)
    }

    /// What of it one side has.
    pub fn compliance_of(&self, side: &Partner) -> Result<f64, DomainError> {
        contact_compliance(self.elastic_of(side)?, Elastic::RIGID)
    }

    fn elastic_of(&self, side: &Partner) -> Result<Elastic, DomainError> {
        match side
            .body(&self.mesh)
            .and_then(|body| self.materials.get(body))
        {
            Some(steel) => Elastic::new(steel.youngs_modulus, steel.poissons_ratio),
            None => Ok(Elastic::RIGID),
        }
    }

    /// The lesser yield stress of the bodies of `pair`; infinite where none of them may yield.
    pub fn yield_stress(&self, pair: &ContactPair) -> f64 {
        let of = |side: &Partner| {
            let steel = self.materials.get(side.body(&self.mesh)?)?;
            Some(steel.yield_stress)
        };
        [&pair.upper, &pair.lower]
            .into_iter()
            .filter_map(of)
            .filter(|_| self.controls.plasticity)
            .fold(f64::INFINITY, f64::min)
    }

    /// Factor of the support, plane, traction or temperature called `name` at share `time` of the step with that index. Before the
    /// first step it is zero; beyond the last it stays.
    pub fn factor(&self, name: &str, step: usize, time: f64) -> f64 {
        let before = step.checked_sub(1).and_then(|i| self.steps.get(i));
        let before = before.map_or(0.0, |step| step.factor_of(name));
        let after = (self.steps.get(step)).map_or(before, |step| step.factor_of(name));
        before + time * (after - before)
    }
}
