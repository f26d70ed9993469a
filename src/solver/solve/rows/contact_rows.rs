//! Contact rows of a scene: the mortar operator of each pair with its law.

use crate::model::scene::{ContactPair, Partner, Scene};
use crate::solver::contact::facing::Sight;
use crate::solver::contact::mortar::{Opposite, Row};
use crate::solver::contact::{facing, mortar};
use crate::solver::fem::tied::Tied;
use crate::solver::solve::rows::contact_row::{ContactRow, law};
use crate::solver::solve::rows::held_planes::held_on_both;

/// Contact rows of all pairs up to an initial gap of `reach`, by pair and node. Nodes that are `tied` to others have none.
pub fn contact_rows(scene: &Scene, tied: &Tied, reach: f64) -> Vec<ContactRow> {
    let moduli: Vec<f64> = scene
        .materials
        .iter()
        .map(|m| m.youngs_modulus / (1.0 - m.poissons_ratio * m.poissons_ratio))
        .collect();
    let mut all = Vec::new();
    for (index, pair) in scene.contacts.iter().enumerate() {
        let follow = following(scene, tied, pair);
        let rows = pair_rows(scene, pair, (reach, &follow), &moduli);
        all.extend(rows.into_iter().map(|row| ContactRow {
            law: law(pair, row.stiffness, false),
            pair: index,
            row,
        }));
    }
    all
}

/// Nodes of the carrier that a tie moves. Were they to press by themselves, they would ask of the nodes that they follow
/// what these ask of themselves.
fn following(scene: &Scene, tied: &Tied, pair: &ContactPair) -> Vec<u32> {
    if tied.is_empty() {
        return Vec::new();
    }
    let [carrier, _] = pair.carrier_first();
    let nodes = carrier.surface(&scene.mesh).map(|s| s.nodes());
    let mut nodes = nodes.unwrap_or_default();
    nodes.retain(|node| tied.has(*node));
    nodes
}

/// Rows of one pair up to an initial gap of `reach`; the nodes `follow` of its carrier have none.
pub fn pair_rows(
    scene: &Scene,
    pair: &ContactPair,
    (reach, follow): (f64, &[u32]),
    moduli: &[f64],
) -> Vec<Row> {
    let held = held_on_both(scene, pair);
    let prepared = prepared(scene, pair, (reach, moduli, &held), follow);
    prepared.map_or_else(Vec::new, |pair| mortar::rows(&pair))
}

/// Where the sides of each pair face each other, as far apart as `distance`.
pub fn sights(scene: &Scene, distance: f64) -> Vec<Vec<Sight>> {
    let of_pair = |pair| sights_of(scene, pair, distance);
    scene.contacts.iter().map(of_pair).collect()
}

/// Where the sides of one pair face each other, as far apart as `distance`.
pub fn sights_of(scene: &Scene, pair: &ContactPair, distance: f64) -> Vec<Sight> {
    let moduli = vec![1.0; scene.materials.len()];
    let pair = prepared(scene, pair, (0.0, &moduli, &[]), &[]);
    pair.map_or_else(Vec::new, |pair| facing::sights(&pair, distance))
}

/// A pair as the integration wants it; `None` where a side is not in the mesh.
fn prepared<'a>(
    scene: &'a Scene,
    pair: &ContactPair,
    (reach, moduli, held): (f64, &'a [f64], &'a [(usize, f64)]),
    follow: &'a [u32],
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
        closely: false,
        follow,
        reach,
        moduli,
        mirrors: &scene.mirrors,
        held,
    })
}
