//! The model as the solver sees it: bodies, contact pairs, supports, loads and steps.
//!
//! A scene knows nothing of bearings, case files or units: all numbers are in one consistent
//! unit system, whatever it is.

pub mod carrier;
mod unloading;

use crate::analytic::{DomainError, Elastic, contact_compliance};
use crate::ground::geometry::planes_through;
use crate::model::material::Steel;
use crate::model::mesh::{Mesh, Surface};
use serde::Serialize;
pub use unloading::LITTLE;

/// Everything the solver needs.
#[derive(Debug, Clone, Serialize)]
pub struct Scene {
    /// Its name, for messages.
    pub name: String,
    /// Bodies and surfaces.
    pub mesh: Mesh,
    /// One steel a body, in the order of [`Mesh::bodies`].
    pub materials: Vec<Steel>,
    /// Pairs that may touch.
    pub contacts: Vec<ContactPair>,
    /// Prescribed displacements.
    pub supports: Vec<Support>,
    /// Surfaces that move as planes.
    pub rigid_planes: Vec<RigidPlane>,
    /// Forces per area.
    pub tractions: Vec<Traction>,
    /// What grows when, one after the other.
    pub steps: Vec<Step>,
    /// Axes (0, 1, 2) that the model is mirrored along: `[0, 1]` is a quarter model.
    pub mirrors: Vec<usize>,
    /// Tolerances and choices of the solver.
    pub controls: Controls,
}

impl Scene {
    /// Axes whose mirror plane the point `at` of the mesh lies on.
    pub fn mirrors_through(&self, at: &[f64; 3]) -> impl Iterator<Item = usize> {
        planes_through(&self.mirrors, at)
    }

    /// C_E of Hertz's contact between the steels of `pair`; a rigid plane does not give.
    ///
    /// # Errors
    /// [`DomainError`] where both sides are rigid, or a steel is none.
    pub fn compliance(&self, pair: &ContactPair) -> Result<f64, DomainError> {
        let elastic = |partner: &Partner| {
            let body = partner.body(&self.mesh);
            match body.and_then(|body| self.materials.get(body)) {
                Some(steel) => Elastic::new(steel.youngs_modulus, steel.poissons_ratio),
                None => Ok(Elastic::RIGID),
            }
        };
        contact_compliance(elastic(&pair.upper)?, elastic(&pair.lower)?)
    }

    /// Factor of the support, plane or traction called `name` at share `time` of the step with that index. Before the
    /// first step it is zero; beyond the last it stays.
    pub fn factor(&self, name: &str, step: usize, time: f64) -> f64 {
        let before = step.checked_sub(1).and_then(|i| self.steps.get(i));
        let before = before.map_or(0.0, |step| step.factor_of(name));
        let after = (self.steps.get(step)).map_or(before, |step| step.factor_of(name));
        before + time * (after - before)
    }
}

/// Two surfaces, or a surface and a rigid plane, that may touch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactPair {
    /// `<upper>-<lower>`.
    pub name: String,
    /// One side; forces are told as they act on the other.
    pub upper: Partner,
    /// The other side.
    pub lower: Partner,
    /// The side whose nodes carry the contact pressure; never a plane.
    pub carrier: Side,
    /// Coulomb's coefficient; zero makes no tangential unknowns.
    pub friction: f64,
    /// Multiplies the automatic penalty.
    pub penalty_factor: f64,
    /// Take a surface whose nodes lie on a circular cylinder, cone or sphere as that true shape
    /// in the initial gap, not as its facets.
    pub true_geometry: bool,
}

impl ContactPair {
    /// Both partners, the one that carries the pressure first.
    pub fn carrier_first(&self) -> [&Partner; 2] {
        match self.carrier {
            Side::Upper => [&self.upper, &self.lower],
            Side::Lower => [&self.lower, &self.upper],
        }
    }
}

/// One side of a contact pair.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Partner {
    /// A named surface of the mesh.
    Surface(String),
    /// A rigid half space behind the plane through `point`; `normal` is the outward unit normal.
    Plane {
        /// A point of it.
        point: [f64; 3],
        /// Outward unit normal.
        normal: [f64; 3],
    },
}

impl Partner {
    /// The surface of `mesh` that this is; `None` for a plane, and where there is none.
    pub fn surface<'m>(&self, mesh: &'m Mesh) -> Option<&'m Surface> {
        match self {
            Self::Surface(name) => mesh.surface(name),
            Self::Plane { .. } => None,
        }
    }

    /// The body of `mesh` that it bounds.
    pub fn body(&self, mesh: &Mesh) -> Option<usize> {
        let face = self.surface(mesh)?.faces.first()?;
        Some(mesh.body_of(face.element as usize))
    }
}

/// Which partner of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Side {
    /// The one called upper.
    Upper,
    /// The one called lower.
    Lower,
}

