//! A scene made ready to be solved: equations, elastic stiffness, contact rows, load vectors.

use super::driver::SolveError;
use super::timers::Timers;
use crate::contact::law::Law;
use crate::contact::mortar::{self, Opposite, Row};
use crate::fem::dofs::{DofMap, FIXED, Source};
use crate::fem::element::Element;
use crate::fem::loads;
use crate::linear::cholesky::Symbolic;
use crate::linear::sparse::{Pattern, SymmetricMatrix};
use crate::material::Elastic;
use crate::mesh::Mesh;
use crate::scene::{Partner, PlaneMotion, Scene, Side, Step};
use rayon::prelude::*;

/// Penalty over the stiffness of the material next to the contact, at a user factor of one.
///
/// The augmented-Lagrange update makes the answer independent of it; it only has to be stiff
/// enough that few updates are needed and soft enough that the factor stays accurate.
const PENALTY: f64 = 1000.0;

/// The same for shear against slip: softer, since sticking and slipping nodes trade places.
const TANGENTIAL_PENALTY: f64 = 30.0;

/// How often the expensive parts ran.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Counters {
    pub iterations: usize,
    pub cut_backs: usize,
    pub factorisations: usize,
    pub linear_solves: usize,
    pub krylov_directions: usize,
    /// Integration points whose yield condition was checked.
    pub plastic_updates: usize,
    /// Contact nodes whose friction law was evaluated.
    pub friction_updates: usize,
    pub equations: usize,
    pub factor_entries: usize,
    pub contact_rows: usize,
    pub timers: Timers,
}

/// A contact row with its pair's law.
pub struct ContactRow {
    pub row: Row,
    pub pair: usize,
    pub law: Law,
}

/// The scene, discretised.
pub struct Model<'a> {
    pub scene: &'a Scene,
    pub dofs: DofMap,
    pub elastic: Vec<Elastic>,
    pub pattern: Pattern,
    pub symbolic: Symbolic,
    /// Stiffness of all bodies as long as they are elastic.
    pub stiffness: SymmetricMatrix,
    pub rows: Vec<ContactRow>,
    /// Elements of bodies that can yield.
    pub yielding: Vec<u32>,
    /// Nodal forces of each traction, then of each rigid plane, at factor one.
    loads: Vec<(String, Vec<f64>)>,
    /// Forces of nonzero prescribed displacements on the free equations, at factor one.
    prescribed: Vec<(String, Vec<f64>)>,
    /// Beyond this initial gap no contact was prepared.
    pub reach: f64,
}

impl<'a> Model<'a> {
    /// Prepares `scene` with contact rows up to an initial gap of `reach`.
    pub fn new(scene: &'a Scene, reach: f64) -> Result<Self, SolveError> {
        let mesh = &scene.mesh;
        let dofs = DofMap::new(scene)?;
        if dofs.is_empty() {
            return Err(SolveError::NothingFree);
        }
        let elastic: Vec<Elastic> = scene.materials.iter().map(|m| m.moduli()).collect();
        let rows = contact_rows(scene, reach);
        let pattern = pattern(mesh, &dofs, &rows);
        let symbolic = Symbolic::new(&pattern, 0)?;
        let stiffness = elastic_stiffness(scene, &dofs, &elastic, &pattern);
        let yielding = if scene.controls.plasticity {
            let bodies = mesh.bodies.iter().zip(&scene.materials);
            bodies
                .filter(|(_, steel)| !steel.is_elastic())
                .flat_map(|(body, _)| body.elements.clone().map(|e| e as u32))
                .collect()
        } else {
            Vec::new()
        };
        let mut model = Self {
            loads: load_vectors(scene, &dofs),
            prescribed: Vec::new(),
            scene,
            elastic,
            pattern,
            symbolic,
            stiffness,
            rows,
            yielding,
            reach,
            dofs,
        };
        model.prescribed = model.prescribed_forces();
        Ok(model)
    }

    /// Factor of the load `name` at `time` within step `index`.
    pub fn factor(&self, name: &str, index: usize, time: f64) -> f64 {
        let steps = &self.scene.steps;
        let before = index.checked_sub(1).and_then(|i| steps.get(i));
        let before = before.map_or(0.0, |step: &Step| step.factor_of(name));
        let after = steps.get(index).map_or(before, |step| step.factor_of(name));
        before + time * (after - before)
    }

    /// Applied forces on the equations at `time` within step `step`, the elastic reaction to
    /// prescribed displacements included.
    pub fn external(&self, step: usize, time: f64) -> Vec<f64> {
        let mut out = vec![0.0; self.dofs.len()];
        for (name, vector) in self.loads.iter().chain(&self.prescribed) {
            let factor = self.factor(name, step, time);
            for (o, v) in out.iter_mut().zip(vector) {
                *o += factor * v;
            }
        }
        out
    }

