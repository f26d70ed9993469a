//! Which bodies are held: motions of rigid bodies that neither supports nor contact resists.
//!
//! Every body moves as a rigid one, by three translations and three turns. Supports, rigid planes
//! and contact at the points of first touch (both ways: the load keeps it shut) see these motions
//! through a few rows each; the motions that none of them sees have no stiffness against them.

use super::rows::ContactRow;
use super::start::extent;
use crate::ground::geometry::{Vec3, add, cross, norm, scale, sub};
use crate::model::scene::{PlaneMotion, Scene};
use crate::solver::fem::loads::add_traction;
use nalgebra::{DMatrix, SymmetricEigen};
use std::collections::BTreeMap;

/// A motion of bodies that nothing resists.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeMotion {
    /// The body that moves most.
    pub body: String,
    /// Translation and turn about its middle, the larger of the two of length one.
    pub translation: Vec3,
    /// Rotation about that point, by its vector.
    pub turn: Vec3,
    /// Does the load drive it? Then there is no balance; else nothing but rounding moves it.
    pub driven: bool,
}

/// Contact whose gap is larger than the least one by more than this share of the model does not
/// touch at first.
const AT_TOUCH: f64 = 1e-7;
/// A motion that is seen by less than this share of what a single support would see of it is free.
/// A cylinder that rolls is seen by the facets that stand for it.
const UNSEEN: f64 = 1e-5;
/// Share of the load, on a free motion, that is no rounding.
const DRIVEN: f64 = 1e-6;

/// The motions of `scene`, its bodies in touch at `rows`, that nothing resists.
pub fn free_motions(scene: &Scene, rows: &[ContactRow]) -> Vec<FreeMotion> {
    let frames = Frames::new(scene);
    let mut seen = Seen::new(scene.mesh.bodies.len());
    seen.supports(scene, &frames);
    seen.planes(scene, &frames);
    seen.contacts(scene, rows, &frames);
    seen.shared_nodes(&frames);
    let eigen = SymmetricEigen::new(seen.matrix);
    let values = eigen.eigenvalues.iter().enumerate();
    let load = frames.load(scene, &|_| 1.0);
    let whole = load.iter().map(|f| f * f).sum::<f64>().sqrt();
    let free = values.filter(|(_, value)| **value < UNSEEN);
    let motions = free.filter_map(|(i, _)| {
        let motion = eigen.eigenvectors.column(i);
        let work: f64 = motion.iter().zip(&load).map(|(v, f)| v * f).sum();
        frames.motion(scene, motion.as_slice(), work.abs() > DRIVEN * whole)
    });
    motions.collect()
}

/// Where the bodies are: their middles, and their nodes.
pub(super) struct Frames {
    middles: Vec<Vec3>,
    /// Turns are measured at this distance, so that they weigh what translations do.
    size: f64,
    /// Bodies of each node.
    pub bodies: Vec<Vec<usize>>,
    points: Vec<Vec3>,
}

/// One row: by body, what its six motions do to one number.
pub(super) type Row = BTreeMap<usize, [f64; 6]>;

impl Frames {
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

    /// What the motions of `body` move the point `at` along `direction`.
    fn row(&self, body: usize, at: Vec3, direction: Vec3, sign: f64) -> [f64; 6] {
        let arm = scale(sub(at, self.middles[body]), 1.0 / self.size);
        // d · (ω × r) = ω · (r × d)
        let turn = cross(arm, direction);
        let [x, y, z] = direction;
        [x, y, z, turn[0], turn[1], turn[2]].map(|c| sign * c)
    }

    fn of_node(&self, node: u32, axis: usize) -> Option<Row> {
        let body = *self.bodies[node as usize].first()?;
        let mut direction = [0.0; 3];
        direction[axis] = 1.0;
        let at = self.points[node as usize];
        Some(Row::from([(body, self.row(body, at, direction, 1.0))]))
    }

