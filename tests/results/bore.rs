use std::f64::consts::{PI, TAU};

use crate::block::{STEEL, add_block, close};
use brinell::answer::results::bore::{Bore, bore_stress};
use brinell::answer::results::recovery::recover;
use brinell::model::mesh::Mesh;
use brinell::model::scene::Scene;
use brinell::model::state::State;

const INNER: f64 = 0.75;
const OUTER: f64 = 1.5;

fn lines(from: f64, to: f64, cells: usize) -> Vec<f64> {
    (0..=cells)
        .map(|i| from + (to - from) * i as f64 / cells as f64)
        .collect()
}

/// A hollow roller along y about (1, *, 2), or about (0, *, 2) as a quarter.
fn roller(around: usize, quarter: bool) -> Scene {
    let mut mesh = Mesh::default();
    let half = if quarter { PI } else { TAU };
    let (angles, radii) = (lines(0.0, half, around), lines(INNER, OUTER, 2));
    let length = lines(if quarter { 0.0 } else { -4.0 }, 4.0, 5);
    let x = if quarter { 0.0 } else { 1.0 };
    add_block(
        &mut mesh,
        "roller",
        [&radii, &length, &angles],
        |[r, y, a]| {
            // From the bottom up on the side of positive x: right-handed in r, y, angle.
            [x + r * a.sin(), y, 2.0 - r * a.cos()]
        },
    );
    // The seam of the whole ring stays open, as two surfaces that coincide.
    Scene {
        mirrors: if quarter { vec![0, 1] } else { vec![] },
        steps: vec![],
        ..Scene::bare("roller", mesh, STEEL)
    }
}

fn bore() -> Bore {
    Bore {
        body: "roller".to_string(),
        surface: "roller_u-".to_string(),
        axis: 1,
        lean: 0.0,
    }
}

fn moved(scene: &Scene, displacement: impl Fn([f64; 3]) -> [f64; 3]) -> State {
    let elements = scene.mesh.hexes.len();
    State {
        displacement: scene.mesh.points.iter().map(|p| displacement(*p)).collect(),
        stress: vec![[[0.0, 0.0, -40.0, 0.0, 0.0, 0.0]; 8]; elements],
        peeq: vec![[0.0; 8]; elements],
        ..State::default()
    }
}

/// Mises of plane stress from tangential and axial strain.
fn plane_mises(t: f64, a: f64) -> f64 {
    let (e, nu) = (STEEL.youngs_modulus, STEEL.poissons_ratio);
    let (st, sa) = (
        e / (1.0 - nu * nu) * (t + nu * a),
        e / (1.0 - nu * nu) * (a + nu * t),
    );
    (st * st - st * sa + sa * sa).sqrt()
}

#[test]
fn even_strains_of_the_bore_are_exact_and_turns_are_none() {
    for quarter in [false, true] {
        let scene = roller(24, quarter);
        let x0 = if quarter { 0.0 } else { 1.0 };
        let turn = if quarter { 0.0 } else { 0.01 };
        let state = moved(&scene, |[x, y, z]| {
            let (dx, dz) = (x - x0, z - 2.0);
            [
                1e-3 * dx + turn * dz,
                -4e-4 * y,
                1e-3 * dz - turn * dx - 0.3,
            ]
        });
        let recovered = recover(&scene, &state);
        let stress = bore_stress(&scene, &state, &recovered, &bore()).unwrap();
        close(stress.mises.unwrap(), plane_mises(1e-3, -4e-4));
        close(stress.nodal.unwrap(), 40.0);
    }
}

#[test]
fn shear_of_the_bore_counts_once_and_vanishes_on_mirror_planes() {
    let scene = roller(24, false);
    let twist = |[x, y, z]: [f64; 3]| [1e-3 * y * (z - 2.0), 0.0, -1e-3 * y * (x - 1.0)];
    let state = moved(&scene, twist);
    let recovered = recover(&scene, &state);
    let stress = bore_stress(&scene, &state, &recovered, &bore()).unwrap();
    let shear_modulus = STEEL.youngs_modulus / (2.0 * (1.0 + STEEL.poissons_ratio));
    // The facets' middle lies a little inside the circle that the nodes lie on.
    let expected = 3f64.sqrt() * shear_modulus * 1e-3 * INNER;
    assert!((stress.mises.unwrap() / expected - 1.0).abs() < 0.02);
    // Not a symmetric motion, but the answer on the mirror planes must not take one side's shear.
    let scene = roller(24, true);
    let state = moved(&scene, |[x, y, z]| {
        [1e-3 * y * (z - 2.0), 0.0, -1e-3 * y * x]
    });
    let recovered = recover(&scene, &state);
    let stress = bore_stress(&scene, &state, &recovered, &bore()).unwrap();
    assert!(stress.mises.unwrap() < 0.1 * expected);
}

/// The bending of a ring: nodes on the true circle, inextensible but for the strain that bending
/// leaves at the inner wall.
#[test]
fn the_strain_of_a_bent_ring_converges_to_second_order() {
    let error = |around: usize| {
        let scene = roller(around, true);
        let state = moved(&scene, |[x, _, z]| {
            let angle = x.atan2(2.0 - z);
            let (radial, along) = (1e-3 * (2.0 * angle).cos(), -4e-4 * (2.0 * angle).sin());
            let outward = [angle.sin(), -angle.cos()];
            let forward = [angle.cos(), angle.sin()];
            let u = |i: usize| radial * outward[i] + along * forward[i];
            [u(0), 0.0, u(1)]
        });
        let recovered = recover(&scene, &state);
        let stress = bore_stress(&scene, &state, &recovered, &bore()).unwrap();
        let exact = plane_mises((1e-3 - 8e-4) / INNER, 0.0);
        (stress.mises.unwrap() / exact - 1.0).abs()
    };
    let (coarse, fine) = (error(48), error(96));
    assert!(fine < 0.01, "{fine}");
    assert!((coarse / fine).log2() > 1.9, "{coarse} {fine}");
}

#[test]
fn a_bore_that_yields_has_no_elastic_stress() {
    let scene = roller(24, true);
    let mut state = moved(&scene, |p| p.map(|x| 1e-3 * x));
    let face = scene.mesh.surface("roller_u-").unwrap().faces[0];
    state.peeq[face.element as usize][0] = 1e-6;
    let recovered = recover(&scene, &state);
    let stress = bore_stress(&scene, &state, &recovered, &bore()).unwrap();
    assert_eq!((stress.mises, stress.mises_at), (None, None));
    close(stress.nodal.unwrap(), 40.0);
}

#[test]
fn a_bore_that_the_mesh_lacks_is_not_read() {
    let scene = roller(24, true);
    let state = moved(&scene, |_| [0.0; 3]);
    let recovered = recover(&scene, &state);
    let missing = Bore {
        surface: "nowhere".to_string(),
        ..bore()
    };
    assert_eq!(bore_stress(&scene, &state, &recovered, &missing), None);
}
