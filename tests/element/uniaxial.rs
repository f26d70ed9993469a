//! A cube of the reference study's steel in uniaxial tension: the bilinear curve, and back.
//!
//! Stresses computed from σ = Y + E_t (ε − Y/E) by a separate program.

use crate::kit::{self, KINDS, close, held, report_steel, step};
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::{ElementKind, PlaneMotion, RigidPlane, Scene};

/// Total strain and stress in ksi.
const CURVE: [(f64, f64); 7] = [
    (0.001, 29.5),
    (0.005, 100.39832),
    (0.01, 101.63522),
    (0.02, 104.10901),
    (0.05, 111.53040),
    (0.1, 123.89937),
    (0.157, 138.0),
];

fn curve(strain: f64) -> f64 {
    let steel = report_steel();
    let (e, y, h) = (
        steel.youngs_modulus,
        steel.yield_stress,
        steel.hardening_modulus,
    );
    if strain <= y / e {
        e * strain
    } else {
        y + e * h / (e + h) * (strain - y / e)
    }
}

/// Eight hexahedra around a middle node that lies off the middle.
fn cube(kind: ElementKind, motion: PlaneMotion) -> Scene {
    let list = || uniform(0.0, 1.0, 2);
    let off = |x: [f64; 3]| {
        if x == [0.5; 3] { [0.58, 0.45, 0.56] } else { x }
    };
    let mesh = Block::new("cube", list(), list(), list())
        .mapped(off)
        .build()
        .unwrap();
    let mut scene = kit::scene(mesh, report_steel(), kind);
    scene.supports = vec![held("x_min", 0), held("y_min", 1), held("z_min", 2)];
    scene.rigid_planes = vec![RigidPlane {
        name: "pull".into(),
        surface: "z_max".into(),
        motion: [PlaneMotion::Free, PlaneMotion::Free, motion],
        ..RigidPlane::default()
    }];
    scene
}

#[test]
fn the_table_is_the_closed_form() {
    for (strain, stress) in CURVE {
        assert!((curve(strain) - stress).abs() < 6e-6);
    }
}

#[test]
fn a_cube_follows_the_curve() {
    for kind in KINDS {
        let mut scene = cube(kind, PlaneMotion::Held(1.0));
        scene.steps = CURVE.map(|(strain, _)| step(strain)).to_vec();
        let states = kit::states(&mut scene);
        assert_eq!(states.len(), CURVE.len());
        for (state, (strain, _)) in states.iter().zip(CURVE) {
            for stress in state.stress.iter().flatten() {
                close("axial stress", stress[2], curve(strain), 1e-8);
                for i in [0, 1, 3, 4, 5] {
                    assert!(stress[i].abs() < 1e-6, "component {i}: {}", stress[i]);
                }
            }
        }
    }
}

/// Loaded to a strain of 0.05 by force and unloaded: 0.04621931 stays.
#[test]
fn unloading_is_elastic() {
    for kind in KINDS {
        let mut scene = cube(kind, PlaneMotion::Driven(1.0));
        let stress = curve(0.05);
        scene.steps = vec![step(stress), step(0.0)];
        let states = kit::states(&mut scene);
        close("strain", states[0].planes[0].travel[2], 0.05, 1e-8);
        let residual = states[1].planes[0].travel[2];
        close("residual strain", residual, 0.05 - stress / 29500.0, 1e-8);
        assert!((residual - 0.04621931).abs() < 1e-8);
        for s in states[1].stress.iter().flatten().flatten() {
            assert!(s.abs() < 1e-6, "{s} remains");
        }
    }
}
