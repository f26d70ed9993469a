//! The planes of symmetry at which the bodies of a contact end, whether the scene names them or supports make them.

use std::collections::BTreeSet;

use super::line_frame::axis_of;
use crate::ground::geometry::{Vec3, range};
use crate::model::scene::{PlaneMotion, RigidPlane, Scene, Support};

/// Those square to one axis, at which both bodies of a pair end and their mirror images go on.
pub struct SymmetryPlanes {
    /// Their coordinates.
    at: Vec<f64>,
    /// Does the scene name one?
    named: bool,
    /// Where both bodies end together, and on no plane.
    free_ends: Vec<f64>,
    /// Coordinates that differ by no more are the same.
    same: f64,
}

/// Of nodes by their coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The first of them.
    Low,
    /// The last.
    High,
}

impl SymmetryPlanes {
    /// Those of contact pair `pair` square to `axis`: zero where `symmetry` names it, and an end of both bodies where supports
    /// or rigid planes hold all nodes square to the plane and not along it. That is how a half is modelled without a name for the
    /// plane; loads and forces are then those of the half.
    pub fn of(scene: &Scene, pair: usize, axis: usize) -> Self {
        /// Share of the size of the mesh by which places differ that are the same.
        const SAME: f64 = 1e-6;
        let same = SAME * scene.mesh.extent(axis);
        let named = scene.mirrors.contains(&axis);
        let mut at: Vec<f64> = named.then_some(0.0).into_iter().collect();
        let (held, free_ends) = common_ends(scene, pair, axis, same);
        at.extend(held);
        Self {
            at,
            named,
            free_ends,
            same,
        }
    }

    /// Those square to a direction: none but where that is an axis.
    pub fn square_to(scene: &Scene, pair: usize, direction: &Vec3) -> Self {
        let none = || Self {
            at: Vec::new(),
            named: false,
            free_ends: Vec::new(),
            same: 0.0,
        };
        axis_of(direction).map_or_else(none, |axis| Self::of(scene, pair, axis))
    }

    /// Which of some coordinates lies on one that supports make, and no name says.
    pub fn held(&self, mut coordinates: impl Iterator<Item = f64>) -> Option<f64> {
        let on = |x: &f64| self.at.iter().any(|at| (at - x).abs() <= self.same);
        coordinates.find(on).filter(|_| !self.named)
    }

    /// At which end one of them cuts what reaches from `low` to `high`, and its coordinate. What goes from one plane to
    /// another, or to where both bodies end, has no end of its own, and is cut where the scene says so: a block that presses with all of its
    /// face is held there so that it does not float away, and not as the half of another one.
    pub fn cut(&self, low: f64, high: f64) -> Option<(End, f64)> {
        let found =
            |all: &[f64], x: f64| all.iter().copied().find(|at| (at - x).abs() <= self.same);
        let ends = [low, high];
        let goes_through = || ends.iter().any(|x| found(&self.free_ends, *x).is_some());
        match ends.map(|x| found(&self.at, x)) {
            [Some(_), Some(_)] if !self.named => None,
            _ if !self.named && goes_through() => None,
            [Some(at), _] => Some((End::Low, at)),
            [None, high] => high.map(|at| (End::High, at)),
        }
    }
}

/// Where the bodies of a pair end together along `axis`: where supports let all that is there slide, and elsewhere.
fn common_ends(scene: &Scene, pair: usize, axis: usize, same: f64) -> (Vec<f64>, Vec<f64>) {
    let slides = |support: &&Support| {
        let only = (0..3).all(|i| support.components[i].is_some() == (i == axis));
        only && !support.moves()
    };
    let keeps = |plane: &&RigidPlane| {
        let motion = |i| match i == axis {
            true => PlaneMotion::Held(0.0),
            false => PlaneMotion::Free,
        };
        !plane.turns() && (0..3).all(|i| plane.motion[i] == motion(i))
    };
    let supports = scene.supports.iter().filter(slides).map(|s| &s.surface);
    let planes = scene.rigid_planes.iter().filter(keeps).map(|p| &p.surface);
    let held: BTreeSet<u32> = supports
        .chain(planes)
        .flat_map(|surface| scene.mesh.nodes_of_surface(surface))
        .collect();
    if held.is_empty() {
        return Default::default();
    }
    let contact = &scene.contacts[pair];
    let mesh = &scene.mesh;
    let bodies = contact.bodies(mesh).into_iter().flatten();
    let corners = bodies.map(|body| mesh.hexes[mesh.bodies[body].elements.clone()].as_flattened());
    let at = |node: &u32| mesh.points[*node as usize][axis];
    let bodies: Vec<(&[u32], [f64; 2])> = corners
        .map(|corners| (corners, range(corners.iter().map(at))))
        .collect();
    let common = |end: usize| {
        let place = bodies.first()?.1[end];
        let together = |(_, ends): &(_, [f64; 2])| (ends[end] - place).abs() <= same;
        bodies.iter().all(together).then_some(place)
    };
    let is_held = |place: &f64| {
        let nodes = bodies.iter().flat_map(|(corners, _)| *corners);
        let mut there = nodes.filter(|node| (at(node) - place).abs() <= same);
        there.all(|node| held.contains(node))
    };
    [0, 1].into_iter().filter_map(common).partition(is_held)
}
