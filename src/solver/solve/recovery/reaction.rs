//! The force and moment that a rigid plane exerts.

use crate::ground::geometry::{Vec3, cross, sub};
use crate::solver::solve::checkpoint::plastic::{Plastic, points};
use crate::solver::solve::model::system::Model;

impl Model<'_> {
    /// What the bodies' inner forces at the nodes of `surface` need along `axes`, at the
    /// displacements `u` with the plastic histories and the moment in time (step and share of it) that belong to them; zero along other axes. Beside
    /// it their moment about the point `about`.
    ///
    /// Tractions and contact on the same nodes are not counted: they do not go through the plane.
    pub fn reaction(
        &self,
        plastic: &Plastic,
        u: &[[f64; 3]],
        surface: &str,
        (axes, about): ([bool; 3], Vec3),
        moment_in_time: (usize, f64),
    ) -> [Vec3; 2] {
        let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
        let mesh = &self.scene.mesh;
        let Some(surface) = mesh.surface(surface) else {
            return [sum, moment];
        };
        if axes == [false; 3] {
            return [sum, moment];
        }
        let mut on = vec![false; mesh.points.len()];
        for node in surface.nodes() {
            on[node as usize] = true;
        }
        for (e, nodes) in (0u32..).zip(&mesh.hexes) {
            if !nodes.iter().any(|n| on[*n as usize]) {
                continue;
            }
            let elastic = &self.elastic[mesh.body_of(e as usize)];
            let shape = self.element(e);
            let mut force = shape.elastic_force(elastic, &nodes.map(|n| u[n as usize]));
            let relief = shape.relief(
                elastic,
                &self.free_strains(e, points(plastic, e), moment_in_time),
            );
            let pairs = force.as_flattened_mut().iter_mut();
            (pairs.zip(relief.as_flattened())).for_each(|(f, r)| *f -= r);
            for (node, force) in nodes.iter().zip(force) {
                if !on[*node as usize] {
                    continue;
                }
                let own = [0, 1, 2].map(|axis| if axes[axis] { force[axis] } else { 0.0 });
                let turn = cross(sub(mesh.points[*node as usize], about), own);
                for axis in 0..3 {
                    sum[axis] += own[axis];
                    moment[axis] += turn[axis];
                }
            }
        }
        [sum, moment]
    }
}
