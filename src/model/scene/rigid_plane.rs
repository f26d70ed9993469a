//! Surfaces that move as rigid planes.
//!
//! A plane moves by a translation t of its point c and turns by small angles ω about it: a node at r moves along each
//! axis that is not free by the component of t + ω × (r − c). A force on the plane acts at c, a moment about it.

use super::loads::PlaneMotion;
use crate::ground::geometry::{Vec3, add, cross, scale, sub};
use crate::model::mesh::Mesh;
use nalgebra::{Matrix3, Vector3};
use serde::Serialize;

/// A surface that moves as a rigid plane, along the axes that are not free. Unless told to, it does not turn.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RigidPlane {
    /// What steps and messages call it.
    pub name: String,
    /// The surface of the mesh.
    pub surface: String,
    /// What it does along x, y and z.
    pub motion: [PlaneMotion; 3],
    /// How it turns about axes through its point along x, y and z.
    pub turn: [PlaneTurn; 3],
    /// The point that it turns about, where forces act and that moments are about; `None` for the
    /// [middle](Mesh::middle_of) of the surface.
    pub about: Option<Vec3>,
}

/// How a rigid plane turns about one axis. Angles are small: what they move is linear in them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum PlaneTurn {
    /// Turned by this angle in radians (times the factor of the step).
    Held(f64),
    /// Free to turn under this moment on the *modelled* part, a force times a length (times the factor of the step).
    Driven(f64),
}

impl Default for PlaneTurn {
    fn default() -> Self {
        Self::Held(0.0)
    }
}

/// How a rigid plane stands: the motion of its point, a length, and the angles it has turned by, in radians.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pose {
    /// Of its point; along axes where every node is free the mean of all.
    pub travel: Vec3,
    /// About axes through it.
    pub turn: Vec3,
}

impl RigidPlane {
    /// Does it turn, or may it?
    pub fn turns(&self) -> bool {
        self.turn != [PlaneTurn::Held(0.0); 3]
    }

    /// May it turn by an angle that is not given?
    pub fn turns_freely(&self) -> bool {
        self.turn.iter().any(|t| matches!(t, PlaneTurn::Driven(_)))
    }

    /// Is it turned by a given angle, and by no other?
    pub fn is_turned(&self) -> bool {
        self.turns() && !self.turns_freely()
    }

    /// The point that it turns about, in `mesh`, which is mirrored along the axes `mirrors`.
    pub fn point(&self, mesh: &Mesh, mirrors: &[usize]) -> Vec3 {
        let middle = || mesh.middle_of(&self.surface, mirrors);
        self.about.unwrap_or_else(middle)
    }

    /// Motion along `axis` of a point at `arm` from the plane's, by the given angles, at factor one.
    pub fn given_turn(&self, axis: usize, arm: Vec3) -> f64 {
        let angles = self.turn.map(|turn| match turn {
            PlaneTurn::Held(angle) => angle,
            PlaneTurn::Driven(_) => 0.0,
        });
        cross(angles, arm)[axis]
    }

    /// The axes that it is free to turn about, each with the motion along `axis` of a point at `arm` for an angle of
    /// one. Axes about which a turn does not move the point are left out.
    pub fn free_turns(&self, axis: usize, arm: Vec3) -> impl Iterator<Item = (usize, f64)> {
        let free = (0..3).filter(|about| matches!(self.turn[*about], PlaneTurn::Driven(_)));
        let levers = free.map(move |about| {
            let mut unit = [0.0; 3];
            unit[about] = 1.0;
            (about, cross(unit, arm)[axis])
        });
        levers.filter(|(_, lever)| *lever != 0.0)
    }

    /// How it stands where its nodes are displaced by `u`, node by node: they are displaced as a rigid plane is.
    pub fn pose(&self, mesh: &Mesh, mirrors: &[usize], u: &[Vec3]) -> Pose {
        let nodes = mesh.surface(&self.surface).map(|s| s.nodes());
        let nodes = nodes.unwrap_or_default();
        let mean = |of: &dyn Fn(usize) -> Vec3| {
            let sum = nodes.iter().fold([0.0; 3], |s, n| add(s, of(*n as usize)));
            scale(sum, 1.0 / nodes.len().max(1) as f64)
        };
        let (middle, moved) = (mean(&|n| mesh.points[n]), mean(&|n| u[n]));
        let axes = || (0..3).filter(|axis| self.motion[*axis] != PlaneMotion::Free);
        let turning = (0..3).filter(|about| self.turn[*about] != PlaneTurn::Held(0.0));
        let turning: Vec<usize> = turning.collect();
        // Normal equations of the angles, about the mean of the nodes: u_a = ω · (d × e_a).
        let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for node in &nodes {
            let arm = sub(mesh.points[*node as usize], middle);
            let own = sub(u[*node as usize], moved);
            for axis in axes() {
                let mut unit = [0.0; 3];
                unit[axis] = 1.0;
                let lever = cross(arm, unit);
                for i in &turning {
                    right[*i] += lever[*i] * own[axis];
                    for j in &turning {
                        matrix[(*i, *j)] += lever[*i] * lever[*j];
                    }
                }
            }
        }
        let size = matrix.trace();
        let inverse = matrix.pseudo_inverse(1e-12 * size);
        let turn: Vec3 = inverse.map_or([0.0; 3], |inverse| (inverse * right).into());
        let mut travel = moved;
        let further = cross(turn, sub(self.point(mesh, mirrors), middle));
        axes().for_each(|axis| travel[axis] += further[axis]);
        Pose { travel, turn }
    }
}
