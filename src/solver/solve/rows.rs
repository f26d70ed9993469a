//! Contact rows of a scene: the operator of each pair with its law.

use crate::model::mesh::{Face, Mesh};
use crate::model::scene::{ContactPair, Partner, Scene};
use crate::solver::contact::facing::{self, Sight};
use crate::solver::contact::law::Law;
use crate::solver::contact::mortar::{self, Opposite, Row};
use crate::solver::solve::params::{
    CONTACT_PENALTY, DIVIDED_CONTACT_PENALTY, SOFTEST_PENALTY, STIFFEST_PENALTY,
};

/// A contact row with its pair's law.
pub struct ContactRow {
    pub row: Row,
    pub pair: usize,
    pub law: Law,
}

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

/// The law of a row beside which the bodies have the given stiffness; `soft` where corrections are not exact.
pub fn law(pair: &ContactPair, stiffness: f64, soft: bool) -> Law {
    let soft = soft && pair.friction > 0.0;
    let automatic = if soft {
        DIVIDED_CONTACT_PENALTY
    } else {
        CONTACT_PENALTY
    };
    let wanted = (automatic * pair.penalty_factor).clamp(SOFTEST_PENALTY, STIFFEST_PENALTY);
    Law {
        friction: pair.friction,
        penalty: wanted * stiffness,
        firmest: wanted.max(automatic) * stiffness,
        stiffness,
    }
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

/// Planes, by axis and coordinate, that supports hold both sides of a pair on.
fn held_planes(scene: &Scene, pair: &ContactPair) -> Vec<(usize, f64)> {
    let mesh = &scene.mesh;
    let body = |partner: &Partner| match partner {
        Partner::Surface(name) => {
            let face = mesh.surface(name)?.faces.first()?;
            Some(mesh.body_of(face.element as usize))
        }
        Partner::Plane { .. } => None,
    };
    let of = |body: usize| -> Vec<(usize, f64)> {
        let held = scene.supports.iter().flat_map(|s| {
            let axes =
                (0..3).filter(|a| s.components[*a] == Some(0.0) && s.gradient[*a] == [0.0; 3]);
            axes.filter_map(|axis| Some((axis, plane_of(mesh, &s.surface, body, axis)?)))
        });
        held.collect()
    };
    match (body(&pair.upper), body(&pair.lower)) {
        (Some(upper), Some(lower)) => {
            let lower = of(lower);
            let both = of(upper).into_iter();
            both.filter(|plane| lower.contains(plane)).collect()
        }
        (Some(body), None) | (None, Some(body)) => of(body),
        (None, None) => Vec::new(),
    }
}

/// The coordinate along `axis` that all nodes of a surface of `body` have.
fn plane_of(mesh: &Mesh, surface: &str, body: usize, axis: usize) -> Option<f64> {
    let faces = &mesh.surface(surface)?.faces;
    let own = |face: &&Face| mesh.body_of(face.element as usize) == body;
    let mut nodes = faces.iter().filter(own).flat_map(|face| face.nodes);
    let at = mesh.points[nodes.next()? as usize][axis];
    let flat = nodes.all(|node| mesh.points[node as usize][axis] == at);
    flat.then_some(at)
}
