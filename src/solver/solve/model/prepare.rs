//! Making the model of a scene.

use crate::ground::memory::available;
use crate::model::material::Moduli;
use crate::model::scene::{Scene, SolverKind};
use crate::solver::fem::tied::Tied;
use crate::solver::linear::preconditioner::Preconditioner;
use crate::solver::linear::schwarz::Schwarz;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::condensed::assembly::{Condensing, assemble_elastic};
use crate::solver::solve::condensed::size::Size;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::model::loads::{Rest, load_vectors};
use crate::solver::solve::model::places::places;
use crate::solver::solve::model::structure::{Structure, needed};
use crate::solver::solve::model::system::{Model, is_soft};
use crate::solver::solve::model::thermal::{Heated, thermal_forces};
use crate::solver::solve::params::MOVED_DIGITS;
use crate::solver::solve::rows::contact_row::{ContactRow, law};
use crate::solver::solve::ties::unknowns::equations;
use std::sync::Arc;

impl<'a> Model<'a> {
    /// Prepares `scene` with its contact `rows`, `tied` as it is, for what is expected to happen.
    ///
    /// # Errors
    /// [`SolveError`] where supports contradict each other, nothing is free or memory runs out.
    pub fn new(
        scene: &'a Scene,
        expected: &Expected,
        (rows, tied): (Vec<ContactRow>, Arc<Tied>),
    ) -> Result<Self, SolveError> {
        let all = equations(scene, tied)?;
        if all.is_empty() {
            return Err(SolveError::NothingFree);
        }
        let elastic: Vec<Moduli> = scene.materials.iter().map(|m| m.moduli()).collect();
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
            heated: Heated::all(scene),
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
        let thermal = thermal_forces(scene, &model.heated, &model.all);
        let still = model.prescribed_forces(Rest::Still);
        // Beside prescribed forces it matters whether a body goes along with what moves it.
        let goes_along = !still.is_empty() && model.largest(&model.loads) > 0.0;
        let strained = goes_along.then(|| {
            let carried = model.prescribed_forces(Rest::Carried);
            let loads = [model.loads.as_slice(), &carried, &thermal].concat();
            model.largest(&loads)
        });
        model.loads.extend(still);
        model.loads.extend(thermal);
        let moved = model.largest(&model.loads);
        if !(moved * moved).is_finite() {
            return Err(SolveError::OutOfRange);
        }
        model.reference = strained.map_or(moved, |strained| strained.max(MOVED_DIGITS * moved));
        for (_, vector) in &mut model.loads {
            model.bodies.reduce(vector);
        }
        Ok(model)
    }
}