    /// The motion of the body that takes most part in `vector`.
    pub fn motion(&self, scene: &Scene, vector: &[f64], driven: bool) -> Option<FreeMotion> {
        let of = |body: usize| &vector[6 * body..6 * body + 6];
        let amount = |body: usize| of(body).iter().map(|c| c * c).sum::<f64>();
        let bodies = 0..self.middles.len();
        let body = bodies.max_by(|a, b| amount(*a).total_cmp(&amount(*b)))?;
        let most = of(body).iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let part = |from: usize| std::array::from_fn(|i| of(body)[from + i] / most);
        Some(FreeMotion {
            body: scene.mesh.bodies.get(body)?.name.clone(),
            translation: part(0),
            turn: part(3),
            driven,
        })
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

    /// What the loads, times their factors by name, do to the motions of all bodies.
    pub fn load(&self, scene: &Scene, factor: &dyn Fn(&str) -> f64) -> Vec<f64> {
        let mut forces = vec![[0.0; 3]; scene.mesh.points.len()];
        for traction in &scene.tractions {
            if let Some(surface) = scene.mesh.surface(&traction.surface) {
                let factor = factor(&traction.name);
                add_traction(&scene.mesh, surface, traction.value, factor, &mut forces);
            }
        }
        for plane in &scene.rigid_planes {
            let nodes = scene.mesh.surface(&plane.surface).map(|s| s.nodes());
            let nodes = nodes.unwrap_or_default();
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
        load
    }
}

/// What is seen of the motions of all bodies: a sum of squares.
pub(super) struct Seen {
    pub matrix: DMatrix<f64>,
}

impl Seen {
    pub fn new(bodies: usize) -> Self {
        let size = 6 * bodies;
        Self {
            matrix: DMatrix::zeros(size, size),
        }
    }

    /// Adds the mean square of `rows`.
    fn add(&mut self, rows: &[Row]) {
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

    pub fn supports(&mut self, scene: &Scene, frames: &Frames) {
        for support in &scene.supports {
            let nodes = (scene.mesh.surface(&support.surface)).map(|s| s.nodes());
            for axis in (0..3).filter(|axis| support.components[*axis].is_some()) {
                let nodes = nodes.iter().flatten();
                let rows: Vec<Row> = nodes.filter_map(|n| frames.of_node(*n, axis)).collect();
                self.add(&rows);
            }
        }
    }

    /// All nodes of a rigid plane move alike, where it is held not at all.
    pub fn planes(&mut self, scene: &Scene, frames: &Frames) {
        for plane in &scene.rigid_planes {
            let nodes = (scene.mesh.surface(&plane.surface)).map(|s| s.nodes());
            for axis in 0..3 {
                let nodes = nodes.iter().flatten();
                let rows: Vec<Row> = nodes.filter_map(|n| frames.of_node(*n, axis)).collect();
                match plane.motion[axis] {
                    PlaneMotion::Free => {}
                    PlaneMotion::Held(_) => self.add(&rows),
                    PlaneMotion::Driven(_) => self.add(&about_mean(&rows)),
                }
            }
        }
    }

    fn contacts(&mut self, scene: &Scene, rows: &[ContactRow], frames: &Frames) {
        let near = AT_TOUCH * extent(scene);
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

    /// Bodies that share nodes move together there.
    pub fn shared_nodes(&mut self, frames: &Frames) {
        let mut joints: BTreeMap<(usize, usize), Vec<Row>> = BTreeMap::new();
        for (bodies, at) in frames.bodies.iter().zip(&frames.points) {
            for pair in bodies.windows(2) {
                let (a, b) = (pair[0], pair[1]);
                for axis in 0..3 {
                    let mut direction = [0.0; 3];
                    direction[axis] = 1.0;
                    let rows = joints.entry((a, b)).or_default();
                    rows.push(Row::from([
                        (a, frames.row(a, *at, direction, 1.0)),
                        (b, frames.row(b, *at, direction, -1.0)),
                    ]));
                }
            }
        }
        joints.values().for_each(|rows| self.add(rows));
    }
}

/// Rows less their mean.
fn about_mean(rows: &[Row]) -> Vec<Row> {
    let mut mean = Row::new();
    for (body, values) in rows.iter().flatten() {
        let sum = mean.entry(*body).or_insert([0.0; 6]);
        for (sum, value) in sum.iter_mut().zip(values) {
            *sum += value / rows.len() as f64;
        }
    }
    let less = |row: &Row| {
        let mut less = mean.clone();
        less.values_mut().flatten().for_each(|v| *v = -*v);
        for (body, values) in row {
            let sum = less.entry(*body).or_insert([0.0; 6]);
            for (sum, value) in sum.iter_mut().zip(values) {
                *sum += value;
            }
        }
        less
    };
    rows.iter().map(less).collect()
}

/// The relative displacement of a contact row along `direction`: what its terms add up to, which is
/// the same as the bodies' motion at its nodes.
pub(super) fn relative(contact: &ContactRow, direction: Vec3, frames: &Frames) -> Row {
    let mut row = Row::new();
    for (node, factors) in &contact.row.terms {
        let Some(body) = frames.bodies[*node as usize].first() else {
            continue;
        };
        let along = std::array::from_fn(|axis| factors[axis] * direction[axis]);
        let at = frames.points[*node as usize];
        let values = frames.row(*body, at, along, 1.0);
        let sum = row.entry(*body).or_insert([0.0; 6]);
        for (sum, value) in sum.iter_mut().zip(values) {
            *sum += value;
        }
    }
    row
}
