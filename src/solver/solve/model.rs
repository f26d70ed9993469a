//! A scene made ready to be solved: equations, elastic stiffness, contact rows, load vectors.

use super::bodies::{CondensedBodies, Condensing, assemble_elastic, shaped};
use super::cost::{seconds_direct, seconds_divided};
use super::error::SolveError;
use super::foresight::Expected;
use super::history::Settled;
use super::newton::Point;
use super::rows::{ContactRow, law};
use super::size::Size;
use crate::ground::geometry::scale;
use crate::ground::memory::available;
use crate::model::material::Elastic;
use crate::model::mesh::Mesh;
use crate::model::scene::{PlaneMotion, Scene, SolverKind};
use crate::solver::fem::dofs::{DofMap, FIXED, Source};
use crate::solver::fem::element::Element;
use crate::solver::fem::loads::{self, at_nodes};
use crate::solver::linear::cholesky::Symbolic;
use crate::solver::linear::krylov::norm;
use crate::solver::linear::preconditioner::Preconditioner;
use crate::solver::linear::schwarz::{Place, Schwarz};
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use crate::solver::solve::params::SMALL_DIVIDED_MODEL;

/// The scene, discretised. Newton iterations see its kept unknowns only, see [`CondensedBodies`].
pub struct Model<'a> {
    pub scene: &'a Scene,
    /// All unknowns.
    pub all: DofMap,
    /// The kept ones; everything below is about these.
    pub dofs: DofMap,
    pub bodies: CondensedBodies,
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

/// Are corrections of a divided model, or not, of so many unknowns right to a hundredth only? Where there are few,
/// directions cost next to nothing.
fn is_soft(divided: bool, unknowns: usize) -> bool {
    divided && unknowns > SMALL_DIVIDED_MODEL
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
        let reckon = |large| Size::new(scene, &all, &needed, (&expected.flow, large));
        let mut size = reckon(expected.divided);
        if let Some(available) = available().filter(|available| size.memory > *available) {
            return Err(SolveError::Memory {
                unknowns: all.len(),
                needed: size.memory,
                available,
            });
        }
        let plan = |divided: bool| Condensing {
            scene,
            dofs: &all,
            elastic: &elastic,
            needed: &needed,
            flow: &expected.flow,
            condense: !divided,
        };
        let mut structure = Structure::new(&plan(size.divided), &rows)?;
        if scene.controls.solver == SolverKind::Auto && structure.is_dear(all.len()) {
            // Two of them at once would be twice the memory.
            drop(structure);
            size = reckon(true);
            structure = Structure::new(&plan(true), &rows)?;
        }
        let Size {
            divided, memory, ..
        } = size;
        let Structure {
            mut bodies,
            dofs,
            pattern,
            symbolic,
        } = structure;
        let soft = is_soft(divided, all.len());
        for r in &mut rows {
            r.law = law(&scene.contacts[r.pair], r.law.stiffness, soft);
        }
        let number = |e| bodies.kept_of(e);
        let mut stiffness =
            assemble_elastic(&plan(divided), &bodies.sparse_elements, &pattern, number);
        bodies.add_stiffness(&pattern, &mut stiffness);
        bodies.release();
        let preconditioner = match symbolic {
            Some(symbolic) => Preconditioner::Direct(Box::new(symbolic)),
            None => {
                let places = places(scene, &dofs);
                Preconditioner::Schwarz(Box::new(Schwarz::new(&pattern, &stiffness, &places)?))
            }
        };
        let mut model = Self {
            loads: load_vectors(scene, &all),
            reference: 0.0,
            yielding: expected.flow.clone(),
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
        if !(model.reference * model.reference).is_finite() {
            return Err(SolveError::OutOfRange);
        }
        for (_, vector) in &mut model.loads {
            model.bodies.reduce(vector);
        }
        Ok(model)
    }

    /// Are corrections right to a hundredth only, and contact soft for their sake?
    pub fn is_soft(&self) -> bool {
        is_soft(self.is_divided(), self.all.len())
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

    /// Forces of the loads on all unknowns, inner ones eliminated.
    fn forces(&self, step: usize, time: f64) -> Vec<f64> {
        let mut out = vec![0.0; self.all.len()];
        for (name, vector) in &self.loads {
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
        shaped(self.scene, element as usize)
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
}

/// Which unknowns are kept, and how they hang together.
struct Structure {
    bodies: CondensedBodies,
    dofs: DofMap,
    pattern: Pattern,
    /// Of one factor; `None` of a divided model.
    symbolic: Option<Symbolic>,
}

impl Structure {
    fn new(plan: &Condensing, rows: &[ContactRow]) -> Result<Self, SolveError> {
        let bodies = CondensedBodies::new(plan)?;
        let dofs = bodies.kept_dofs(plan.dofs);
        let pattern = pattern(&plan.scene.mesh, &bodies, &dofs, rows);
        let symbolic = match plan.condense {
            true => Some(Symbolic::new(&pattern, &bodies.blocks)?),
            false => None,
        };
        Ok(Self {
            bodies,
            dofs,
            pattern,
            symbolic,
        })
    }

    /// Would iterations of the divided model, of so many unknowns in all, cost less?
    fn is_dear(&self, unknowns: usize) -> bool {
        self.symbolic.as_ref().is_some_and(|symbolic| {
            let entries = symbolic.factor_entries() as f64;
            // What has been condensed is a loss either way.
            seconds_direct(symbolic.work(), entries, 0.0) > seconds_divided(unknowns)
        })
    }
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
pub fn needed(scene: &Scene, dofs: &DofMap, rows: &[ContactRow], flow: &[u32]) -> Vec<bool> {
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

/// Is the element of a steel that yields?
pub fn can_yield(scene: &Scene, element: u32) -> bool {
    let body = scene.mesh.body_of(element as usize);
    scene.controls.plasticity && !scene.materials[body].is_elastic()
}

fn pattern(mesh: &Mesh, bodies: &CondensedBodies, dofs: &DofMap, rows: &[ContactRow]) -> Pattern {
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
