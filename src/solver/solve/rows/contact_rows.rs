//! Contact rows of a scene: the mortar operator of each pair with its law.

use crate::model::scene::{ContactPair, Partner, Scene};
use crate::solver::contact::facing::Sight;
use crate::solver::contact::mortar::{Opposite, Row};
use crate::solver::contact::{facing, mortar};
use crate::solver::solve::rows::contact_row::{ContactRow, law};
use crate::solver::solve::rows::held_planes::held_planes;

/// Contact rows of all pairs up to an initial gap of `reach`, by pair and node.
pub fn contact_rows(scene: &Scene, reach: f64) -> Vec<ContactRow> {
    let moduli: Vec<f64> = scene
        .materials
        .iter()
        .map(|m| m.youngs_modulus / (1.0 - m.poissons_ratio * m.poissons_ratio))
        .collect();
    let mut all = Vec::new();
    for (index, pair) in scene.contacts.iter().enumerate() {
        let rows = pair_rows(scene, pair, reach, &moduli);
        all.extend(rows.into_iter().map(|row| ContactRow {
            law: law(pair, row.stiffness, false),
            pair: index,
            row,
        }));
    }
    all
}

/// Rows of one pair.
pub fn pair_rows(scene: &Scene, pair: &ContactPair, reach: f64, moduli: &[f64]) -> Vec<Row> {
    let held = held_planes(scene, pair);
    let prepared = prepared(scene, pair, (reach, moduli, &held));
    prepared.map_or_else(Vec::new, |pair| mortar::rows(&pair))
}

/// Where the sides of each pair face each other, as far apart as `distance`.
pub fn sights(scene: &Scene, distance: f64) -> Vec<Vec<Sight>> {
    let moduli = vec![1.0; scene.materials.len()];
    let of = |pair| prepared(scene, pair, (0.0, &moduli, &[]));
    let see = |pair| of(pair).map_or_else(Vec::new, |pair| facing::sights(&pair, distance));
    scene.contacts.iter().map(see).collect()
}

/// A pair as the integration wants it; `None` where a side is not in the mesh.
fn prepared<'a>(
    scene: &'a Scene,
    pair: &ContactPair,
    (reach, moduli, held): (f64, &'a [f64], &'a [(usize, f64)]),
) -> Option<mortar::Pair<'a>> {
    let mesh = &scene.mesh;
    let [carrier, other] = pair.carrier_first();
    let opposite = match other {
        Partner::Surface(name) => Opposite::Surface(mesh.surface(name)?),
        Partner::Plane { point, normal } => Opposite::Plane {
            point: *point,
            normal: *normal,
        },
    };
    Some(mortar::Pair {
        mesh,
        carrier: carrier.surface(mesh)?,
        opposite,
        true_geometry: pair.true_geometry,
        friction: pair.friction > 0.0,
        reach,
        moduli,
        mirrors: &scene.mirrors,
        held,
    })
}
