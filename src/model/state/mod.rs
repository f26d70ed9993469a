//! What a solution is: displacements, stresses, plastic strains and contact at the end of an increment.

mod fit;
pub mod turn;

pub use fit::Misfit;

use serde::{Deserialize, Serialize};

/// The converged state at the end of an increment, in the units of the scene.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct State {
    /// Step index and share of the step that is done, in (0, 1].
    pub step: usize,
    /// Share of the step that is done, in (0, 1].
    pub time: f64,
    /// Displacement of every node.
    pub displacement: Vec<[f64; 3]>,
    /// Stress xx yy zz xy yz zx at the eight integration points of every element.
    pub stress: Vec<[[f64; 6]; 8]>,
    /// Equivalent plastic strain at the eight integration points of every element.
    pub peeq: Vec<[f64; 8]>,
    /// One field a contact pair, in the order of the scene.
    pub contacts: Vec<ContactField>,
    /// One field a tie, in the order of the scene.
    #[serde(default)]
    pub ties: Vec<TieField>,
    /// Travel of the rigid planes, in the order of the scene.
    pub planes: Vec<PlaneField>,
    /// Where the work of the loads went, on the modelled part; `None` where that is not known.
    pub energy: Option<Energy>,
}

/// Work since the start, and what became of it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Energy {
    /// Of loads and moved planes.
    pub work: f64,
    /// Stored in the bodies.
    pub elastic: f64,
    /// Spent in plastic flow, hardening included.
    pub plastic: f64,
    /// Spent in friction.
    pub friction: f64,
    /// Of pressures on gaps that close within an increment: vanishes with the size of increments.
    pub contact: f64,
    /// Work of all increments, each counted positive.
    pub turned_over: f64,
}

impl Energy {
    /// Times `copies`: of the whole, from the modelled part.
    pub fn times(&self, copies: f64) -> Self {
        Self {
            work: copies * self.work,
            elastic: copies * self.elastic,
            plastic: copies * self.plastic,
            friction: copies * self.friction,
            contact: copies * self.contact,
            turned_over: copies * self.turned_over,
        }
    }

    /// What is not accounted for, of the work turned over; `None` where there is none.
    pub fn imbalance(&self) -> Option<f64> {
        let spent = self.elastic + self.plastic + self.friction + self.contact;
        let share = (self.work - spent).abs() / self.turned_over;
        share.is_finite().then_some(share)
    }
}

/// What happens on the carrier surface of a contact pair, node by node.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct ContactField {
    /// Mesh nodes of the carrier surface, ascending.
    pub nodes: Vec<u32>,
    /// Consistent nodal pressure ∫ N p dA / ∫ N dA, compression positive: the normal force of the
    /// node over the area that it stands for. Beside the nodes in contact it is positive, too.
    pub pressure: Vec<f64>,
    /// Coefficient of the node's hat function in the pressure p = Σ c N; zero where open. It
    /// oscillates where contact ends within an element: for integrals of p, never to be read.
    pub multiplier: Vec<f64>,
    /// Gap, open positive; infinite where the other side does not face the node.
    pub gap: Vec<f64>,
    /// Consistent nodal tangential traction on the lower body.
    pub traction: Vec<[f64; 3]>,
    /// Accumulated slip length.
    pub slip: Vec<f64>,
    /// 0 open, 1 stick, 2 slip.
    pub status: Vec<u8>,
    /// Area that each node stands for (the integral of its shape function over the covered area).
    pub area: Vec<f64>,
    /// Contact force of each node on the lower body.
    pub force: Vec<[f64; 3]>,
    /// Where that force acts on the undeformed carrier surface and on the one opposite: the centre of
    /// what the node stands for. At the rim that is not the node.
    pub acts_at: Vec<[[f64; 3]; 2]>,
    /// By how much flat facets around each node may miss the shapes that touch there, as a length.
    pub sagitta: Vec<f64>,
    /// Deepest overlap of the two sides, zero or positive: from nodes and middles of facets to the
    /// other side's true shape, whatever the contact conditions say.
    pub penetration: f64,
    /// What of it is deeper than the facets explain, by their sagittas, beside gaps that open at the rim of contact.
    pub at_rim: f64,
    /// What of it is deeper than the facets and the rim explain.
    pub unexplained: f64,
    /// Undeformed place of that on the carrier; `None` where there is none.
    pub unexplained_at: Option<[f64; 3]>,
}

/// A rigid plane in a converged state.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct PlaneField {
    /// Displacement of the plane's point, from the state in which all interfaces just touch.
    pub travel: [f64; 3],
    /// Angles that it has turned by about axes through its point, in radians.
    pub turn: [f64; 3],
    /// Total force on the plane (applied, or the reaction where held), modelled part only.
    pub force: [f64; 3],
    /// Moment on the plane about its point (applied, or the reaction where held), modelled part only.
    pub moment: [f64; 3],
}

/// What a tie carries, node by node of the surface whose nodes follow the other one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct TieField {
    /// Index of that surface in the tie: 0 or 1.
    pub follows: usize,
    /// Its mesh nodes that the other surface covers, ascending.
    pub nodes: Vec<u32>,
    /// Area that each node stands for.
    pub area: Vec<f64>,
    /// Force of each node on the second surface of the tie.
    pub force: Vec<[f64; 3]>,
    /// Normal stress across the tie, compression positive: the force over the area.
    pub pressure: Vec<f64>,
    /// Shear stress across the tie, on the second surface.
    pub shear: Vec<[f64; 3]>,
    /// The largest distance of the two surfaces, a length.
    pub distance: f64,
    /// Share of the area of the surface that follows which the other one covers.
    pub covered: f64,
}

impl ContactField {
    /// Is node `at` of the field in contact?
    pub fn is_active(&self, at: usize) -> bool {
        self.status[at] != 0
    }

    /// A field on `nodes` that touches nowhere.
    pub fn open(nodes: Vec<u32>) -> Self {
        let count = nodes.len();
        Self {
            nodes,
            pressure: vec![0.0; count],
            multiplier: vec![0.0; count],
            gap: vec![f64::INFINITY; count],
            traction: vec![[0.0; 3]; count],
            slip: vec![0.0; count],
            status: vec![0; count],
            area: vec![0.0; count],
            force: vec![[0.0; 3]; count],
            acts_at: vec![[[0.0; 3]; 2]; count],
            sagitta: vec![0.0; count],
            penetration: 0.0,
            at_rim: 0.0,
            unexplained: 0.0,
            unexplained_at: None,
        }
    }
}
