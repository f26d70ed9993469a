//! What resists the rigid-body modes: supports, rigid planes, shared nodes, contact.
//!
//! Each of them sees the modes through a few linear functions, its rows. The mean of their squares is a quadratic form;
//! the eigenvectors of its zero eigenvalues are the motions that nothing resists.

use crate::ground::geometry::{Vec3, scale, sub};
use crate::model::scene::{PlaneMotion, RigidPlane, Scene};
use crate::solver::solve::rigid::rigid_bodies::{ModeRow, RigidBodies};
use crate::solver::solve::rows::contact_row::ContactRow;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rstar::RTree;
use rstar::primitives::GeomWithData;
use std::collections::BTreeMap;

/// The quadratic form of what resists the modes of all bodies.
pub(in crate::solver::solve) struct Resistance {
    /// Symmetric, six rows and columns a body.
    pub matrix: DMatrix<f64>,
}

impl Resistance {
    /// Nothing resists.
    pub fn new(bodies: usize) -> Self {
        let size = 6 * bodies;
        Self {
            matrix: DMatrix::zeros(size, size),
        }
    }

    /// Adds the mean square of `rows`.
    fn add(&mut self, rows: &[ModeRow]) {
        let weight = 1.0 / rows.len().max(1) as f64;
        for row in rows {
            for (a, first) in row {
                for (b, second) in row {
                    for (i, u) in first.iter().enumerate() {
                        for (j, v) in second.iter().enumerate() {
                            self.matrix[(6 * a + i, 6 * b + j)] += weight * u * v;
                        }
                    }
                }
            }
        }
    }

    /// The motions that are resisted by less than `most`: eigenvectors of length one.
    pub fn unresisted(self, most: f64) -> Vec<DVector<f64>> {
        let eigen = SymmetricEigen::new(self.matrix);
        let free = (0..eigen.eigenvalues.len()).filter(|i| eigen.eigenvalues[*i] < most);
        free.map(|i| eigen.eigenvectors.column(i).into_owned())
            .collect()
    }

    /// Among combinations of `motions`, one or more that are orthonormal: those that are resisted least, and so on, each of length one
    /// with its resistance.
    pub fn among(self, motions: &[DVector<f64>]) -> Vec<(DVector<f64>, f64)> {
        let basis = DMatrix::from_columns(motions);
        let eigen = SymmetricEigen::new(basis.tr_mul(&self.matrix) * &basis);
        let pairs = eigen.eigenvectors.column_iter().zip(&eigen.eigenvalues);
        pairs
            .map(|(vector, value)| (&basis * vector, *value))
            .collect()
    }

    /// Supports: the displacement of each of their nodes along each axis that they hold.
    pub fn supports(&mut self, scene: &Scene, frames: &RigidBodies) {
        for support in &scene.supports {
            let nodes = scene.mesh.nodes_of_surface(&support.surface);
            for axis in (0..3).filter(|axis| support.components[*axis].is_some()) {
                let nodes = nodes.iter();
                let rows: Vec<ModeRow> = nodes.filter_map(|n| frames.of_node(*n, axis)).collect();
                self.add(&rows);
            }
        }
    }

    /// All nodes of a rigid plane move alike, where it is held not at all.
    pub fn planes(&mut self, scene: &Scene, frames: &RigidBodies) {
        for plane in &scene.rigid_planes {
            if plane.turns_freely() {
                self.add(&beside_turns(scene, plane, frames));
                continue;
            }
            let nodes = scene.mesh.nodes_of_surface(&plane.surface);
            for axis in 0..3 {
                let nodes = nodes.iter();
                let rows: Vec<ModeRow> = nodes.filter_map(|n| frames.of_node(*n, axis)).collect();
                match plane.motion[axis] {
                    PlaneMotion::Free => {}
                    PlaneMotion::Held(_) => self.add(&rows),
                    PlaneMotion::Driven(_) => self.add(&about_mean(&rows)),
                }
            }
        }
    }

    /// The half turn: a node of the cut and its image move as each other's images.
    pub fn half_turn(&mut self, scene: &Scene, frames: &RigidBodies) {
        for (axis, turned, sign) in [(0, 1, -1.0), (1, 0, -1.0), (2, 2, 1.0)] {
            let tied = scene.half_turn.iter().filter_map(|[node, image]| {
                let mut row = frames.of_node(*node, axis)?;
                add_row(&mut row, &frames.of_node(*image, turned)?, sign);
                Some(row)
            });
            self.add(&tied.collect::<Vec<ModeRow>>());
        }
    }

    /// Contact at `rows` whose gap is up to `near` more than the least one of their pair.
    pub fn contacts(
        &mut self,
        scene: &Scene,
        (rows, near): (&[ContactRow], f64),
        frames: &RigidBodies,
    ) {
        for index in 0..scene.contacts.len() {
            let of_pair = || rows.iter().filter(|r| r.pair == index);
            let least = of_pair().fold(f64::INFINITY, |least, r| least.min(r.row.gap));
            let touching = of_pair().filter(|r| r.row.gap <= least + near);
            let (mut normal, mut rubbing) = (Vec::new(), [Vec::new(), Vec::new()]);
            for contact in touching {
                normal.push(relative(contact, contact.row.normal, frames));
                let Some(along) = contact.row.tangents else {
                    continue;
                };
                for (rows, along) in rubbing.iter_mut().zip(along) {
                    rows.push(relative(contact, along, frames));
                }
            }
            self.add(&normal);
            rubbing.iter().for_each(|rows| self.add(rows));
        }
    }