    /// Nodal displacements for the solution `x` at `time` within step `step`.
    pub fn displacement(&self, x: &[f64], step: usize, time: f64) -> Vec<[f64; 3]> {
        let mut nodal = vec![[0.0; 3]; self.scene.mesh.points.len()];
        self.dofs.scatter_add(x, 1.0, &mut nodal);
        for p in &self.dofs.prescribed {
            if p.value != 0.0 {
                let factor = self.factor(self.source_name(p.source), step, time);
                nodal[p.node as usize][p.axis] = factor * p.value;
            }
        }
        nodal
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
        element_equations(&self.scene.mesh, &self.dofs, element as usize)
    }

    /// −K u for the prescribed displacements of each source that has any.
    fn prescribed_forces(&self) -> Vec<(String, Vec<f64>)> {
        let mesh = &self.scene.mesh;
        let mut sources: Vec<Source> = Vec::new();
        for p in self.dofs.prescribed.iter().filter(|p| p.value != 0.0) {
            if !sources.contains(&p.source) {
                sources.push(p.source);
            }
        }
        let forces = sources.into_iter().map(|source| {
            let mut u = vec![[0.0; 3]; mesh.points.len()];
            for p in self.dofs.prescribed.iter().filter(|p| p.source == source) {
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
            (
                self.source_name(source).to_owned(),
                self.dofs.gather(&force),
            )
        });
        forces.collect()
    }
}

fn element_equations(mesh: &Mesh, dofs: &DofMap, element: usize) -> [u32; 24] {
    let nodes = mesh.hexes[element];
    std::array::from_fn(|k| dofs.equations[nodes[k / 3] as usize][k % 3])
}

/// Contact rows of all pairs.
fn contact_rows(scene: &Scene, reach: f64) -> Vec<ContactRow> {
    let moduli: Vec<f64> = scene
        .materials
        .iter()
        .map(|m| m.youngs_modulus / (1.0 - m.poissons_ratio * m.poissons_ratio))
        .collect();
    let mut all = Vec::new();
    for (index, pair) in scene.contacts.iter().enumerate() {
        let (carrier, other) = match pair.carrier {
            Side::Upper => (&pair.upper, &pair.lower),
            Side::Lower => (&pair.lower, &pair.upper),
        };
        let rows = pair_rows(scene, carrier, other, pair.true_geometry, reach, &moduli);
        all.extend(rows.into_iter().map(|row| ContactRow {
            law: Law {
                friction: pair.friction,
                penalty: PENALTY * pair.penalty_factor * row.stiffness,
                tangential_penalty: TANGENTIAL_PENALTY * pair.penalty_factor * row.stiffness,
                stiffness: row.stiffness,
            },
            pair: index,
            row,
        }));
    }
    all
}

/// Rows of one pair.
pub fn pair_rows(
    scene: &Scene,
    carrier: &Partner,
    other: &Partner,
    true_geometry: bool,
    reach: f64,
    moduli: &[f64],
) -> Vec<Row> {
    let mesh = &scene.mesh;
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
        true_geometry,
        reach,
        moduli,
        mirrors: &scene.mirrors,
    })
}

fn pattern(mesh: &Mesh, dofs: &DofMap, rows: &[ContactRow]) -> Pattern {
    let mut vertex_of = vec![0u32; dofs.len()];
    for (vertex, range) in dofs.vertex_start.windows(2).enumerate() {
        vertex_of[range[0] as usize..range[1] as usize].fill(vertex as u32);
    }
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
    let elements = mesh
        .hexes
        .iter()
        .map(|nodes| vertices(&mut nodes.iter().copied()));
    let contacts = rows
        .iter()
        .map(|r| vertices(&mut r.row.terms.iter().map(|t| t.0)));
    let cliques: Vec<Vec<u32>> = elements.chain(contacts).collect();
    Pattern::new(dofs.vertex_start.clone(), cliques.iter().map(Vec::as_slice))
}

fn shaped(scene: &Scene, element: usize) -> Element {
    Element::new(scene.controls.element, &scene.mesh.corners(element))
}

fn elastic_stiffness(
    scene: &Scene,
    dofs: &DofMap,
    elastic: &[Elastic],
    pattern: &Pattern,
) -> SymmetricMatrix {
    // Element matrices in parallel, a batch at a time; sums in element order.
    const BATCH: usize = 1024;
    let mesh = &scene.mesh;
    let mut matrix = pattern.zeros();
    for start in (0..mesh.hexes.len()).step_by(BATCH) {
        let end = (start + BATCH).min(mesh.hexes.len());
        let blocks: Vec<_> = (start..end)
            .into_par_iter()
            .map(|e| Box::new(shaped(scene, e).stiffness(&elastic[mesh.body_of(e)])))
            .collect();
        for (e, block) in (start..end).zip(blocks) {
            let equations = element_equations(mesh, dofs, e);
            pattern.add_block(&mut matrix, &equations, |i, j| block[i][j]);
        }
    }
    matrix
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
