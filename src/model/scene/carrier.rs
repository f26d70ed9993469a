//! Which side of a contact pair carries the pressure (the slave, or non-mortar side).
//!
//! Pressures live on the nodes of the carrier, and the condition that nothing overlaps is weighted with
//! their shape functions. Were they set closer than the other side can follow, or on bodies that do not
//! give way one node at a time, pressures would alternate from node to node and read too high between.
//! A layer one facet deep has the stiffness k = E / (1 − ν²) / h per area, h being the shortest side
//! of a facet. The side with the smaller k carries: the softer one, and of equal steels the one with the
//! coarser facets. Where both are equal within a tenth, it is the side that the template prefers, else
//! the upper one. Roundness does not count: the gap is that of the true shapes either way.
//!
//! Measured on problem H with four facets across the half-width on the coarser side (largest error of
//! p_max for eight loads that shift the edge of the strip): facets 1:4, 0.6 % with the coarser side as
//! carrier and 6.0 % with the finer one; 1:2, 0.6 and 3.6 %; 1:1.1, 0.5 and 0.5 %. A block that is finer by 4
//! and softer by 2, 4, 10: 2.5, 0.7, 0.1 % with the block as carrier, 0.6, 0.6, 0.7 % with the cylinder.

use super::{Partner, Side};
use crate::model::material::Steel;
use crate::model::mesh::{Mesh, Surface};

/// Ratio of stiffnesses up to which they count as equal: of facets 1:1.1 either side serves as carrier.
const EQUAL_STIFFNESS_RATIO: f64 = 1.1;

/// The carrier of a pair `[upper, lower]` on `mesh`, whose bodies are of `steels`, one a body in the order
/// of the mesh; `preferred` where both serve alike.
pub fn choose(
    mesh: &Mesh,
    steels: &[Steel],
    [upper, lower]: [&Partner; 2],
    preferred: Side,
) -> Side {
    match (
        stiffness(mesh, steels, upper),
        stiffness(mesh, steels, lower),
    ) {
        (Some(above), Some(below)) if above > EQUAL_STIFFNESS_RATIO * below => Side::Lower,
        (Some(above), Some(below)) if below > EQUAL_STIFFNESS_RATIO * above => Side::Upper,
        (Some(_), Some(_)) => preferred,
        // A plane has no nodes.
        (None, Some(_)) => Side::Lower,
        _ => Side::Upper,
    }
}

/// k of a side; `None` for a plane.
fn stiffness(mesh: &Mesh, steels: &[Steel], side: &Partner) -> Option<f64> {
    let steel = steels.get(side.body(mesh)?)?;
    let modulus = steel.youngs_modulus / (1.0 - steel.poissons_ratio.powi(2));
    Some(modulus / shortest_side(mesh, side.surface(mesh)?))
}

/// Meshes are finest where contact is expected.
fn shortest_side(mesh: &Mesh, surface: &Surface) -> f64 {
    let sides = surface.faces.iter().flat_map(|face| face.sides(mesh));
    sides.fold(f64::INFINITY, f64::min)
}
