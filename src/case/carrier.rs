//! Which side of a contact pair carries the pressure (the slave, or non-mortar side).
//!
//! Pressures live on the nodes of the carrier, and the condition that nothing overlaps is weighed with
//! their hat functions. Were the carrier much the stiffer side, its nodes could not give way one by
//! one: pressures alternate from node to node, and only their sum is right. So, in this order:
//!
//! 1. the *softer* side, where the moduli E / (1 − ν²) differ by more than [`SOFTER`];
//! 2. else the side with the *finer* facets, where those differ by more than [`FINER`]: it resolves the
//!    strip best;
//! 3. else the upper side.
//!
//! Roundness does not count: the gap is that of the true shapes either way.

use crate::geometry::{norm, sub};
use crate::material::Steel;
use crate::mesh::{Mesh, Surface};
use crate::scene::{Partner, Side};

/// Ratio of moduli above which softness decides.
const SOFTER: f64 = 2.0;
/// Ratio of sizes above which fineness decides: not by rounding.
const FINER: f64 = 1.001;

/// The carrier of a pair `[upper, lower]` on `mesh`, whose bodies are of `steels`.
pub(super) fn choose(mesh: &Mesh, steels: &[Steel], [upper, lower]: [&Partner; 2]) -> Side {
    let (Some(above), Some(below)) = (upper.surface(mesh), lower.surface(mesh)) else {
        // A plane has no nodes.
        return match upper.surface(mesh) {
            Some(_) => Side::Upper,
            None => Side::Lower,
        };
    };
    let modulus = |side: &Partner| {
        let steel = steels.get(side.body(mesh)?)?;
        Some(steel.youngs_modulus / (1.0 - steel.poissons_ratio.powi(2)))
    };
    if let (Some(above), Some(below)) = (modulus(upper), modulus(lower)) {
        if above > SOFTER * below {
            return Side::Lower;
        }
        if below > SOFTER * above {
            return Side::Upper;
        }
    }
    match fineness(mesh, above) > FINER * fineness(mesh, below) {
        true => Side::Lower,
        false => Side::Upper,
    }
}

/// The shortest side of a facet of a surface: meshes are finest where contact is expected.
fn fineness(mesh: &Mesh, surface: &Surface) -> f64 {
    let sides = surface.faces.iter().flat_map(|face| {
        let corners = face.corners(mesh);
        [0, 1, 2, 3].map(|k| norm(sub(corners[k], corners[(k + 1) % 4])))
    });
    sides.fold(f64::INFINITY, f64::min)
}
