//! Displacement components whose values are given.

use crate::model::scene::Scene;

/// A displacement component whose value is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prescribed {
    /// The node,
    pub node: u32,
    /// the axis (0, 1, 2),
    pub axis: usize,
    /// the displacement at factor one, a length,
    pub value: f64,
    /// and what prescribes it.
    pub source: Source,
}

/// The entry of the scene that prescribes a component.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// A support, by its index in the scene.
    Support(usize),
    /// A rigid plane, by its index in the scene.
    Plane(usize),
}

impl Source {
    /// The name by which steps call it.
    pub fn load(self, scene: &Scene) -> &str {
        match self {
            Self::Support(index) => &scene.supports[index].name,
            Self::Plane(index) => &scene.rigid_planes[index].name,
        }
    }
}
