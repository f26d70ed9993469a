//! The way to an answer does not decide it.

use brinell::case::{self, Case};
use brinell::model::scene::{Scene, TractionValue};
use brinell::model::state::State;
use brinell::product::job::{self, Options};
use brinell::render::Summary;
use brinell::solver::solve::{Silent, solve};
use nalgebra::{Rotation3, Vector3};

/// Three blocks whose meshes do not match, pressed beyond yield at an angle.
const BLOCKS: &str = r#"
units = "mm-N-MPa"
mesh = { file = "FIXTURES/MESH.msh.gz" }
[steel]
youngs_modulus = 200000.0
poissons_ratio = 0.3
yield_stress = 150.0
hardening_modulus = 4000.0
[controls]
solver = "SOLVER"
[[support]]
surface = "low_z0"
fixed = "xyz"
[[body]]
name = "upp"
steel = { youngs_modulus = MODULUS }
[[body]]
name = "low"
[[body]]
name = "top"
[[contact]]
name = "c1"
upper = "upp_z0"
lower = "low_z1"
friction = FRICTION
carrier = "CARRIER"
penalty_factor = PENALTY
[[contact]]
name = "c2"
upper = "top_z0"
lower = "upp_z1"
friction = FRICTION
carrier = "CARRIER"
penalty_factor = PENALTY
[[traction]]
name = "T"
surface = "top_z1"
value = TRACTION
"#;

const FIRST: [(&str, &str); 5] = [
    ("MESH", "rough-blocks-1"),
    ("MODULUS", "70000.0"),
    ("FRICTION", "0.4013569078326473"),
    ("CARRIER", "lower"),
    ("TRACTION", "[-6.461016, -2.195155, -162.4806]"),
];
const SECOND: [(&str, &str); 5] = [
    ("MESH", "rough-blocks-2"),
    ("MODULUS", "200000.0"),
    ("FRICTION", "0.2"),
    ("CARRIER", "upper"),
    ("TRACTION", "[-0.6970296, 1.76229, -197.01324]"),
];

fn case_of(keys: &[(&str, &str)]) -> Case {
    let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures");
    let mut text = BLOCKS.replace("FIXTURES", fixtures);
    for (key, value) in keys {
        text = text.replace(key, value);
    }
    case::parse("scene.toml", &text).unwrap()
}

fn solved(keys: &[(&str, &str)]) -> Summary {
    let case = case_of(keys);
    let outcome = job::run(&case, &Options::default(), &mut Silent).unwrap();
    assert!(outcome.summary.answer.converged);
    outcome.summary
}

/// Source: the same with the automatic penalty and one factor.
#[test]
fn penalties_and_division_move_no_figure() {
    const SAME: f64 = 1e-5;
    for scene in [FIRST, SECOND] {
        let with = |penalty, solver| {
            let keys = [("PENALTY", penalty), ("SOLVER", solver)];
            solved(&[&scene[..], &keys].concat())
        };
        let own = with("1.0", "direct");
        for (penalty, solver) in [("0.01", "direct"), ("100.0", "direct"), ("1.0", "divided")] {
            let other = with(penalty, solver);
            for one in &own.answer.certificate {
                let same = other.answer.figure(one.what, &one.place).unwrap();
                let off = (one.value - same.value).abs();
                assert!(
                    off <= SAME * one.value.abs(),
                    "{} of {}: {} with {penalty}, {solver}: {}",
                    one.what.name(),
                    one.place,
                    one.value,
                    same.value
                );
            }
        }
    }
}

/// Source: `own`, the scene as it stands. Lengths grow by `length`, stresses by `stress`.
#[track_caller]
fn stays(scene: &Scene, own: &State, rotation: Rotation3<f64>, [length, stress]: [f64; 2]) {
    const SAME: f64 = 1e-6;
    let mut other = scene.clone();
    for p in &mut other.mesh.points {
        *p = (length * (rotation * Vector3::from(*p))).into();
    }
    for load in &mut other.tractions {
        if let TractionValue::Vector(t) = &mut load.value {
            *t = (stress * (rotation * Vector3::from(*t))).into();
        }
    }
    for steel in &mut other.materials {
        steel.youngs_modulus *= stress;
        steel.yield_stress *= stress;
        steel.hardening_modulus *= stress;
    }
    let other = solve(&mut other, &mut Silent).unwrap().last;
    let back = |u: &[f64; 3]| rotation.inverse() * Vector3::from(*u) / length;
    let most = own
        .displacement
        .iter()
        .map(|u| Vector3::from(*u).norm())
        .fold(0.0, f64::max);
    for (u, v) in own.displacement.iter().zip(&other.displacement) {
        let off = (Vector3::from(*u) - back(v)).norm();
        assert!(off <= SAME * most, "{off} of {most}");
    }
}

#[test]
fn turning_and_units_move_no_node() {
    for keys in [FIRST, SECOND] {
        let case = case_of(&[&keys[..], &[("PENALTY", "1.0"), ("SOLVER", "direct")]].concat());
        let mesh = job::find_mesh(&case, None, &mut |_| {}).unwrap();
        let scene = case.scene(mesh).unwrap();
        let own = solve(&mut scene.clone(), &mut Silent).unwrap().last;
        let turn = Rotation3::from_euler_angles(0.3, -1.1, 2.0);
        stays(&scene, &own, turn, [1.0, 1.0]);
        let inches = [1.0 / 25.4, 1.0 / 6.894757];
        stays(&scene, &own, Rotation3::identity(), inches);
    }
}
