//! A scene made ready to be solved: equations, elastic stiffness, contact rows, load vectors.

use super::bodies::{self, Bodies, Plan};
use super::error::SolveError;
use super::foresight::Expected;
use super::timers::Timers;
use crate::contact::law::Law;
use crate::contact::mortar::{self, Opposite, Row};
use crate::fem::dofs::{DofMap, FIXED, Source};
use crate::fem::element::Element;
use crate::fem::loads;
use crate::linear::cholesky::Symbolic;
use crate::linear::krylov::norm;
use crate::linear::memory::available;
use crate::linear::preconditioner::Preconditioner;
use crate::linear::schwarz::{Place, Schwarz};
use crate::linear::sparse::{Pattern, SymmetricMatrix};
use crate::material::Elastic;
use crate::mesh::{Face, Mesh};
use crate::scene::{ContactPair, Partner, PlaneMotion, Scene, Side, SolverKind, Step};
use serde::{Deserialize, Serialize};

/// Penalty over the stiffness of the material next to the contact, at a user factor of one.
///
/// The augmented-Lagrange update makes the answer independent of it; it only has to be stiff
/// enough that few updates are needed and soft enough that the factor stays accurate.
const PENALTY: f64 = 1000.0;

/// The same where the model is divided and there is friction, which follows the pressure: corrections
/// are then right to a hundredth of their energy, and beside stiffer contact next to none of that is
/// left for how the pressure is distributed.
const DIVIDED_PENALTY: f64 = 50.0;

/// Bounds of both, whatever the user's factor: softer, and multipliers take dozens of updates; stiffer,
/// and rounding of displacements makes forces that never balance. The answer is the same.
const SOFTEST: f64 = 10.0;
const STIFFEST: f64 = 1e6;

/// How often the expensive parts ran.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Counters {
    pub iterations: usize,
    pub cut_backs: usize,
    pub factorisations: usize,
    pub linear_solves: usize,
    pub krylov_directions: usize,
    /// Times that residual and laws were evaluated.
    pub evaluations: usize,
    /// Times that the model was prepared: once, and again where something was unforeseen.
    pub preparations: usize,
    /// Elements integrated again for a tangent, because they flow.
    pub element_tangents: usize,
    /// Integration points whose yield condition was checked.
    pub plastic_updates: usize,
    /// Contact nodes whose law was evaluated.
    pub contact_updates: usize,
    /// Those of them with friction.
    pub friction_updates: usize,
    pub equations: usize,
    /// Unknowns that are left when the bodies are condensed.
    pub kept_equations: usize,
    pub factor_entries: usize,
    /// Those of them that a factorisation computes; the others belong to condensed bodies.
    pub kept_factor_entries: usize,
    pub contact_rows: usize,
    /// Elements whose yield condition is checked in every iteration.
    pub watched_elements: usize,
    pub timers: Timers,
}

impl Counters {
    /// Sizes of a model.
    pub fn measure(&mut self, model: &Model) {
        self.equations = model.all.len();
        self.kept_equations = model.dofs.len();
        self.preparations += 1;
        self.kept_factor_entries = model.preconditioner.factor_entries();
        self.factor_entries = model.bodies.factor_entries() + self.kept_factor_entries;
        self.watched_elements = model.yielding.len();
        self.contact_rows = model.rows.len();
    }
}

/// A contact row with its pair's law.
pub struct ContactRow {
    pub row: Row,
    pub pair: usize,
    pub law: Law,
}

/// The scene, discretised. Newton iterations see its kept unknowns only, see [`Bodies`].
pub struct Model<'a> {
    pub scene: &'a Scene,
    /// All unknowns.
    pub all: DofMap,
    /// The kept ones; everything below is about these.
    pub dofs: DofMap,
    pub bodies: Bodies,
    pub elastic: Vec<Elastic>,
    pub pattern: Pattern,
    pub preconditioner: Preconditioner,
    /// Stiffness of all bodies as long as they are elastic.
    pub stiffness: SymmetricMatrix,
    pub rows: Vec<ContactRow>,
    /// Contact rows that are not expected to close.
    pub spare: Vec<ContactRow>,
    /// Elements whose yield condition is checked in every iteration.
    pub yielding: Vec<u32>,
    /// Forces at factor one, inner unknowns eliminated: of each traction, of each rigid plane, and
    /// those of nonzero prescribed displacements.
    loads: Vec<(String, Vec<f64>)>,
    /// The largest force that the steps apply.
    pub reference: f64,
    /// Beyond this initial gap no contact was integrated.
    pub reach: f64,
    /// Bytes that it takes in all, estimated.
    pub memory: f64,
}

