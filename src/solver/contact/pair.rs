//! A contact pair, as its integration needs it.

use crate::ground::geometry::{Vec3, norm, sub};
use crate::model::mesh::{Mesh, Surface};

/// The other side of a pair.
pub enum Opposite<'a> {
    /// The surface of a body.
    Surface(&'a Surface),
    /// A rigid half space: a point of its plane and the outward unit normal.
    Plane { point: Vec3, normal: Vec3 },
}

/// What the integration needs to know of a pair.
pub struct Pair<'a> {
    /// The mesh of all bodies, undeformed.
    pub mesh: &'a Mesh,
    /// The surface whose nodes get the multipliers: the non-mortar or slave side.
    pub carrier: &'a Surface,
    /// The mortar or master side.
    pub opposite: Opposite<'a>,
    /// Measure gaps and normals on the plane, cylinder or sphere that the facets stand for?
    pub true_geometry: bool,
    /// Is there friction?
    pub friction: bool,
    /// Integrate facets that are no parallelograms to the last digit, too?
    pub closely: bool,
    /// Nodes of the carrier that have no multiplier of their own, ascending: what they do is decided elsewhere.
    pub follow: &'a [u32],
    /// Rows with a larger initial gap (a length) are left out.
    pub reach: f64,
    /// E / (1 − ν²) of each body.
    pub moduli: &'a [f64],
    /// Axes whose coordinate planes mirror the model.
    pub mirrors: &'a [usize],
    /// Planes, by axis and coordinate, across which neither side moves.
    pub held: &'a [(usize, f64)],
}

impl Pair<'_> {
    /// The largest gap at a point of a facet that counts: all of the facet does where a row on it
    /// is within reach, however coarse the mesh.
    pub fn farthest(&self, facet: &[Vec3; 4]) -> f64 {
        let diagonals = [sub(facet[2], facet[0]), sub(facet[3], facet[1])];
        4.0 * self.reach + diagonals.map(norm).into_iter().fold(0.0, f64::max)
    }
}
