//! Ties: two surfaces that are joined.

use crate::model::mesh::{Mesh, Surface};
use serde::Serialize;

/// Two surfaces of bodies that are joined for good, whether their nodes meet or not.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Tie {
    /// What messages and results call it.
    pub name: String,
    /// The surfaces of the mesh. The force of the tie is told as it acts on the second one.
    pub surfaces: [String; 2],
    /// The largest distance between the two that is bridged, a length; `None` for
    /// [`TOLERANCE_SHARE`] of the side of a facet.
    pub tolerance: Option<f64>,
}

/// The largest distance that is bridged where nothing else is said, over the side of a facet: the root of the mean
/// area on the side with the larger facets. Flat facets around a circle, an eighth of a turn each, miss it by as much.
pub const TOLERANCE_SHARE: f64 = 0.05;

impl Tie {
    /// Joins the surfaces `first` and `second`; its name is `<first>-<second>`.
    pub fn between(first: &str, second: &str) -> Self {
        Self {
            name: format!("{first}-{second}"),
            surfaces: [first.into(), second.into()],
            tolerance: None,
        }
    }

    /// Calls it `name`.
    pub fn named(mut self, name: &str) -> Self {
        self.name = name.into();
        self
    }

    /// Bridges a distance of up to `tolerance`, a positive length.
    pub fn within(mut self, tolerance: f64) -> Self {
        self.tolerance = Some(tolerance);
        self
    }

    /// Both surfaces in `mesh`; `None` where one is missing.
    pub fn of<'m>(&self, mesh: &'m Mesh) -> Option<[&'m Surface; 2]> {
        let [first, second] = &self.surfaces;
        Some([mesh.surface(first)?, mesh.surface(second)?])
    }
}