    /// Bodies whose surfaces are tied move together there: each node of the one with the nearest body of the other.
    pub fn ties(&mut self, scene: &Scene, frames: &RigidBodies) {
        for [first, second] in scene.ties.iter().filter_map(|tie| tie.of(&scene.mesh)) {
            let at = |node: u32| frames.points[node as usize];
            let opposite = second.nodes().into_iter();
            let tree = RTree::bulk_load(opposite.map(|n| GeomWithData::new(at(n), n)).collect());
            for axis in 0..3 {
                let row = |node: u32| {
                    let mut row = frames.of_node(node, axis)?;
                    let nearest = tree.nearest_neighbor(at(node))?.data;
                    let body = *frames.bodies[nearest as usize].first()?;
                    let mut direction = [0.0; 3];
                    direction[axis] = 1.0;
                    let other = frames.row(body, at(node), direction, -1.0);
                    let sum = row.entry(body).or_insert([0.0; 6]);
                    sum.iter_mut().zip(other).for_each(|(s, o)| *s += o);
                    Some(row)
                };
                let rows: Vec<ModeRow> = first.nodes().into_iter().filter_map(row).collect();
                self.add(&rows);
            }
        }
    }

    /// Bodies that share nodes move together there.
    pub fn shared_nodes(&mut self, frames: &RigidBodies) {
        let mut joints: BTreeMap<(usize, usize), Vec<ModeRow>> = BTreeMap::new();
        for (bodies, at) in frames.bodies.iter().zip(&frames.points) {
            for pair in bodies.windows(2) {
                let (a, b) = (pair[0], pair[1]);
                for axis in 0..3 {
                    let mut direction = [0.0; 3];
                    direction[axis] = 1.0;
                    let rows = joints.entry((a, b)).or_default();
                    rows.push(ModeRow::from([
                        (a, frames.row(a, *at, direction, 1.0)),
                        (b, frames.row(b, *at, direction, -1.0)),
                    ]));
                }
            }
        }
        joints.values().for_each(|rows| self.add(rows));
    }
}

/// What keeps the nodes of a plane that is free to turn from moving otherwise than it may: their rows, less what its
/// translation and its turns explain.
fn beside_turns(scene: &Scene, plane: &RigidPlane, frames: &RigidBodies) -> Vec<ModeRow> {
    let about = plane.point(&scene.mesh, &scene.mirrors);
    let (mut rows, mut ways) = (Vec::new(), Vec::new());
    for node in scene.mesh.nodes_of_surface(&plane.surface) {
        let arm = scale(sub(frames.points[node as usize], about), 1.0 / frames.size);
        for axis in (0..3).filter(|axis| plane.motion[*axis] != PlaneMotion::Free) {
            let Some(row) = frames.of_node(node, axis) else {
                continue;
            };
            // How it moves for each of three translations and three turns that are free.
            let mut way = [0.0; 6];
            if matches!(plane.motion[axis], PlaneMotion::Driven(_)) {
                way[axis] = 1.0;
            }
            (plane.free_turns(axis, arm)).for_each(|(turn, lever)| way[3 + turn] = lever);
            rows.push(row);
            ways.push(way);
        }
    }
    let ways = DMatrix::from_fn(rows.len(), 6, |i, j| ways[i][j]);
    let squares = ways.tr_mul(&ways);
    let least = 1e-12 * squares.trace();
    let Ok(inverse) = squares.pseudo_inverse(least) else {
        return Vec::new();
    };
    let explained = &ways * inverse;
    let mut sums = vec![ModeRow::new(); 6];
    for (row, way) in rows.iter().zip(ways.row_iter()) {
        for (sum, share) in sums.iter_mut().zip(way.iter()) {
            add_row(sum, row, *share);
        }
    }
    let less = |(i, mut row): (usize, ModeRow)| {
        for (k, sum) in sums.iter().enumerate() {
            add_row(&mut row, sum, -explained[(i, k)]);
        }
        row
    };
    rows.into_iter().enumerate().map(less).collect()
}

/// Adds `share` times `row`.
fn add_row(sum: &mut ModeRow, row: &ModeRow, share: f64) {
    for (body, values) in row {
        add_values(sum, *body, values, share);
    }
}

fn add_values(sum: &mut ModeRow, body: usize, values: &[f64; 6], share: f64) {
    let own = sum.entry(body).or_insert([0.0; 6]);
    own.iter_mut()
        .zip(values)
        .for_each(|(s, v)| *s += share * v);
}

/// Rows less their mean.
fn about_mean(rows: &[ModeRow]) -> Vec<ModeRow> {
    let mut mean = ModeRow::new();
    for (body, values) in rows.iter().flatten() {
        let sum = mean.entry(*body).or_insert([0.0; 6]);
        for (sum, value) in sum.iter_mut().zip(values) {
            *sum += value / rows.len() as f64;
        }
    }
    let less = |row: &ModeRow| {
        let mut less = mean.clone();
        less.values_mut().flatten().for_each(|v| *v = -*v);
        add_row(&mut less, row, 1.0);
        less
    };
    rows.iter().map(less).collect()
}

/// The relative displacement of a contact row along `direction`: what its terms add up to, which is
/// the same as the bodies' motion at its nodes.
pub(in crate::solver::solve) fn relative(
    contact: &ContactRow,
    direction: Vec3,
    frames: &RigidBodies,
) -> ModeRow {
    let mut row = ModeRow::new();
    for (node, factors) in &contact.row.terms {
        let Some(body) = frames.bodies[*node as usize].first() else {
            continue;
        };
        let along = std::array::from_fn(|axis| factors[axis] * direction[axis]);
        let at = frames.points[*node as usize];
        let values = frames.row(*body, at, along, 1.0);
        add_values(&mut row, *body, &values, 1.0);
    }
    row
}
