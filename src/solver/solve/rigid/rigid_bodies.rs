//! Rigid-body modes: three translations and three turns of each body.
//!
//! A vector of modes holds six numbers a body, in the order of the bodies of the mesh: the translation of its middle,
//! then its turn times a length, so that both weigh alike.

use crate::ground::geometry::{Vec3, add, cross, norm, scale, sub};
use crate::model::scene::Scene;
use std::collections::BTreeMap;

/// Where the bodies are.
pub(in crate::solver::solve) struct RigidBodies {
    /// Mean of the nodes of each body: turns are about it.
    pub middles: Vec<Vec3>,
    /// Half the size of the model. A turn counts as the displacement at this distance, so that it weighs what a
    /// translation does.
    pub size: f64,
    /// Bodies of each node.
    pub bodies: Vec<Vec<usize>>,
    /// Positions of the nodes.
    pub points: Vec<Vec3>,
}

/// A linear function of the modes of all bodies: its six coefficients by body.
pub(in crate::solver::solve) type ModeRow = BTreeMap<usize, [f64; 6]>;

impl RigidBodies {
    /// The bodies of `scene` where they are meshed.
    pub fn new(scene: &Scene) -> Self {
        let mesh = &scene.mesh;
        let mut bodies = vec![Vec::new(); mesh.points.len()];
        let mut middles = Vec::new();
        for (index, body) in mesh.bodies.iter().enumerate() {
            let (mut sum, mut count) = ([0.0; 3], 0.0);
            for node in mesh.hexes[body.elements.clone()].iter().flatten() {
                let of = &mut bodies[*node as usize];
                if of.last() != Some(&index) {
                    of.push(index);
                    sum = add(sum, mesh.points[*node as usize]);
                    count += 1.0;
                }
            }
            middles.push(scale(sum, 1.0 / f64::max(count, 1.0)));
        }
        let centre = mesh.points.iter().fold([0.0; 3], |sum, p| add(sum, *p));
        let centre = scale(centre, 1.0 / mesh.points.len().max(1) as f64);
        let away = mesh.points.iter().map(|p| norm(sub(*p, centre)));
        Self {
            middles,
            size: 0.5 * away.fold(f64::MIN_POSITIVE, f64::max),
            bodies,
            points: mesh.points.clone(),
        }
    }

    /// Coefficients of the displacement of the point `at` of `body` along `direction`, times `sign`.
    pub fn row(&self, body: usize, at: Vec3, direction: Vec3, sign: f64) -> [f64; 6] {
        let arm = scale(sub(at, self.middles[body]), 1.0 / self.size);
        // d · (ω × r) = ω · (r × d)
        let turn = cross(arm, direction);
        let [x, y, z] = direction;
        [x, y, z, turn[0], turn[1], turn[2]].map(|c| sign * c)
    }

    /// The displacement of a node along a coordinate axis; `None` of a node without a body.
    pub fn of_node(&self, node: u32, axis: usize) -> Option<ModeRow> {
        let body = *self.bodies[node as usize].first()?;
        let mut direction = [0.0; 3];
        direction[axis] = 1.0;
        let at = self.points[node as usize];
        Some(ModeRow::from([(body, self.row(body, at, direction, 1.0))]))
    }

    /// The largest angle by which a body turns.
    pub fn largest_turn(&self, vector: &[f64]) -> f64 {
        let turns = vector.chunks(6).map(|own| norm([own[3], own[4], own[5]]));
        turns.fold(0.0, f64::max) / self.size
    }

    /// What the motions of all bodies move each node.
    pub fn displacement(&self, vector: &[f64]) -> Vec<Vec3> {
        let at = |(bodies, at): (&Vec<usize>, &Vec3)| {
            let Some(body) = bodies.first() else {
                return [0.0; 3];
            };
            let own = &vector[6 * body..6 * body + 6];
            [0, 1, 2].map(|axis| {
                let mut direction = [0.0; 3];
                direction[axis] = 1.0;
                let does = self.row(*body, *at, direction, 1.0);
                does.iter().zip(own).map(|(d, v)| d * v).sum()
            })
        };
        self.bodies.iter().zip(&self.points).map(at).collect()
    }
}
