//! A scene made ready to be solved: equations, elastic stiffness, contact rows, load vectors.

use crate::model::material::Moduli;
use crate::model::scene::Scene;
use crate::solver::fem::dofs::{DofMap, ElementTerms, FIXED, Source};
use crate::solver::fem::element::Element;
use crate::solver::linear::cholesky::Symbolic;
use crate::solver::linear::preconditioner::Preconditioner;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use crate::solver::solve::condensed::assembly::shaped;
use crate::solver::solve::condensed::static_condensation::CondensedBodies;
use crate::solver::solve::model::thermal::Heated;
use crate::solver::solve::params::SMALL_DIVIDED_MODEL;
use crate::solver::solve::rows::contact_row::ContactRow;

/// The scene, discretised. Newton iterations see its kept unknowns only, see [`CondensedBodies`].
pub struct Model<'a> {
    pub scene: &'a Scene,
    /// All unknowns.
    pub all: DofMap,
    /// The kept ones; everything below is about these.
    pub dofs: DofMap,
    pub bodies: CondensedBodies,
    pub elastic: Vec<Moduli>,
    pub pattern: Pattern,
    pub preconditioner: Preconditioner,
    /// Stiffness of all bodies as long as they are elastic.
    pub stiffness: SymmetricMatrix,
    pub rows: Vec<ContactRow>,
    /// Contact rows that are not expected to close.
    pub spare: Vec<ContactRow>,
    /// Elements whose yield condition is checked in every iteration.
    pub yielding: Vec<u32>,
    /// Forces at factor one, inner unknowns eliminated: of each traction, of each rigid plane, of
    /// nonzero prescribed displacements and of temperatures.
    pub loads: Vec<(String, Vec<f64>)>,
    /// Bodies with thermal strain.
    pub heated: Vec<Heated>,
    /// The largest force that the steps apply. Beside prescribed forces prescribed displacements count by how they strain a body that
    /// goes with them, else by how it resists where it was.
    pub reference: f64,
    /// Beyond this initial gap no contact was integrated.
    pub reach: f64,
    /// Bytes that it takes in all, estimated.
    pub memory: f64,
}

impl Model<'_> {
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
            let kept = self.element_terms(*element);
            (all.all().zip(kept.all())).all(|(all, kept)| all == FIXED || kept != FIXED)
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
        if let Ok(none) = Symbolic::new(&self.pattern, &[]) {
            self.preconditioner = Preconditioner::Direct(Box::new(none));
        }
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

    /// How an element's 24 components hang on the kept equations.
    pub fn element_terms(&self, element: u32) -> ElementTerms {
        self.dofs.of_element(&self.scene.mesh, element as usize)
    }
}

/// Are corrections of a divided model, or not, of so many unknowns right to a hundredth only? Where there are few,
/// directions cost next to nothing.
pub fn is_soft(divided: bool, unknowns: usize) -> bool {
    divided && unknowns > SMALL_DIVIDED_MODEL
}
