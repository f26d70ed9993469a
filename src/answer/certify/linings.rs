//! The shear within linings that are one element thick.
//!
//! A lining that is pressed between two bodies wants to flow out from where it is pressed most. What it adheres to holds it back, by shears
//! that grow from one face to the other as the stress along it changes. One element between both faces has the same shear
//! all through, so that averages at nodes know nothing of it: balance does.

use super::strain_energy::density;
use crate::answer::results::hex::GaussRule;
use crate::answer::results::outer_faces::{Bound, OuterFaces};
use crate::answer::results::recovery::Recovered;
use crate::answer::results::tensor::{mean, tensor_of, traction};
use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub, unit};
use crate::model::material::{Steel, matrix};
use crate::model::mesh::hexahedron::{faces_of, jacobian_matrix, shape_derivatives};
use crate::model::mesh::surface::sorted;
use crate::model::mesh::{Body, Face};
use crate::model::scene::Scene;
use crate::model::state::State;
use nalgebra::Matrix3;
use std::array::from_fn;
use std::collections::{BTreeMap, BTreeSet};

/// Of the share by which a lining is too stiff, that by which it is pressed too much.
const PRESSURE: f64 = 0.5;

/// An element of a lining.
struct Lining<'f> {
    body: usize,
    /// A face that is held or joined, and the one behind it.
    faces: [&'f Face; 2],
    /// From the middle of the first to that of the other.
    across: Vec3,
}

/// The elements between two outer faces one of which is held or joined.
fn linings<'f>(scene: &Scene, outer: &'f OuterFaces) -> Vec<Lining<'f>> {
    let mesh = &scene.mesh;
    let mut found = Vec::new();
    for (body, faces) in outer.by_body.iter().enumerate() {
        let all: BTreeMap<[u32; 4], &Face> = faces.iter().map(|f| (sorted(f.nodes), f)).collect();
        let adheres = |face: &Face| matches!(outer.bound(face), Bound::Held | Bound::Joined);
        for face in faces.iter().filter(|face| adheres(face)) {
            let apart = |other: &[u32; 4]| other.iter().all(|node| !face.nodes.contains(node));
            let mut sides = faces_of(&mesh.hexes[face.element as usize]).into_iter();
            let behind = sides.find(apart).and_then(|nodes| all.get(&sorted(nodes)));
            // Held on both sides it is found twice.
            let twice =
                |behind: &Face| adheres(behind) && sorted(behind.nodes) < sorted(face.nodes);
            if let Some(behind) = behind.filter(|behind| !twice(behind)) {
                found.push(Lining {
                    body,
                    faces: [face, behind],
                    across: sub(behind.centre(mesh), face.centre(mesh)),
                });
            }
        }
    }
    found
}

/// At the [`points`](Recovered::points) on the faces of linings, the shear that the mean stress of their elements lacks.
pub(super) fn missing_shear(
    scene: &Scene,
    recovered: &Recovered,
    outer: &OuterFaces,
) -> BTreeMap<usize, [f64; 6]> {
    let mut found: BTreeMap<usize, ([f64; 6], u32)> = BTreeMap::new();
    for lining in linings(scene, outer) {
        let Some(normal) = unit(lining.across) else {
            continue;
        };
        let element = lining.faces[0].element as usize;
        let out = out_of_balance(scene, recovered, element);
        let pull = sub(out, scale(normal, dot(out, normal)));
        for (side, face) in [-0.5, 0.5].into_iter().zip(lining.faces) {
            // Balance: the shear across the lining falls by what the stress along it grows.
            let shear = shear(scale(pull, -side * norm(lining.across)), normal);
            let cells = &recovered.points.cells[element];
            let nodes = scene.mesh.hexes[element].iter().zip(cells);
            for (_, point) in nodes.filter(|(node, _)| face.nodes.contains(node)) {
                let (sum, count) = found.entry(*point as usize).or_default();
                sum.iter_mut().zip(shear).for_each(|(sum, s)| *sum += s);
                *count += 1;
            }
        }
    }
    let mean = |(sum, count): ([f64; 6], u32)| sum.map(|s| s / f64::from(count));
    let found = found.into_iter();
    found.map(|(point, all)| (point, mean(all))).collect()
}

