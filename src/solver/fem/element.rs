//! One hexahedron as the solver sees it, whatever its formulation.

use super::bbar::{self, ElementMatrix, ElementVector};
use super::enhanced::Enhanced;
use super::hex8::Geometry;
use crate::model::material::j2::{self, Flow, PlasticPoint};
use crate::model::material::{Moduli, Steel};
use crate::model::scene::ElementKind;

/// A hexahedron of given shape.
///
/// Inner unknowns, where the formulation has any, are eliminated: only the displacements of the
/// eight corners come in, only forces on them come out.
#[derive(Debug, Clone)]
#[expect(
    clippy::large_enum_variant,
    reason = "lives on the stack for one turn of a loop over elements"
)]
pub enum Element {
    /// Without inner unknowns: B-bar, or plain and fully integrated.
    Displacement(Geometry),
    Enhanced(Enhanced),
}

/// Histories at the end of an update, and where the integration points flow in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementResponse {
    /// Histories at the integration points.
    pub points: [PlasticPoint; 8],
    /// The flow of each point that flows.
    pub flows: [Option<Flow>; 8],
}

impl Element {
    /// From the corner coordinates of a valid (not inverted) element.
    pub fn new(kind: ElementKind, corners: &[[f64; 3]; 8]) -> Self {
        match kind {
            ElementKind::Bbar => Self::Displacement(Geometry::new(corners)),
            ElementKind::Full => Self::Displacement(Geometry::plain(corners)),
            ElementKind::Enhanced => Self::Enhanced(Enhanced::new(corners)),
        }
    }

    /// Elastic stiffness.
    pub fn stiffness(&self, elastic: &Moduli) -> ElementMatrix {
        match self {
            Self::Displacement(g) => bbar::stiffness(g, elastic),
            Self::Enhanced(e) => e.stiffness(elastic),
        }
    }

    /// Forces of the elastic element at corner displacements `u`: the stiffness times `u`.
    pub fn elastic_force(&self, elastic: &Moduli, u: &ElementVector) -> ElementVector {
        let stiffness = self.stiffness(elastic);
        let u = u.as_flattened();
        let row = |i: usize| stiffness[i].iter().zip(u).map(|(k, u)| k * u).sum();
        std::array::from_fn(|a| std::array::from_fn(|i| row(3 * a + i)))
    }

    /// Histories and flow at corner displacements `u`, from the histories `old`. `None` where the
    /// inner unknowns find no balance: the displacements are far off.
    pub fn answer(
        &self,
        steel: &Steel,
        elastic: &Moduli,
        u: &ElementVector,
        old: &[PlasticPoint; 8],
    ) -> Option<ElementResponse> {
        let mut points = *old;
        let mut flows = [None; 8];
        match self {
            Self::Displacement(g) => {
                for k in 0..8 {
                    let update = j2::update(steel, elastic, &bbar::strain(g, k, u), &old[k]);
                    (points[k], flows[k]) = (update.point, update.flow);
                }
            }
            Self::Enhanced(e) => (points, flows) = e.answer(steel, elastic, u, old)?,
        }
        Some(ElementResponse { points, flows })
    }

    /// Force that the plastic strain of `points` takes off the elastic answer: the internal force
    /// is the stiffness times the displacement, minus this.
    pub fn relief(&self, elastic: &Moduli, points: &[PlasticPoint; 8]) -> ElementVector {
        match self {
            Self::Displacement(g) => {
                let mut relief = [[0.0; 3]; 8];
                for (k, point) in points.iter().enumerate() {
                    bbar::add_stress_force(g, k, &elastic.stress(&point.strain), &mut relief);
                }
                relief
            }
            Self::Enhanced(e) => e.relief(elastic, points),
        }
    }

    /// What the flow changes in the stiffness: the consistent tangent is the elastic stiffness
    /// plus this.
    pub fn tangent_change(&self, elastic: &Moduli, flows: &[Option<Flow>; 8]) -> ElementMatrix {
        match self {
            Self::Displacement(g) => {
                let mut change = [[0.0; 24]; 24];
                for (k, flow) in flows.iter().enumerate() {
                    let Some(flow) = flow else { continue };
                    let volume = g.volumes[k];
                    let factor = (flow.beta - 1.0) * elastic.shear * volume;
                    bbar::add_deviatoric(g, k, factor, &mut change);
                    let factor = -flow.softening * volume;
                    bbar::add_direction(g, k, &flow.direction, factor, &mut change);
                }
                change
            }
            Self::Enhanced(e) => e.tangent_change(elastic, flows),
        }
    }

    /// Stress at the integration points at corner displacements `u` and the histories `points`
    /// that belong to them.
    pub fn stress(
        &self,
        elastic: &Moduli,
        u: &ElementVector,
        points: &[PlasticPoint; 8],
    ) -> [[f64; 6]; 8] {
        match self {
            Self::Displacement(g) => std::array::from_fn(|k| {
                let strain = bbar::strain(g, k, u);
                elastic.stress(&std::array::from_fn(|i| strain[i] - points[k].strain[i]))
            }),
            Self::Enhanced(e) => e.stress(elastic, u, points),
        }
    }
}