impl<'a> Model<'a> {
    /// Prepares `scene` with its contact `rows` for what is expected to happen.
    ///
    /// # Errors
    /// [`SolveError`] where supports contradict each other, nothing is free or memory runs out.
    pub fn new(
        scene: &'a Scene,
        expected: &Expected,
        rows: Vec<ContactRow>,
    ) -> Result<Self, SolveError> {
        let all = DofMap::new(scene)?;
        if all.is_empty() {
            return Err(SolveError::NothingFree);
        }
        let elastic: Vec<Elastic> = scene.materials.iter().map(|m| m.moduli()).collect();
        let (mut rows, spare) = expected.split(rows);
        let needed = needed(scene, &all, &rows, &expected.flow);
        let divided = match scene.controls.solver {
            SolverKind::Auto => expected.divided || is_large(scene, &all, &needed),
            SolverKind::Direct => false,
            SolverKind::Divided => true,
        };
        let memory = memory(scene, &all, &needed, divided);
        if let Some(available) = available().filter(|available| memory > *available) {
            return Err(SolveError::Memory {
                unknowns: all.len(),
                needed: memory,
                available,
            });
        }
        for r in &mut rows {
            r.law.penalty = penalty(&scene.contacts[r.pair], r.law.stiffness, divided);
        }
        let plan = Plan {
            scene,
            dofs: &all,
            elastic: &elastic,
            needed: &needed,
            flow: &expected.flow,
            condense: !divided,
        };
        let mut bodies = Bodies::new(&plan)?;
        let dofs = bodies.kept_dofs(&all);
        let pattern = pattern(&scene.mesh, &bodies, &dofs, &rows);
        let number = |e| bodies.kept_of(e);
        let mut stiffness = bodies::assemble(&plan, &bodies.sparse_elements, &pattern, number);
        bodies.add_stiffness(&pattern, &mut stiffness);
        bodies.release();
        let preconditioner = if divided {
            let places = places(scene, &dofs);
            Preconditioner::Schwarz(Box::new(Schwarz::new(&pattern, &stiffness, &places)?))
        } else {
            Preconditioner::Direct(Box::new(Symbolic::new(&pattern, &bodies.blocks)?))
        };
        let mut model = Self {
            loads: load_vectors(scene, &all),
            reference: 0.0,
            yielding: match divided {
                true => expected.flow.clone(),
                false => yielding(scene, &bodies),
            },
            scene,
            elastic,
            pattern,
            preconditioner,
            stiffness,
            rows,
            spare,
            reach: expected.reach,
            memory,
            bodies,
            dofs,
            all,
        };
        model.loads.extend(model.prescribed_forces());
        model.reference = model.largest_load();
        for (_, vector) in &mut model.loads {
            model.bodies.reduce(vector);
        }
        Ok(model)
    }

    /// Is it too large for one factor?
    pub fn is_divided(&self) -> bool {
        matches!(self.preconditioner, Preconditioner::Schwarz(_))
    }

    /// Was no node of these elements condensed?
    pub fn keeps(&self, elements: &[u32]) -> bool {
        elements.iter().all(|element| {
            let all = self.all.of_element(&self.scene.mesh, *element as usize);
            let kept = self.element_equations(*element);
            (all.iter().zip(&kept)).all(|(all, kept)| *all == FIXED || *kept != FIXED)
        })
    }

    /// Checks the yield condition of these elements, ascending, too.
    pub fn watch(&mut self, elements: &[u32]) {
        self.yielding.extend(elements);
        self.yielding.sort_unstable();
        self.yielding.dedup();
    }

    /// Gives most memory back; what is left knows its rows and which elements may flow.
    pub fn release(&mut self) {
        self.bodies.forget();
        self.stiffness.values = Vec::new();
        self.pattern = Pattern::new(vec![0], std::iter::empty());
    }

    /// Norm of the forces at the end of the step where it is largest.
    fn largest_load(&self) -> f64 {
        let steps = 0..self.scene.steps.len();
        let norms = steps.map(|s| norm(&self.forces(s, 1.0)));
        norms.fold(0.0, f64::max)
    }

    /// Forces on all unknowns, inner ones eliminated.
    fn forces(&self, step: usize, time: f64) -> Vec<f64> {
        let mut out = vec![0.0; self.all.len()];
        for (name, vector) in &self.loads {
            let factor = self.factor(name, step, time);
            for (o, v) in out.iter_mut().zip(vector) {
                *o += factor * v;
            }
        }
        out
    }

