//! The force that a plane exerts whose motion is prescribed.

use crate::solver::solve::checkpoint::plastic::{Plastic, points};
use crate::solver::solve::model::system::Model;

impl Model<'_> {
    /// What the bodies' inner forces at the nodes of `surface` need along `axes`, at the
    /// displacements `u` with the plastic histories that belong to them; zero along other axes.
    ///
    /// Tractions and contact on the same nodes are not counted: they do not go through the plane.
    pub fn reaction(
        &self,
        plastic: &Plastic,
        u: &[[f64; 3]],
        surface: &str,
        axes: [bool; 3],
    ) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let mesh = &self.scene.mesh;
        let Some(surface) = mesh.surface(surface) else {
            return sum;
        };
        if axes == [false; 3] {
            return sum;
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
            let relief = shape.relief(elastic, &points(plastic, e));
            let pairs = force.as_flattened_mut().iter_mut();
            (pairs.zip(relief.as_flattened())).for_each(|(f, r)| *f -= r);
            for (node, force) in nodes.iter().zip(force) {
                for axis in (0..3).filter(|a| axes[*a] && on[*node as usize]) {
                    sum[axis] += force[axis];
                }
            }
        }
        sum
    }
}
