//! A scene with everything that a deck needs to know of it.

use super::names::Names;
use super::settings::Settings;
use crate::model::mesh::Face;
use crate::model::scene::{ElementKind, Scene};
use std::collections::BTreeMap;

/// The scene with what the deck needs to know of it. Everything is in the units of the case, and on the modelled part.
pub struct Deck<'a> {
    pub scene: &'a Scene,
    pub settings: &'a Settings,
    pub names: Names,
    pub pairs: Vec<DeckPair>,
    pub ties: Vec<DeckTie>,
    pub driven: Vec<Driven>,
    pub turning: Vec<Turning>,
    pub springs: Vec<Springs>,
    /// The springs of a body and axis together would carry this share of the load if the body moved by a thousandth
    /// of the model.
    pub spring_share: f64,
    /// Pressure per overclosure.
    pub stiffness: f64,
    /// By step, then by traction: the forces on nodes that stand for the traction; empty for a pressure, which decks
    /// know.
    pub nodal_forces: Vec<Vec<Vec<NodalForce>>>,
    pub heat: Heat,
}

/// What temperatures do.
#[derive(Default)]
pub struct Heat {
    /// Coefficients of thermal expansion, per kelvin, by bodies that have a temperature.
    pub expansions: BTreeMap<usize, f64>,
    /// Of their nodes, by step.
    pub steps: Vec<Vec<NodalTemperature>>,
}

/// A difference of temperature of a node at the end of a step, in kelvin.
pub struct NodalTemperature {
    pub node: u32,
    pub value: f64,
}

/// A force along an axis on a node.
pub struct NodalForce {
    pub node: u32,
    pub axis: usize,
    pub force: f64,
}

/// A pair as the deck has it.
pub struct DeckPair {
    /// Of the law.
    pub name: String,
    /// Of the face sets: carrier (slave) and the other side (master).
    pub sides: [String; 2],
    /// In the order of the sides.
    pub faces: [Vec<Face>; 2],
    /// Coefficient of friction.
    pub friction: f64,
    /// Does Brinell take cylinders of the pair as round in the initial gap?
    pub true_geometry: bool,
}

/// A tie as the deck has it.
pub struct DeckTie {
    /// Its name.
    pub name: String,
    /// Of the face sets: that which follows (slave) and the other one (master).
    pub sides: [String; 2],
    /// In the order of the sides.
    pub faces: [Vec<Face>; 2],
    /// Nodes farther from the other side are not tied, a length.
    pub tolerance: f64,
}

/// An axis along which the nodes of a rigid plane move as one.
pub struct Driven {
    /// Name of the plane.
    pub plane: String,
    pub axis: usize,
    /// On the modelled part, at factor one.
    pub force: f64,
    /// The node that stands for all, and the others; none where the plane [turns](Turning) too.
    pub reference: u32,
    pub others: Vec<u32>,
    /// How far the closing step moves it, unless told: the shortening of a solid block.
    pub closing: f64,
}

/// A rigid plane that turns.
pub struct Turning {
    /// Its place among those of the scene.
    pub plane: usize,
    /// Name of the set of its two nodes.
    pub set: String,
    /// Where its point is.
    pub at: [f64; 3],
    /// The node that is its point, counted from zero; the next one has the angles.
    pub reference: u32,
    /// What follows them.
    pub followers: Vec<DeckFollower>,
}

/// A node that follows a rigid plane along an axis.
pub struct DeckFollower {
    pub node: u32,
    pub axis: usize,
    /// Axes that the plane turns about, each with the motion for an angle of one.
    pub levers: Vec<(usize, f64)>,
}

/// Springs on a body along one axis.
pub struct Springs {
    /// Of the element set.
    pub name: String,
    pub axis: usize,
    pub nodes: Vec<u32>,
    /// Of each spring, force per length.
    pub stiffness: f64,
}

impl Deck<'_> {
    /// The element type.
    pub(super) fn element(&self) -> &str {
        match (&self.settings.element, self.scene.controls.element) {
            (Some(element), _) => element,
            (None, ElementKind::Enhanced) => "C3D8I",
            (None, ElementKind::Bbar | ElementKind::Full) => "C3D8",
        }
    }
}