    /// Factor of the load `name` at `time` within step `index`.
    pub fn factor(&self, name: &str, index: usize, time: f64) -> f64 {
        let steps = &self.scene.steps;
        let before = index.checked_sub(1).and_then(|i| steps.get(i));
        let before = before.map_or(0.0, |step: &Step| step.factor_of(name));
        let after = steps.get(index).map_or(before, |step| step.factor_of(name));
        before + time * (after - before)
    }

    /// Applied forces on the kept equations at `time` within step `step`, the elastic reaction to
    /// prescribed displacements included.
    pub fn external(&self, step: usize, time: f64) -> Vec<f64> {
        self.bodies.restrict(&self.forces(step, time))
    }

    /// Displacements for the solution `x` at `time` within step `step`, of nodes with kept
    /// components.
    pub fn kept_displacement(&self, x: &[f64], step: usize, time: f64) -> Vec<[f64; 3]> {
        self.nodal(&self.dofs, x, step, time)
    }

    /// The same of all nodes.
    pub fn displacement(&self, x: &[f64], step: usize, time: f64) -> Vec<[f64; 3]> {
        let mut all = self.forces(step, time);
        self.bodies.recover(x, &mut all);
        self.nodal(&self.all, &all, step, time)
    }

    fn nodal(&self, dofs: &DofMap, x: &[f64], step: usize, time: f64) -> Vec<[f64; 3]> {
        let mut nodal = vec![[0.0; 3]; self.scene.mesh.points.len()];
        dofs.scatter_add(x, 1.0, &mut nodal);
        for p in &dofs.prescribed {
            if p.value != 0.0 {
                let factor = self.factor(self.source_name(p.source), step, time);
                nodal[p.node as usize][p.axis] = factor * p.value;
            }
        }
        nodal
    }

    /// The kept unknowns of nodal displacements.
    pub fn unknowns(&self, nodal: &[[f64; 3]]) -> Vec<f64> {
        let mut x = vec![0.0; self.dofs.len()];
        for (equations, values) in self.dofs.equations.iter().zip(nodal) {
            for (equation, value) in equations.iter().zip(values) {
                if *equation != FIXED {
                    x[*equation as usize] = *value;
                }
            }
        }
        x
    }

    pub fn source_name(&self, source: Source) -> &str {
        match source {
            Source::Support(i) => &self.scene.supports[i].name,
            Source::Plane(i) => &self.scene.rigid_planes[i].name,
        }
    }

    /// The element with its shape.
    pub fn element(&self, element: u32) -> Element {
        bodies::shaped(self.scene, element as usize)
    }

    /// Equations of an element's 24 components.
    pub fn element_equations(&self, element: u32) -> [u32; 24] {
        self.dofs.of_element(&self.scene.mesh, element as usize)
    }

    /// −K u for the prescribed displacements of each source that has any.
    fn prescribed_forces(&self) -> Vec<(String, Vec<f64>)> {
        let mesh = &self.scene.mesh;
        let mut sources: Vec<Source> = Vec::new();
        for p in self.all.prescribed.iter().filter(|p| p.value != 0.0) {
            if !sources.contains(&p.source) {
                sources.push(p.source);
            }
        }
        let forces = sources.into_iter().map(|source| {
            let mut u = vec![[0.0; 3]; mesh.points.len()];
            for p in self.all.prescribed.iter().filter(|p| p.source == source) {
                u[p.node as usize][p.axis] = p.value;
            }
            let mut force = vec![[0.0; 3]; mesh.points.len()];
            for (element, nodes) in mesh.hexes.iter().enumerate() {
                let local = nodes.map(|n| u[n as usize]);
                if local.iter().flatten().all(|v| *v == 0.0) {
                    continue;
                }
                let moduli = &self.elastic[mesh.body_of(element)];
                let out = self.element(element as u32).elastic_force(moduli, &local);
                for (node, f) in nodes.iter().zip(out) {
                    for axis in 0..3 {
                        force[*node as usize][axis] -= f[axis];
                    }
                }
            }
            (self.source_name(source).to_owned(), self.all.gather(&force))
        });
        forces.collect()
    }
}

/// Is it better to divide the model than to condense its bodies?
fn is_large(scene: &Scene, dofs: &DofMap, needed: &[bool]) -> bool {
    // Seen from the needed unknowns a body is dense; factors take the cube of their number, and are
    // made about as often as Krylov directions number with a division.
    const DIVIDED: f64 = 1.5e7;
    // Entries of the factors of whole bodies: 1 GB of them takes about as long as a division.
    const ENTRIES: f64 = 1.2e8;
    kept(dofs, needed).powi(3) / 3.0 > DIVIDED * dofs.len() as f64 || entries(scene) > ENTRIES
}

