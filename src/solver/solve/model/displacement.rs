//! Nodal displacements from unknowns, and back.

use crate::solver::fem::dofs::{DofMap, FIXED};
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::model::settled::Settled;
use crate::solver::solve::model::system::Model;

impl Model<'_> {
    /// Displacements for the solution `x` at `time` within step `step`, of nodes with kept
    /// components.
    pub fn kept_displacement(&self, x: &[f64], step: usize, time: f64) -> Vec<[f64; 3]> {
        self.nodal(&self.dofs, x, step, time)
    }

    /// The same of all nodes.
    pub fn displacement(&self, point: &Point, settled: &Settled) -> Vec<[f64; 3]> {
        let mut all = self.forces(point.step, point.time);
        settled.act_on(&mut all);
        self.bodies.recover(&point.x, &mut all);
        self.nodal(&self.all, &all, point.step, point.time)
    }

    fn nodal(&self, dofs: &DofMap, x: &[f64], step: usize, time: f64) -> Vec<[f64; 3]> {
        let mut nodal = vec![[0.0; 3]; self.scene.mesh.points.len()];
        dofs.scatter_add(x, 1.0, &mut nodal);
        for p in &dofs.prescribed {
            if p.value != 0.0 {
                let factor = self.scene.factor(self.source_name(p.source), step, time);
                nodal[p.node as usize][p.axis] += factor * p.value;
            }
        }
        dofs.tied.spread(&mut nodal);
        nodal
    }

    /// The kept unknowns of nodal displacements. Those of a cut are seen on nodes that have equations of their own.
    pub fn unknowns(&self, nodal: &[[f64; 3]]) -> Vec<f64> {
        let mut x = vec![0.0; self.dofs.len()];
        for (node, (equations, values)) in self.dofs.equations.iter().zip(nodal).enumerate() {
            let turned = self.dofs.turned.get(node) == Some(&true);
            for (equation, value) in equations.iter().zip(values) {
                if *equation != FIXED && !turned {
                    x[*equation as usize] = *value;
                }
            }
        }
        // What follows a plane that turns is not the plane's own motion.
        let scene = self.scene;
        for (index, plane) in scene.rigid_planes.iter().enumerate() {
            if !plane.turns() {
                continue;
            }
            let pose = plane.pose(&scene.mesh, &scene.mirrors, nodal);
            let length = self.dofs.turn_length[index];
            let of_travel = self.dofs.planes[index].into_iter().zip(pose.travel);
            let turn = pose.turn.map(|angle| angle * length);
            let of_turn = self.dofs.turns[index].into_iter().zip(turn);
            for (equation, value) in of_travel.chain(of_turn) {
                if let Some(equation) = equation.map(|e| self.bodies.kept_of(e))
                    && equation != FIXED
                {
                    x[equation as usize] = value;
                }
            }
        }
        x
    }
}