impl Side {
    /// Turns a force between a carrier on this side and the other side into that on the lower body.
    pub fn sign(self) -> f64 {
        match self {
            Self::Upper => 1.0,
            Self::Lower => -1.0,
        }
    }
}

/// Prescribed displacement components on a surface: constant, or linear in position.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Support {
    /// By which steps call it.
    pub name: String,
    /// Name of the surface.
    pub surface: String,
    /// Displacement of each component, `None` where free. Times the factor of the step.
    pub components: [Option<f64>; 3],
    /// ∂u_i/∂x_j of each prescribed component i, by undeformed position: a node at `x` is moved
    /// by `components[i]` + Σ `gradient[i][j]` x_j. Times the factor of the step.
    pub gradient: [[f64; 3]; 3],
}

impl Support {
    /// Displacement along `axis` of a node at `x`, at factor one; `None` where free.
    pub fn displacement(&self, axis: usize, x: &[f64; 3]) -> Option<f64> {
        let row = &self.gradient[axis];
        self.components[axis].map(|c| c + row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
    }
}

/// A surface that translates as a rigid plane without rotating.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RigidPlane {
    /// By which steps call it.
    pub name: String,
    /// Name of the surface.
    pub surface: String,
    /// Along x, y and z.
    pub motion: [PlaneMotion; 3],
}

/// What a rigid plane does along one axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum PlaneMotion {
    /// Displaced by this much (times the factor of the step), all nodes alike.
    Held(f64),
    /// Free to move, all nodes alike, under this total force on the *modelled* part
    /// (times the factor of the step).
    Driven(f64),
    /// Every node free.
    Free,
}

/// A force per area on a surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Traction {
    /// By which steps call it.
    pub name: String,
    /// Name of the surface.
    pub surface: String,
    /// How large, and which way.
    pub value: TractionValue,
}

/// How large a traction is, and which way, in the stress unit of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum TractionValue {
    /// Compression positive, along the inward normal.
    Pressure(f64),
    /// In the directions of the axes.
    Vector([f64; 3]),
}

/// One step: loads and prescribed displacements move linearly to these factors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// Its name, for messages.
    pub name: String,
    /// Factor at the end of the step for every support, plane and traction not named below.
    pub factor: f64,
    /// Factors by name of support, plane or traction.
    pub factors: Vec<(String, f64)>,
}

impl Step {
    /// The factor that the support, plane or traction called `name` has at the end of the step.
    pub fn factor_of(&self, name: &str) -> f64 {
        let own = self.factors.iter().find(|(n, _)| n == name);
        own.map_or(self.factor, |(_, factor)| *factor)
    }
}

/// Numerical controls, all relative and without units.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Controls {
    /// Residual force relative to the applied force.
    pub residual: f64,
    /// Largest penetration relative to the approach of the bodies.
    pub penetration: f64,
    /// First increment, as a share of a step.
    pub first_increment: f64,
    /// Smallest increment, as a share of a step.
    pub smallest_increment: f64,
    /// Newton iterations an increment may take before it is cut back.
    pub iterations: usize,
    /// Solve once more in increments twice as large, where something yields, for what the increments are
    /// worth?
    pub increment_error: bool,
    /// Integrate plasticity? `false` keeps every body elastic.
    pub plasticity: bool,
    /// The hexahedron that all bodies are made of.
    pub element: ElementKind,
    /// How linear systems are solved.
    pub solver: SolverKind,
    /// Times the initial gap up to which contact is integrated at first. The answer does not depend on
    /// it, as contact is found wherever bodies meet: that is what it is there to prove.
    pub contact_reach: f64,
}

/// How linear systems are solved. The answer does not depend on it; time and memory do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum SolverKind {
    /// Whichever should be quicker.
    #[default]
    Auto,
    /// Bodies condensed onto contact and plastic flow, and a factor of what is left.
    Direct,
    /// A factor of each of many small parts and conjugate directions: the least memory.
    Divided,
}

/// A formulation of the eight-node hexahedron.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum ElementKind {
    /// Element-mean volumetric strain: "C3D8" of Abaqus. Robust, but stiff in bending.
    #[default]
    Bbar,
    /// Plain and fully integrated: "C3D8" of CalculiX. For comparison: stiffer still, and it locks
    /// in plastic flow.
    Full,
    /// Incompatible modes, as in "C3D8I": bends exactly where it is a brick.
    Enhanced,
}

impl Default for Controls {
    fn default() -> Self {
        Self {
            residual: 1e-8,
            penetration: 1e-8,
            first_increment: 0.25,
            smallest_increment: 1e-4,
            iterations: 40,
            increment_error: true,
            plasticity: true,
            element: ElementKind::default(),
            solver: SolverKind::default(),
            contact_reach: 1.0,
        }
    }
}
