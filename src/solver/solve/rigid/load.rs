//! Generalised forces: the work of the loads on the rigid-body modes.

use crate::model::scene::{PlaneMotion, PlaneTurn, RigidPlane, Scene};
use crate::solver::fem::loads::add_traction;
use crate::solver::solve::rigid::rigid_bodies::RigidBodies;

impl RigidBodies {
    /// What the loads, times their factors by name, do to the motions of all bodies.
    pub fn load(&self, scene: &Scene, factor: &dyn Fn(&str) -> f64) -> Vec<f64> {
        let mut forces = vec![[0.0; 3]; scene.mesh.points.len()];
        for traction in &scene.tractions {
            if let Some(surface) = scene.mesh.surface(&traction.surface) {
                let factor = factor(&traction.name);
                add_traction(&scene.mesh, surface, traction.value, factor, &mut forces);
            }
        }
        let (still, turning): (Vec<_>, Vec<_>) =
            (scene.rigid_planes.iter()).partition(|plane| !plane.turns_freely());
        for plane in still {
            let nodes = scene.mesh.nodes_of_surface(&plane.surface);
            for (axis, motion) in plane.motion.iter().enumerate() {
                if let PlaneMotion::Driven(force) = motion {
                    let each = factor(&plane.name) * force / nodes.len().max(1) as f64;
                    nodes.iter().for_each(|n| forces[*n as usize][axis] += each);
                }
            }
        }
        let mut load = vec![0.0; 6 * self.middles.len()];
        for (node, force) in forces.iter().enumerate() {
            let Some(body) = self.bodies[node].first().filter(|_| *force != [0.0; 3]) else {
                continue;
            };
            let does = self.row(*body, self.points[node], *force, 1.0);
            let own = load.iter_mut().skip(6 * body);
            own.zip(does).for_each(|(sum, does)| *sum += does);
        }
        turning
            .into_iter()
            .for_each(|plane| self.add_turning(scene, plane, factor, &mut load));
        load
    }

    /// Adds what a plane that is free to turn does: its force acts at its point, and its moments on the turn.
    fn add_turning(
        &self,
        scene: &Scene,
        plane: &RigidPlane,
        factor: &dyn Fn(&str) -> f64,
        load: &mut [f64],
    ) {
        let face = (scene.mesh.surface(&plane.surface)).and_then(|s| s.faces.first());
        let Some(body) = face.and_then(|f| self.bodies[f.nodes[0] as usize].first()) else {
            return;
        };
        let factor = factor(&plane.name);
        let force = plane.motion.map(|motion| match motion {
            PlaneMotion::Driven(force) => factor * force,
            _ => 0.0,
        });
        let moment = plane.turn.map(|turn| match turn {
            PlaneTurn::Driven(moment) => factor * moment / self.size,
            PlaneTurn::Held(_) => 0.0,
        });
        let about = plane.point(&scene.mesh, &scene.mirrors);
        let mut does = self.row(*body, about, force, 1.0);
        (does[3..].iter_mut().zip(moment)).for_each(|(sum, moment)| *sum += moment);
        let own = load.iter_mut().skip(6 * body);
        own.zip(does).for_each(|(sum, does)| *sum += does);
    }
}
