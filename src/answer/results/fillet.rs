//! Where surfaces begin to curve, and the peaks of pressure that a mesh may not show there.
//!
//! Where a straight part passes into a fillet of the radius r, the curvature jumps. If contact goes on beyond, the
//! pressure has a finite peak there, as narrow as contact spills onto the fillet (Ciavarella, Hills and Monno, The
//! influence of rounded edges on indentation by a flat punch, Proc. IMechE C 212, 1998): about r p/E*. A mesh shows
//! it whose facets are no longer than that. The first facet on the fillet, of the length h, is turned by θ = h/2r, so
//! that this is 2 θ ≤ p/E*: lengths need not be known.

use std::collections::BTreeMap;

use super::seams::Seams;
use crate::model::mesh::shape::{Shape, fit};
use crate::model::mesh::{Mesh, Surface};

/// Curvature on one side of an edge, over that at the edge, up to which it jumps there. Along a fillet that
/// facets follow it is one, next to its beginning a half.
const JUMP: f64 = 0.25;

/// Angle that rounded coordinates may turn a facet by.
const ROUNDING: f64 = 1e-6;

/// Sides of faces, their ends ascending, at which a surface begins, or ends, to curve outwards, and the angles
/// between the two facets there; none on planes, cylinders and spheres.
pub fn beginnings(mesh: &Mesh, surface: &Surface) -> BTreeMap<[u32; 2], f64> {
    if fit(mesh, surface) != Shape::Facets {
        return BTreeMap::new();
    }
    let seams = Seams::of(&surface.faces);
    let beginning = |(nodes, shared): ([u32; 2], &[(usize, usize)])| {
        let (bend, apart) = seams.turn(mesh, nodes)?;
        if bend < ROUNDING {
            return None;
        }
        let curvature = bend / apart;
        let beyond = shared.iter().filter_map(|side| {
            let (bend, apart) = seams.turn_opposite(mesh, *side)?;
            Some(bend / apart)
        });
        let least = beyond.fold(curvature, f64::min);
        (least < JUMP * curvature).then_some((nodes, bend))
    };
    seams.all().filter_map(beginning).collect()
}

/// The largest pressure that may be where a surface bends by `bend` and the mesh reads `pressure`; `None` where it is
/// resolved.
///
/// A pressure read over a facet grows towards the fillet as beside an edge, with a small power of the distance,
/// up to where the fillet bounds it. Measured on flat punches with fillets of 0.03 and 0.1 of their half-width
/// under 0.002 and 0.006 of E*, with facets of 0.7 to 100 times r p/E*.
pub fn unseen(bend: f64, pressure: f64, compliance: f64) -> Option<f64> {
    const POWER: f64 = 0.25;
    /// What was measured is up to that much more.
    const MORE: f64 = 1.15;
    let coarse = 2.0 * bend / (pressure * compliance);
    (pressure > 0.0 && coarse > 1.0).then(|| MORE * pressure * coarse.powf(POWER))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, uniform};

    /// Beginnings on the lower face of a block whose nodes are raised there.
    fn on(raised: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        let x = uniform(0.0, 2.0, 40);
        let block = Block::new("block", x, uniform(0.0, 1.0, 2), uniform(0.0, 1.0, 4));
        let block = block.mapped(|[x, y, z]| [x, y + raised(x) * (1.0 - y), z]);
        let mesh = block.build().unwrap();
        let found = beginnings(&mesh, mesh.surface("y_min").unwrap());
        let place = |nodes: &[u32; 2]| mesh.points[nodes[0] as usize][0];
        found
            .iter()
            .map(|(nodes, bend)| (place(nodes), *bend))
            .collect()
    }

    #[test]
    fn a_fillet_begins_where_the_curvature_jumps() {
        let radius = 1.0;
        let fillet = on(|x| radius - (radius * radius - (x - 1.2).max(0.0).powi(2)).sqrt());
        assert_eq!(fillet.len(), 4);
        for (x, bend) in fillet {
            assert!(
                (x - 1.2).abs() < 1e-9 && (bend / 0.025 - 1.0).abs() < 0.01,
                "{x} {bend}"
            );
        }
        // Rising towards the end as a crown does, or inwards.
        assert_eq!(on(|x| 0.01 * (x + 0.5).powi(4)), []);
        assert_eq!(on(|x| -0.3 * (x - 1.2).max(0.0)), []);
        assert_eq!(on(|_| 0.0), []);
    }

    #[test]
    fn a_facet_as_long_as_the_contact_on_the_fillet_shows_the_peak() {
        assert_eq!(unseen(0.005, 100.0, 1e-4), None);
        let hidden = unseen(0.08, 100.0, 1e-4).unwrap();
        assert!((hidden / 230.0 - 1.0).abs() < 1e-9, "{hidden}");
        assert_eq!(unseen(0.08, 0.0, 1e-4), None);
    }
}
