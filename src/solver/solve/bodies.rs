//! CondensedBodies seen from where something happens: contact and plastic flow.
//!
//! Away from contact and yielding elements a body is linear. It is condensed, once, onto the nodes
//! that it shares with contact rows and yielding elements, and Newton iterations never see the
//! rest. Where that would not pay, because most nodes matter or because the body is small, its
//! equations stay as they are.

use super::error::SolveError;
use crate::model::material::Elastic;
use crate::model::scene::Scene;
use crate::solver::fem::dofs::{DofMap, FIXED};
use crate::solver::fem::element::Element;
use crate::solver::linear::cholesky::FactorError;
use crate::solver::linear::ordering::Block;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use crate::solver::linear::substructure::{Condensation, Substructure};
use crate::solver::solve::params::ELEMENTS_PER_BATCH;
use faer::Mat;
use rayon::prelude::*;
use std::ops::Range;

/// A condensed group of bodies that hold together.
struct Part {
    /// The group's equations, ascending.
    equations: Vec<u32>,
    substructure: Substructure,
}

/// All bodies, and the equations that are left of them.
pub struct CondensedBodies {
    parts: Vec<Part>,
    /// Kept equation of each equation, or [`FIXED`].
    kept_of: Vec<u32>,
    /// Equation of each kept equation.
    kept: Vec<u32>,
    /// First kept equation of each kept vertex, and their number at the end.
    pub vertex_start: Vec<u32>,
    /// Kept vertices in the order in which they are to be eliminated.
    pub blocks: Vec<Block>,
    /// Elements that were not condensed.
    pub sparse_elements: Vec<u32>,
    /// Kept vertices of each condensed part, and its stiffness seen from there.
    superelements: Vec<(Range<u32>, Mat<f64>)>,
}

/// What the bodies are made from.
pub struct Condensing<'a> {
    pub scene: &'a Scene,
    pub dofs: &'a DofMap,
    pub elastic: &'a [Elastic],
    /// Vertices that must be kept.
    pub needed: &'a [bool],
    /// Elements that are expected to flow, ascending: never condensed.
    pub flow: &'a [u32],
    /// Condense at all?
    pub condense: bool,
}

/// CondensedBodies that share vertices, without the elements that are expected to flow.
struct Group {
    elements: Vec<u32>,
    /// Vertices of the elements, ascending.
    vertices: Vec<u32>,
    /// Vertices of elements that are expected to flow and of no other, ascending.
    zone: Vec<u32>,
}

/// What became of a group.
enum Made {
    Sparse(Group),
    Condensed(Box<Condensed>),
}

struct Condensed {
    part: Part,
    zone: Vec<u32>,
    kept_vertices: Vec<u32>,
    /// The part's stiffness seen from the kept vertices.
    schur: Mat<f64>,
}

impl CondensedBodies {
    /// Condenses what is worth it.
    ///
    /// # Errors
    /// [`SolveError::Factor`] where memory runs out.
    pub fn new(plan: &Condensing) -> Result<Self, SolveError> {
        let vertex_of = plan.dofs.vertices();
        let mut sparse: Vec<Group> = Vec::new();
        let mut condensed = Vec::new();
        let made: Vec<_> = groups(plan, &vertex_of)
            .into_par_iter()
            .map(|group| make(plan, &vertex_of, group))
            .collect();
        for result in made {
            match result? {
                Made::Sparse(group) => sparse.push(group),
                Made::Condensed(made) => condensed.push(*made),
            }
        }
        // Small ones are eliminated first: a chain of bodies then fills nothing in.
        condensed.sort_by_key(|made| made.kept_vertices.len());
        let mut bodies = Self {
            parts: Vec::new(),
            kept_of: vec![FIXED; plan.dofs.len()],
            kept: Vec::new(),
            vertex_start: vec![0],
            blocks: Vec::new(),
            sparse_elements: Vec::new(),
            superelements: Vec::new(),
        };
        bodies.sparse_elements = plan.flow.to_vec();
        let mut vertices = Vec::new();
        for group in sparse {
            bodies.sparse_elements.extend(group.elements);
            vertices.extend(group.vertices.into_iter().chain(group.zone));
        }
        bodies.sparse_elements.sort_unstable();
        vertices.sort_unstable();
        let range = bodies.keep(plan.dofs, &vertices);
        bodies.blocks.push(Block::Sparse(range));
        for made in condensed {
            let range = bodies.keep(plan.dofs, &made.zone);
            bodies.blocks.push(Block::Sparse(range));
            let range = bodies.keep(plan.dofs, &made.kept_vertices);
            bodies.blocks.push(Block::Dense(range.clone()));
            bodies.superelements.push((range, made.schur));
            bodies.parts.push(made.part);
        }
        Ok(bodies)
    }

    /// Appends vertices to the kept ones; returns their numbers there.
    fn keep(&mut self, dofs: &DofMap, vertices: &[u32]) -> Range<u32> {
        let first = self.vertex_start.len() as u32 - 1;
        for vertex in vertices {
            let vertex = *vertex as usize;
            for equation in dofs.vertex_start[vertex]..dofs.vertex_start[vertex + 1] {
                self.kept_of[equation as usize] = self.kept.len() as u32;
                self.kept.push(equation);
            }
            self.vertex_start.push(self.kept.len() as u32);
        }
        first..first + vertices.len() as u32
    }