/// Work that a load does not do as linings do not flow out at their free sides, which their elements press from within.
///
/// With the mean motion u along a lining of the thickness t, held at both faces, its energy is ½ ∫ (M u'² + 12 G u²/t²) dx for each area of its section, and
/// the pressure p at a side does the work p u there: u falls off from the side within t √(M / 12 G), and twice the energy that this sets
/// free is p² t / √(12 G M) for each area of the side. M is the modulus of what cannot widen.
pub(super) fn work_at_sides(scene: &Scene, state: &State, outer: &OuterFaces) -> f64 {
    let mesh = &scene.mesh;
    let linings = linings(scene, outer);
    if linings.is_empty() {
        return 0.0;
    }
    let pairs = scene
        .contacts
        .iter()
        .flat_map(|pair| [&pair.upper, &pair.lower]);
    let touching = pairs.filter_map(|side| side.surface(mesh));
    let loaded = scene.tractions.iter();
    let loaded = loaded.filter_map(|traction| mesh.surface(&traction.surface));
    let pressed: BTreeSet<[u32; 4]> = (touching.chain(loaded))
        .flat_map(|surface| &surface.faces)
        .map(|face| sorted(face.nodes))
        .collect();
    let of_lining = |lining: &Lining| {
        let moduli = scene.materials[lining.body].moduli();
        let stiff = moduli.bulk + 4.0 / 3.0 * moduli.shear;
        let within = norm(lining.across) / (12.0 * moduli.shear * stiff).sqrt();
        let faces = &outer.by_body[lining.body];
        let element = lining.faces[0].element;
        let first = faces.partition_point(|face| face.element < element);
        let own = faces[first..]
            .iter()
            .take_while(|face| face.element == element);
        let is_side = |face: &&Face| {
            let nodes = sorted(face.nodes);
            lining
                .faces
                .iter()
                .all(|other| sorted(other.nodes) != nodes)
                && outer.bound(face) == Bound::Free
                && !pressed.contains(&nodes)
        };
        let stress = mean(&state.stress[element as usize]);
        let of_side = |face: &Face| {
            let area = face.area_vector(mesh);
            let pressure = dot(traction(&stress, area), area) / dot(area, area);
            pressure.powi(2) * within * norm(area)
        };
        own.filter(is_side).map(of_side).sum::<f64>()
    };
    linings.iter().map(of_lining).sum()
}

/// The energy of the shear that linings lack, of that of their stress, by body: by so much are they too stiff, at least.
pub(super) fn too_stiff(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    outer: &OuterFaces,
) -> Vec<f64> {
    let lacking = missing_shear(scene, recovered, outer);
    let rule = GaussRule::new();
    let of_body = |(body, steel): (&Body, &Steel)| {
        let shears =
            |element: usize| recovered.points.cells[element].map(|p| lacking.get(&(p as usize)));
        let lacks = |element: &usize| shears(*element).iter().any(Option::is_some);
        let [mut whole, mut missing] = [0.0; 2];
        for element in body.elements.clone().filter(lacks) {
            let shears = shears(element);
            let at_points = state.stress[element].iter().zip(&rule.shape);
            for ((stress, shape), volume) in at_points.zip(&recovered.volumes[element]) {
                let shear: [f64; 6] = from_fn(|k| {
                    let nodal = shape.iter().zip(&shears);
                    nodal.filter_map(|(w, s)| s.map(|s| w * s[k])).sum()
                });
                whole += volume * density(stress, steel);
                missing += volume * density(&shear, steel);
            }
        }
        if missing > 0.0 { missing / whole } else { 0.0 }
    };
    (scene.mesh.bodies.iter().zip(&scene.materials))
        .map(of_body)
        .collect()
}

/// By which share the largest pressure of a pair may be too large, as the linings of its bodies are `too_stiff`.
pub(super) fn off(scene: &Scene, pair: usize, too_stiff: &[f64]) -> f64 {
    let bodies = scene.contacts[pair].bodies(&scene.mesh).into_iter();
    let shares = bodies.flatten().map(|body| too_stiff[body]);
    PRESSURE * shares.fold(0.0, f64::max)
}

/// The divergence of the nodal averages in the middle of an element: what balance wants to vanish.
fn out_of_balance(scene: &Scene, recovered: &Recovered, element: usize) -> Vec3 {
    let gradients = shape_derivatives([0.0; 3]);
    let jacobian = jacobian_matrix(&scene.mesh.corners(element), &gradients);
    let Some(inverse) = Matrix3::from_fn(|i, j| jacobian[i][j]).try_inverse() else {
        return [0.0; 3];
    };
    let cells = recovered.points.cells[element];
    let mut sum = [0.0; 3];
    for (point, gradient) in cells.iter().zip(gradients) {
        let stress = matrix(recovered.nodal_stress[*point as usize]);
        let gradient: Vec3 = from_fn(|j| (0..3).map(|k| inverse[(k, j)] * gradient[k]).sum());
        sum = add(sum, stress.map(|row| dot(row, gradient)));
    }
    sum
}

/// A shear with this traction on the planes with this normal: xx yy zz xy yz zx.
fn shear(traction: Vec3, n: Vec3) -> [f64; 6] {
    tensor_of(|i, j| traction[i] * n[j] + n[i] * traction[j])
}
