//! Which facets of two surfaces may overlap: an R-tree of facet boxes.

use crate::ground::geometry::{Vec3, add, bounds, sub};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// Facet boxes of one surface.
pub struct FacetTree {
    tree: RTree<GeomWithData<Rectangle<Vec3>, usize>>,
}

impl FacetTree {
    /// From the corner coordinates of each facet.
    pub fn new(facets: &[[Vec3; 4]]) -> Self {
        let boxes = facets.iter().enumerate().map(|(index, corners)| {
            let [low, high] = bounds(*corners);
            GeomWithData::new(Rectangle::from_corners(low, high), index)
        });
        Self {
            tree: RTree::bulk_load(boxes.collect()),
        }
    }

    /// Indices of the facets whose boxes come within `distance`, axis by axis, of the box of
    /// `corners`, ascending.
    pub fn near(&self, corners: &[Vec3; 4], distance: Vec3) -> Vec<usize> {
        let [low, high] = bounds(*corners);
        let envelope = AABB::from_corners(sub(low, distance), add(high, distance));
        let mut found: Vec<usize> = self
            .tree
            .locate_in_envelope_intersecting(envelope)
            .map(|facet| facet.data)
            .collect();
        found.sort_unstable();
        found
    }
}
