//! Contact pairs: two partners that may touch.

use crate::model::mesh::shape::{Shape, fit};
use crate::model::mesh::{Mesh, Surface};
use serde::Serialize;

/// How far the stress of a loaded edge reaches, of the length of the shorter contact surface.
pub const EDGE_REACH: f64 = 0.02;

/// Two surfaces, or a surface and a rigid plane, that may touch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactPair {
    /// `<upper>-<lower>`.
    pub name: String,
    /// The upper partner,
    pub upper: Partner,
    /// and the lower one.
    pub lower: Partner,
    /// The side whose nodes carry the contact pressure, the non-mortar or slave side; never a plane.
    pub carrier: Side,
    /// Coulomb's coefficient; zero makes no tangential unknowns.
    pub friction: f64,
    /// Multiplies the automatic penalty.
    pub penalty_factor: f64,
    /// Take a surface whose nodes lie on a circular cylinder or sphere as that true shape
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

    /// The bodies of `mesh` that the upper and the lower partner bound; `None` for a plane.
    pub fn bodies(&self, mesh: &Mesh) -> [Option<usize>; 2] {
        [&self.upper, &self.lower].map(|side| side.body(mesh))
    }
}

/// One side of a contact pair.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Partner {
    /// A named surface of the mesh.
    Surface(String),
    /// A rigid half space behind the plane through `point`; `normal` is the outward unit normal.
    Plane {
        /// Any point of it.
        point: [f64; 3],
        /// Unit normal, out of the half space that it bounds.
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

    /// Its true shape; facets where `mesh` has no such surface.
    pub fn shape(&self, mesh: &Mesh) -> Shape {
        match self {
            Self::Surface(name) => (mesh.surface(name)).map_or(Shape::Facets, |s| fit(mesh, s)),
            Self::Plane { point, normal } => Shape::Plane {
                point: *point,
                normal: *normal,
            },
        }
    }

    /// The body of `mesh` that it bounds.
    pub fn body(&self, mesh: &Mesh) -> Option<usize> {
        self.surface(mesh)?.body(mesh)
    }
}

/// Which partner of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Side {
    /// The upper one.
    Upper,
    /// The lower one.
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