    /// Kept equation of an equation, or [`FIXED`].
    pub fn kept_of(&self, equation: u32) -> u32 {
        self.kept_of[equation as usize]
    }

    /// `dofs` with kept equations only; all other components count as without equation.
    pub fn kept_dofs(&self, dofs: &DofMap) -> DofMap {
        let kept = |equation: u32| match equation {
            FIXED => FIXED,
            _ => self.kept_of[equation as usize],
        };
        DofMap {
            equations: dofs.equations.iter().map(|e| e.map(kept)).collect(),
            vertex_start: self.vertex_start.clone(),
            planes: dofs.planes.clone(),
            prescribed: dofs.prescribed.clone(),
        }
    }

    /// Vertices of each condensed part: they are coupled in full.
    pub fn cliques(&self) -> impl Iterator<Item = Vec<u32>> {
        self.superelements.iter().map(|(r, _)| r.clone().collect())
    }

    /// Adds the condensed stiffness on the kept equations.
    pub fn add_stiffness(&self, pattern: &Pattern, matrix: &mut SymmetricMatrix) {
        for (vertices, schur) in &self.superelements {
            let first = self.vertex_start[vertices.start as usize] as usize;
            for column in 0..schur.ncols() {
                // Below the diagonal a column of the part begins with the part's own rows.
                let start = pattern.columns[first + column] as usize;
                let values = &mut matrix.values[start..start + schur.nrows() - column];
                for (offset, value) in values.iter_mut().enumerate() {
                    *value += schur[(column + offset, column)];
                }
            }
        }
    }

    /// Forgets the condensed stiffness, once it is in the matrix.
    pub fn release(&mut self) {
        self.superelements = Vec::new();
    }

    /// Forgets the factors as well.
    pub fn forget(&mut self) {
        self.parts = Vec::new();
    }

    /// Eliminates inner unknowns from a vector of forces.
    pub fn reduce(&self, forces: &mut [f64]) {
        self.locally(forces, Substructure::reduce);
    }

    /// Kept entries of a vector.
    pub fn restrict(&self, full: &[f64]) -> Vec<f64> {
        self.kept.iter().map(|e| full[*e as usize]).collect()
    }

    /// All unknowns from the kept ones and the reduced forces, in place of the latter.
    pub fn recover(&self, x: &[f64], reduced: &mut [f64]) {
        for (equation, value) in self.kept.iter().zip(x) {
            reduced[*equation as usize] = *value;
        }
        self.locally(reduced, Substructure::recover);
    }

    fn locally(&self, vector: &mut [f64], work: fn(&Substructure, &mut [f64])) {
        let done: Vec<Vec<f64>> = self
            .parts
            .par_iter()
            .map(|part| {
                let entries = part.equations.iter().map(|e| vector[*e as usize]);
                let mut local: Vec<f64> = entries.collect();
                work(&part.substructure, &mut local);
                local
            })
            .collect();
        for (part, local) in self.parts.iter().zip(done) {
            for (equation, value) in part.equations.iter().zip(local) {
                vector[*equation as usize] = value;
            }
        }
    }

    /// Entries of all factors.
    pub fn factor_entries(&self) -> usize {
        let parts = self.parts.iter();
        parts
            .map(|p| p.substructure.condensation().factor_entries())
            .sum()
    }
}

/// Groups of bodies that share vertices.
fn groups(plan: &Condensing, vertex_of: &[u32]) -> Vec<Group> {
    let mesh = &plan.scene.mesh;
    let vertices = plan.dofs.vertex_start.len() - 1;
    let mut owner = vec![None::<usize>; vertices];
    // The group of a body is the lowest body that it hangs together with.
    let mut group: Vec<usize> = (0..mesh.bodies.len()).collect();
    for (index, body) in mesh.bodies.iter().enumerate() {
        for element in body.elements.clone() {
            for equation in equations(plan, element) {
                if equation == FIXED {
                    continue;
                }
                let slot = &mut owner[vertex_of[equation as usize] as usize];
                let (a, b) = (group[*slot.get_or_insert(index)], group[index]);
                if a != b {
                    let (low, high) = (a.min(b), a.max(b));
                    group
                        .iter_mut()
                        .filter(|g| **g == high)
                        .for_each(|g| *g = low);
                }
            }
        }
    }
    let touched = |elements: &[u32]| {
        let mut touched = vec![false; vertices];
        for element in elements {
            let free = equations(plan, *element as usize).into_iter();
            free.filter(|e| *e != FIXED)
                .for_each(|e| touched[vertex_of[e as usize] as usize] = true);
        }
        touched
    };
    let mut made: Vec<Group> = Vec::new();
    for index in 0..mesh.bodies.len() {
        let members = (0..mesh.bodies.len()).filter(|b| group[*b] == index);
        let (flow, elements): (Vec<u32>, Vec<u32>) = members
            .flat_map(|b| mesh.bodies[b].elements.clone())
            .map(|e| e as u32)
            .partition(|e| plan.flow.binary_search(e).is_ok());
        let (inside, zone) = (touched(&elements), touched(&flow));
        let of = |mark: &dyn Fn(usize) -> bool| -> Vec<u32> {
            (0..vertices)
                .filter(|v| mark(*v))
                .map(|v| v as u32)
                .collect()
        };
        made.push(Group {
            vertices: of(&|v| inside[v]),
            zone: of(&|v| zone[v] && !inside[v]),
            elements,
        });
    }
    made.retain(|group| !group.vertices.is_empty() || !group.zone.is_empty());
    made
}

