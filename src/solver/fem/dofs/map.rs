//! Which equations displacement components belong to.

use super::element::ElementTerms;
use super::fixed::FIXED;
use super::further::Further;
use super::prescribed::Prescribed;
use crate::model::mesh::Mesh;
use crate::solver::fem::tied::Tied;
use std::sync::Arc;

/// Which equation each displacement component belongs to.
///
/// Equations are numbered vertex by vertex: a vertex is a node with its free components, or one
/// component of a rigid plane, which all its nodes share, or one of the angles that it turns by. A component of a plane
/// that is free to turn depends on further equations beside its own: those of the angles.
#[derive(Debug, Clone)]
pub struct DofMap {
    /// Equation of each component of each node, or [`FIXED`].
    pub equations: Vec<[u32; 3]>,
    /// First equation of each vertex, and the number of equations at the end.
    pub vertex_start: Vec<u32>,
    /// Equation of each driven component of each rigid plane.
    pub planes: Vec<[Option<u32>; 3]>,
    /// Equation of each angle that each rigid plane is free to turn by. The unknown is the angle times
    /// [`turn_length`](Self::turn_length), so that it weighs what a displacement does.
    pub turns: Vec<[Option<u32>; 3]>,
    /// Half the distance of the furthest node of each rigid plane from its point, a length.
    pub turn_length: Vec<f64>,
    /// What turns of rigid planes add to components, and all that components hang on that follow others by ties; by node,
    /// ascending.
    pub further: Vec<Further>,
    /// Prescribed components, or prescribed shares of them: node, axis, displacement at factor one, and what
    /// prescribes it (a [`Source`](super::Source)).
    pub prescribed: Vec<Prescribed>,
    /// Is the node the image of another under the half turn? It has the other's equations, x and y exchanged, and moves
    /// along z the other way. Empty where there is no half turn.
    pub turned: Vec<bool>,
    /// Components that follow others: they have no equations of their own.
    pub tied: Arc<Tied>,
}

impl DofMap {
    /// 1, or −1 where the component moves against its equation.
    fn sign(&self, node: usize, axis: usize) -> f64 {
        match axis == 2 && self.turned.get(node).is_some_and(|turned| *turned) {
            true => -1.0,
            false => 1.0,
        }
    }

    /// Vertex of each equation.
    pub fn vertices(&self) -> Vec<u32> {
        let mut vertex_of = vec![0; self.len()];
        for (vertex, range) in self.vertex_start.windows(2).enumerate() {
            vertex_of[range[0] as usize..range[1] as usize].fill(vertex as u32);
        }
        vertex_of
    }

    /// What turns of rigid planes and ties add to the components of `node`.
    pub fn further_of(&self, node: u32) -> &[Further] {
        if self.further.is_empty() {
            return &[];
        }
        let from = self.further.partition_point(|f| f.node < node);
        let count = self.further[from..].partition_point(|f| f.node == node);
        &self.further[from..from + count]
    }

    /// Everything that the components of `node` depend on: equation, axis, and the displacement along it for an unknown
    /// of one.
    pub fn terms(&self, node: u32) -> impl Iterator<Item = (u32, usize, f64)> {
        let own = self.equations[node as usize].into_iter().enumerate();
        let own = own.map(move |(axis, e)| (e, axis, self.sign(node as usize, axis)));
        let further = self.further_of(node).iter();
        own.chain(further.map(|f| (f.equation, f.axis, f.lever)))
            .filter(|(equation, ..)| *equation != FIXED)
    }

    /// How the 24 components of an element hang on equations.
    pub fn of_element(&self, mesh: &Mesh, element: usize) -> ElementTerms {
        let nodes = mesh.hexes[element];
        let further = (0..).zip(nodes).flat_map(|(corner, node)| {
            let of_node = self.further_of(node).iter();
            of_node.map(move |f| (3 * corner + f.axis, f.equation, f.lever))
        });
        ElementTerms {
            equations: std::array::from_fn(|k| self.equations[nodes[k / 3] as usize][k % 3]),
            signs: std::array::from_fn(|k| self.sign(nodes[k / 3] as usize, k % 3)),
            further: further.collect(),
        }
    }

    /// Number of equations.
    pub fn len(&self) -> usize {
        self.vertex_start.last().map_or(0, |n| *n as usize)
    }

    /// No equation at all?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Sums nodal vectors into a vector of equations; what acts on fixed components is dropped.
    pub fn gather(&self, nodal: &[[f64; 3]]) -> Vec<f64> {
        let mut out = vec![0.0; self.len()];
        for (node, (equations, values)) in self.equations.iter().zip(nodal).enumerate() {
            for (axis, (equation, value)) in equations.iter().zip(values).enumerate() {
                if *equation != FIXED {
                    out[*equation as usize] += self.sign(node, axis) * value;
                }
            }
        }
        for f in self.further.iter().filter(|f| f.equation != FIXED) {
            out[f.equation as usize] += f.lever * nodal[f.node as usize][f.axis];
        }
        out
    }

    /// Adds `factor` times the solution `x` to the nodal displacements. What follows a prescribed component by a tie gets its
    /// share of that by [`Tied::spread`].
    pub fn scatter_add(&self, x: &[f64], factor: f64, nodal: &mut [[f64; 3]]) {
        for (node, (equations, values)) in self.equations.iter().zip(&mut *nodal).enumerate() {
            for (axis, (equation, value)) in equations.iter().zip(values).enumerate() {
                if *equation != FIXED {
                    *value += factor * self.sign(node, axis) * x[*equation as usize];
                }
            }
        }
        for f in self.further.iter().filter(|f| f.equation != FIXED) {
            nodal[f.node as usize][f.axis] += factor * f.lever * x[f.equation as usize];
        }
    }
}
