//! Loads by the names of their surfaces.

use super::axis::Axis;
use crate::ground::geometry::{norm, scale};
use crate::model::mesh::Mesh;
use crate::model::scene::{PlaneMotion, PlaneTurn, RigidPlane, Traction, TractionValue};

/// What loads a surface, at factor one of a step. Its name, by which steps call it, is that of the surface, unless
/// [`named`](Self::named) says otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    pub(super) name: String,
    pub(super) surface: String,
    pub(super) kind: LoadKind,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum LoadKind {
    Pressure(f64),
    Traction([f64; 3]),
    /// In total, spread evenly.
    Force([f64; 3]),
    /// Without name and surface.
    Plane(RigidPlane),
}

impl Load {
    fn new(surface: &str, kind: LoadKind) -> Self {
        Self {
            name: surface.into(),
            surface: surface.into(),
            kind,
        }
    }

    /// Pressure along the inward normal, force per area, compression positive.
    pub fn pressure(surface: &str, pressure: f64) -> Self {
        Self::new(surface, LoadKind::Pressure(pressure))
    }

    /// Force per area in the directions of the axes.
    pub fn traction(surface: &str, traction: [f64; 3]) -> Self {
        Self::new(surface, LoadKind::Traction(traction))
    }

    /// A total force on the modelled part, spread evenly over the area of the surface. Of a force on the whole, a
    /// model that is mirrored once bears half.
    pub fn force(surface: &str, force: [f64; 3]) -> Self {
        Self::new(surface, LoadKind::Force(force))
    }

    /// A rigid plane on the surface that is driven along `axis` by a total force on the modelled part: all nodes move
    /// alike along it, and are free along the other axes. The force has the sign of the axis: negative pushes down.
    pub fn press(surface: &str, axis: Axis, force: f64) -> Self {
        Self::along(surface, axis, PlaneMotion::Driven(force))
    }

    /// A rigid plane on the surface that is moved along `axis` by a prescribed length.
    pub fn travel(surface: &str, axis: Axis, length: f64) -> Self {
        Self::along(surface, axis, PlaneMotion::Held(length))
    }

    /// A rigid plane with a motion of its own along each axis.
    pub fn plane(surface: &str, motion: [PlaneMotion; 3]) -> Self {
        Self::rigid(
            surface,
            RigidPlane {
                motion,
                ..RigidPlane::default()
            },
        )
    }

    /// A rigid plane that may also turn, whatever `plane` has for a name and a surface.
    pub fn rigid(surface: &str, plane: RigidPlane) -> Self {
        Self::new(surface, LoadKind::Plane(plane))
    }

    fn along(surface: &str, axis: Axis, along: PlaneMotion) -> Self {
        let mut motion = [PlaneMotion::Free; 3];
        motion[axis.index()] = along;
        Self::plane(surface, motion)
    }

    /// Calls it `name`.
    pub fn named(mut self, name: &str) -> Self {
        self.name = name.into();
        self
    }

    /// Its numbers.
    pub(super) fn numbers(&self) -> Vec<f64> {
        match self.kind {
            LoadKind::Pressure(p) => vec![p],
            LoadKind::Traction(t) | LoadKind::Force(t) => t.into(),
            LoadKind::Plane(ref plane) => {
                let moved = plane.motion.map(|m| match m {
                    PlaneMotion::Held(x) | PlaneMotion::Driven(x) => x,
                    PlaneMotion::Free => 0.0,
                });
                let turned = plane.turn.map(|t| match t {
                    PlaneTurn::Held(x) | PlaneTurn::Driven(x) => x,
                });
                let about = plane.about.unwrap_or_default();
                [moved, turned, about].concat()
            }
        }
    }

    /// In the terms of a scene, on `mesh`.
    pub(super) fn placed(self, mesh: &Mesh) -> Placed {
        let Self {
            name,
            surface,
            kind,
        } = self;
        let value = match kind {
            LoadKind::Plane(plane) => {
                return Placed::Plane(RigidPlane {
                    name,
                    surface,
                    ..plane
                });
            }
            LoadKind::Pressure(pressure) => TractionValue::Pressure(pressure),
            LoadKind::Traction(traction) => TractionValue::Vector(traction),
            LoadKind::Force(force) => {
                TractionValue::Vector(scale(force, 1.0 / area(mesh, &surface)))
            }
        };
        Placed::Traction(Traction {
            name,
            surface,
            value,
        })
    }
}

/// What a load is in a scene.
pub(super) enum Placed {
    Plane(RigidPlane),
    Traction(Traction),
}

fn area(mesh: &Mesh, surface: &str) -> f64 {
    let faces = mesh.surface(surface).into_iter().flat_map(|s| &s.faces);
    faces.map(|face| norm(face.area_vector(mesh))).sum()
}