/// Condenses a group where that pays.
fn make(plan: &Condensing, vertex_of: &[u32], group: Group) -> Result<Made, SolveError> {
    let kept: Vec<bool> = group
        .vertices
        .iter()
        .map(|v| plan.needed[*v as usize])
        .collect();
    let count = kept.iter().filter(|k| **k).count();
    if !plan.condense || count == 0 || 3 * count > kept.len() {
        return Ok(Made::Sparse(group));
    }
    let (equations, local_of) = numbering(plan, &group);
    let pattern = local_pattern(plan, vertex_of, &group);
    let condensation = Condensation::new(&pattern, &kept)?;
    // Each iteration factorises what is kept as a dense matrix.
    if (condensation.kept() as f64).powi(3) / 6.0 > condensation.work() {
        return Ok(Made::Sparse(group));
    }
    let matrix = assemble_elastic(plan, &group.elements, &pattern, |e| local_of[e as usize]);
    match condensation.eliminate(&pattern, matrix) {
        Ok((substructure, schur)) => Ok(Made::Condensed(Box::new(Condensed {
            zone: group.zone,
            kept_vertices: (group.vertices.iter().zip(&kept))
                .filter_map(|(v, kept)| kept.then_some(*v))
                .collect(),
            part: Part {
                equations,
                substructure,
            },
            schur,
        }))),
        // Held at the kept nodes alone it could still turn.
        Err(FactorError::NotPositiveDefinite { .. }) => Ok(Made::Sparse(group)),
        Err(error) => Err(error.into()),
    }
}

/// Equations of a group, ascending, and the position of each equation among them.
fn numbering(plan: &Condensing, group: &Group) -> (Vec<u32>, Vec<u32>) {
    let starts = &plan.dofs.vertex_start;
    let equations: Vec<u32> = group
        .vertices
        .iter()
        .flat_map(|v| starts[*v as usize]..starts[*v as usize + 1])
        .collect();
    let mut local_of = vec![FIXED; plan.dofs.len()];
    for (local, equation) in equations.iter().enumerate() {
        local_of[*equation as usize] = local as u32;
    }
    (equations, local_of)
}

fn local_pattern(plan: &Condensing, vertex_of: &[u32], group: &Group) -> Pattern {
    let mut local = vec![0u32; plan.needed.len()];
    let mut starts = vec![0];
    for (number, vertex) in group.vertices.iter().enumerate() {
        let vertex = *vertex as usize;
        local[vertex] = number as u32;
        let equations = plan.dofs.vertex_start[vertex + 1] - plan.dofs.vertex_start[vertex];
        starts.push(starts[number] + equations);
    }
    let cliques: Vec<Vec<u32>> = group
        .elements
        .iter()
        .map(|e| {
            let equations = equations(plan, *e as usize);
            let free = equations.iter().filter(|e| **e != FIXED);
            let mut list: Vec<u32> = free
                .map(|e| local[vertex_of[*e as usize] as usize])
                .collect();
            list.sort_unstable();
            list.dedup();
            list
        })
        .collect();
    Pattern::new(starts, cliques.iter().map(Vec::as_slice))
}

fn equations(plan: &Condensing, element: usize) -> [u32; 24] {
    plan.dofs.of_element(&plan.scene.mesh, element)
}

/// Elastic stiffness of elements on a pattern whose equations are numbered by `number`.
pub fn assemble_elastic(
    plan: &Condensing,
    elements: &[u32],
    pattern: &Pattern,
    number: impl Fn(u32) -> u32,
) -> SymmetricMatrix {
    // Element matrices in parallel, a batch at a time; sums in element order.
    let mesh = &plan.scene.mesh;
    let mut matrix = pattern.zeros();
    for batch in elements.chunks(ELEMENTS_PER_BATCH) {
        let blocks: Vec<_> = batch
            .par_iter()
            .map(|e| {
                let moduli = &plan.elastic[mesh.body_of(*e as usize)];
                Box::new(shaped(plan.scene, *e as usize).stiffness(moduli))
            })
            .collect();
        for (element, block) in batch.iter().zip(blocks) {
            let equations = equations(plan, *element as usize).map(|e| match e {
                FIXED => FIXED,
                _ => number(e),
            });
            pattern.add_block(&mut matrix, &equations, |i, j| block[i][j]);
        }
    }
    matrix
}

/// An element with its shape.
pub fn shaped(scene: &Scene, element: usize) -> Element {
    Element::new(scene.controls.element, &scene.mesh.corners(element))
}
