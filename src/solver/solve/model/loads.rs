//! External forces on the kept unknowns.

use crate::ground::geometry::scale;
use crate::model::scene::{PlaneMotion, PlaneTurn, Scene};
use crate::solver::fem::dofs::{DofMap, Source};
use crate::solver::fem::loads;
use crate::solver::fem::loads::at_nodes;
use crate::solver::linear::krylov::norm;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::model::settled::Settled;
use crate::solver::solve::model::system::Model;

impl Model<'_> {
    /// Norm of the forces of `loads` at the end of the step where it is largest.
    pub fn largest(&self, loads: &[(String, Vec<f64>)]) -> f64 {
        let steps = 0..self.scene.steps.len();
        let norms = steps.map(|s| norm(&self.sum(loads, s, 1.0)));
        norms.fold(0.0, f64::max)
    }

    /// Forces of the loads on all unknowns, inner ones eliminated.
    pub fn forces(&self, step: usize, time: f64) -> Vec<f64> {
        self.sum(&self.loads, step, time)
    }

    fn sum(&self, loads: &[(String, Vec<f64>)], step: usize, time: f64) -> Vec<f64> {
        let mut out = vec![0.0; self.all.len()];
        for (name, vector) in loads {
            let factor = self.scene.factor(name, step, time);
            for (o, v) in out.iter_mut().zip(vector) {
                *o += factor * v;
            }
        }
        out
    }

    /// Applied forces on the kept equations at a point, the elastic reaction to
    /// prescribed displacements and what the plastic strain of `settled` elements does included.
    pub fn external(&self, point: &Point, settled: &Settled) -> Vec<f64> {
        let mut all = self.forces(point.step, point.time);
        settled.act_on(&mut all);
        self.bodies.restrict(&all)
    }

    /// −K u for the prescribed displacements of each source that has any, all other nodes at `rest`.
    pub fn prescribed_forces(&self, rest: Rest) -> Vec<(String, Vec<f64>)> {
        let mesh = &self.scene.mesh;
        let mut sources: Vec<Source> = Vec::new();
        for p in self.all.prescribed.iter().filter(|p| p.value != 0.0) {
            if !sources.contains(&p.source) {
                sources.push(p.source);
            }
        }
        let forces = sources.into_iter().map(|source| {
            let mut u = match rest {
                Rest::Still => vec![[0.0; 3]; mesh.points.len()],
                Rest::Carried => self.carried(source),
            };
            for p in self.all.prescribed.iter().filter(|p| p.source == source) {
                u[p.node as usize][p.axis] = p.value;
            }
            self.all.tied.spread(&mut u);
            let elements = (0u32..).zip(&mesh.hexes).filter_map(|(element, nodes)| {
                let local = nodes.map(|n| u[n as usize]);
                let moves = local.iter().flatten().any(|v| *v != 0.0);
                let moduli = &self.elastic[mesh.body_of(element as usize)];
                let force = || self.element(element).elastic_force(moduli, &local);
                moves.then(|| (*nodes, force().map(|f| scale(f, -1.0))))
            });
            let force = at_nodes(mesh.points.len(), elements);
            (self.source_name(source).to_owned(), self.all.gather(&force))
        });
        forces.collect()
    }

    /// Every node moved by the mean of what `source` prescribes on its body, along each axis.
    fn carried(&self, source: Source) -> Vec<[f64; 3]> {
        let mesh = &self.scene.mesh;
        let mut u = vec![[0.0; 3]; mesh.points.len()];
        let mut body_of = vec![0; mesh.points.len()];
        for (element, nodes) in mesh.hexes.iter().enumerate() {
            nodes
                .iter()
                .for_each(|n| body_of[*n as usize] = mesh.body_of(element));
        }
        let mut sums = vec![[(0.0, 0.0); 3]; mesh.bodies.len()];
        for p in &self.all.prescribed {
            let (sum, count) = &mut sums[body_of[p.node as usize]][p.axis];
            *sum += if p.source == source { p.value } else { 0.0 };
            *count += 1.0;
        }
        for (u, body) in u.iter_mut().zip(body_of) {
            *u = sums[body].map(|(sum, count)| if count > 0.0 { sum / count } else { 0.0 });
        }
        u
    }
}

/// Where the nodes are whose displacement is not prescribed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rest {
    /// Where they were.
    Still,
    /// Moved with their body, by the mean of what is prescribed on it: forces are then of its strain only.
    Carried,
}

/// Load vectors of tractions and driven planes at factor one.
pub fn load_vectors(scene: &Scene, dofs: &DofMap) -> Vec<(String, Vec<f64>)> {
    let mut out = Vec::new();
    for traction in &scene.tractions {
        if let Some(surface) = scene.mesh.surface(&traction.surface) {
            let mut force = vec![[0.0; 3]; scene.mesh.points.len()];
            loads::add_traction(&scene.mesh, surface, traction.value, 1.0, &mut force);
            out.push((traction.name.clone(), dofs.gather(&force)));
        }
    }
    for (index, plane) in scene.rigid_planes.iter().enumerate() {
        let (equations, turns) = (&dofs.planes[index], &dofs.turns[index]);
        let mut force = vec![0.0; dofs.len()];
        for (motion, equation) in plane.motion.iter().zip(equations) {
            if let (PlaneMotion::Driven(load), Some(equation)) = (motion, equation) {
                force[*equation as usize] = *load;
            }
        }
        for (turn, equation) in plane.turn.iter().zip(turns) {
            if let (PlaneTurn::Driven(moment), Some(equation)) = (turn, equation) {
                force[*equation as usize] = moment / dofs.turn_length[index];
            }
        }
        out.push((plane.name.clone(), force));
    }
    out
}