/// Bytes that a model takes, from runs of 50 to 200 thousand unknowns (within a quarter).
fn memory(scene: &Scene, dofs: &DofMap, needed: &[bool], divided: bool) -> f64 {
    let unknowns = dofs.len() as f64;
    match divided {
        true => 6e3 * unknowns,
        false => 2e3 * unknowns + 14.4 * entries(scene) + 1.6 * kept(dofs, needed).powi(2),
    }
}

/// Unknowns of the needed vertices.
fn kept(dofs: &DofMap, needed: &[bool]) -> f64 {
    let starts = dofs.vertex_start.windows(2).zip(needed);
    let kept: u32 = starts.filter(|(_, n)| **n).map(|(s, _)| s[1] - s[0]).sum();
    f64::from(kept)
}

/// Entries of the factors of all bodies.
fn entries(scene: &Scene) -> f64 {
    let bodies = scene.mesh.bodies.iter();
    bodies.map(|b| factor_entries(b.elements.len())).sum()
}

/// About how many entries the factor of a compact body has, ordered by METIS (73 million for a cube
/// of 30 elements a side, 241 million for one of 40).
fn factor_entries(elements: usize) -> f64 {
    73e6 * (elements as f64 / 27e3).powf(1.4)
}

/// Where each equation acts.
fn places(scene: &Scene, dofs: &DofMap) -> Vec<Place> {
    let mut places = vec![None; dofs.len()];
    let mut nodes = vec![0u32; dofs.len()];
    for (equations, point) in dofs.equations.iter().zip(&scene.mesh.points) {
        for (axis, equation) in equations.iter().enumerate() {
            if *equation != FIXED {
                places[*equation as usize] = Some((*point, axis));
                nodes[*equation as usize] += 1;
            }
        }
    }
    // The motion of a rigid plane.
    let shared = places.iter_mut().zip(nodes).filter(|(_, n)| *n > 1);
    shared.for_each(|(place, _)| *place = None);
    places
}

/// Vertices that contact or expected flow acts on.
fn needed(scene: &Scene, dofs: &DofMap, rows: &[ContactRow], flow: &[u32]) -> Vec<bool> {
    let vertex_of = dofs.vertices();
    let mut needed = vec![false; dofs.vertex_start.len() - 1];
    let flowing = flow.iter().flat_map(|e| scene.mesh.hexes[*e as usize]);
    let touching = rows.iter().flat_map(|r| r.row.terms.iter().map(|t| t.0));
    for node in flowing.chain(touching) {
        for equation in dofs.equations[node as usize] {
            if equation != FIXED {
                needed[vertex_of[equation as usize] as usize] = true;
            }
        }
    }
    needed
}

/// Elements that may flow: none of them is condensed.
fn yielding(scene: &Scene, bodies: &Bodies) -> Vec<u32> {
    let sparse = bodies.sparse_elements.iter().copied();
    sparse.filter(|e| can_yield(scene, *e)).collect()
}

/// Is the element of a steel that yields?
pub fn can_yield(scene: &Scene, element: u32) -> bool {
    let body = scene.mesh.body_of(element as usize);
    scene.controls.plasticity && !scene.materials[body].is_elastic()
}

/// Contact rows of all pairs up to an initial gap of `reach`, by pair and node.
pub fn contact_rows(scene: &Scene, reach: f64) -> Vec<ContactRow> {
    let moduli: Vec<f64> = scene
        .materials
        .iter()
        .map(|m| m.youngs_modulus / (1.0 - m.poissons_ratio * m.poissons_ratio))
        .collect();
    let mut all = Vec::new();
    for (index, pair) in scene.contacts.iter().enumerate() {
        let rows = pair_rows(scene, pair, reach, &moduli);
        all.extend(rows.into_iter().map(|row| ContactRow {
            law: Law {
                friction: pair.friction,
                penalty: penalty(pair, row.stiffness, false),
                stiffness: row.stiffness,
            },
            pair: index,
            row,
        }));
    }
    all
}

/// The penalty of a row beside which the bodies have the given stiffness.
fn penalty(pair: &ContactPair, stiffness: f64, divided: bool) -> f64 {
    let soft = divided && pair.friction > 0.0;
    let times = if soft { DIVIDED_PENALTY } else { PENALTY };
    (times * pair.penalty_factor).clamp(SOFTEST, STIFFEST) * stiffness
}

/// Rows of one pair.
pub fn pair_rows(scene: &Scene, pair: &ContactPair, reach: f64, moduli: &[f64]) -> Vec<Row> {
    let mesh = &scene.mesh;
    let (carrier, other) = match pair.carrier {
        Side::Upper => (&pair.upper, &pair.lower),
        Side::Lower => (&pair.lower, &pair.upper),
    };
    let Partner::Surface(carrier) = carrier else {
        return Vec::new();
    };
    let opposite = match other {
        Partner::Surface(name) => mesh.surface(name).map(Opposite::Surface),
        Partner::Plane { point, normal } => Some(Opposite::Plane {
            point: *point,
            normal: *normal,
        }),
    };
    let (Some(carrier), Some(opposite)) = (mesh.surface(carrier), opposite) else {
        return Vec::new();
    };
    mortar::rows(&mortar::Pair {
        mesh,
        carrier,
        opposite,
        true_geometry: pair.true_geometry,
        friction: pair.friction > 0.0,
        reach,
        moduli,
        mirrors: &scene.mirrors,
        held: &held_planes(scene, pair),
    })
}

/// Planes, by axis and coordinate, that supports hold both sides of a pair on.
fn held_planes(scene: &Scene, pair: &ContactPair) -> Vec<(usize, f64)> {
    let mesh = &scene.mesh;
    let body = |partner: &Partner| match partner {
        Partner::Surface(name) => {
            let face = mesh.surface(name)?.faces.first()?;
            Some(mesh.body_of(face.element as usize))
        }
        Partner::Plane { .. } => None,
    };
    let of = |body: usize| -> Vec<(usize, f64)> {
        let held = scene.supports.iter().flat_map(|s| {
            let axes =
                (0..3).filter(|a| s.components[*a] == Some(0.0) && s.gradient[*a] == [0.0; 3]);
            axes.filter_map(|axis| Some((axis, plane_of(mesh, &s.surface, body, axis)?)))
        });
        held.collect()
    };
    match (body(&pair.upper), body(&pair.lower)) {
        (Some(upper), Some(lower)) => {
            let lower = of(lower);
            let both = of(upper).into_iter();
            both.filter(|plane| lower.contains(plane)).collect()
        }
        (Some(body), None) | (None, Some(body)) => of(body),
        (None, None) => Vec::new(),
    }
}

/// The coordinate along `axis` that all nodes of a surface of `body` have.
fn plane_of(mesh: &Mesh, surface: &str, body: usize, axis: usize) -> Option<f64> {
    let faces = &mesh.surface(surface)?.faces;
    let own = |face: &&Face| mesh.body_of(face.element as usize) == body;
    let mut nodes = faces.iter().filter(own).flat_map(|face| face.nodes);
    let at = mesh.points[nodes.next()? as usize][axis];
    let flat = nodes.all(|node| mesh.points[node as usize][axis] == at);
    flat.then_some(at)
}

fn pattern(mesh: &Mesh, bodies: &Bodies, dofs: &DofMap, rows: &[ContactRow]) -> Pattern {
    let vertex_of = dofs.vertices();
    let vertices = |nodes: &mut dyn Iterator<Item = u32>| {
        let mut list: Vec<u32> = nodes
            .flat_map(|n| dofs.equations[n as usize])
            .filter(|e| *e != FIXED)
            .map(|e| vertex_of[e as usize])
            .collect();
        list.sort_unstable();
        list.dedup();
        list
    };
    let elements = bodies
        .sparse_elements
        .iter()
        .map(|e| vertices(&mut mesh.hexes[*e as usize].iter().copied()));
    let contacts = rows
        .iter()
        .map(|r| vertices(&mut r.row.terms.iter().map(|t| t.0)));
    let cliques: Vec<Vec<u32>> = elements.chain(contacts).chain(bodies.cliques()).collect();
    Pattern::new(dofs.vertex_start.clone(), cliques.iter().map(Vec::as_slice))
}

/// Load vectors of tractions and driven planes at factor one.
fn load_vectors(scene: &Scene, dofs: &DofMap) -> Vec<(String, Vec<f64>)> {
    let mut out = Vec::new();
    for traction in &scene.tractions {
        if let Some(surface) = scene.mesh.surface(&traction.surface) {
            let mut force = vec![[0.0; 3]; scene.mesh.points.len()];
            loads::add_traction(&scene.mesh, surface, traction.value, 1.0, &mut force);
            out.push((traction.name.clone(), dofs.gather(&force)));
        }
    }
    for (plane, equations) in scene.rigid_planes.iter().zip(&dofs.planes) {
        let mut force = vec![0.0; dofs.len()];
        for (motion, equation) in plane.motion.iter().zip(equations) {
            if let (PlaneMotion::Driven(load), Some(equation)) = (motion, equation) {
                force[*equation as usize] = *load;
            }
        }
        out.push((plane.name.clone(), force));
    }
    out
}
