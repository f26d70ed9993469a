//! The way to an answer does not decide it.

use brinell::case;
use brinell::certify::claim;
use brinell::job::{self, Options};
use brinell::output::Summary;
use brinell::solve::Silent;

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

fn solved(keys: &[(&str, &str)]) -> Summary {
    let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures");
    let mut text = BLOCKS.replace("FIXTURES", fixtures);
    for (key, value) in keys {
        text = text.replace(key, value);
    }
    let case = case::parse("scene.toml", &text).unwrap();
    let outcome = job::run(&case, &Options::default(), &mut Silent).unwrap();
    assert!(outcome.summary.converged);
    outcome.summary
}

/// Source: the same with the automatic penalty and one factor.
#[test]
fn penalties_and_division_move_no_figure() {
    const SAME: f64 = 1e-5;
    for scene in [
        [
            ("MESH", "rough-blocks-1"),
            ("MODULUS", "70000.0"),
            ("FRICTION", "0.4013569078326473"),
            ("CARRIER", "lower"),
            ("TRACTION", "[-6.461016, -2.195155, -162.4806]"),
        ],
        [
            ("MESH", "rough-blocks-2"),
            ("MODULUS", "200000.0"),
            ("FRICTION", "0.2"),
            ("CARRIER", "upper"),
            ("TRACTION", "[-0.6970296, 1.76229, -197.01324]"),
        ],
    ] {
        let with = |penalty, solver| {
            let keys = [("PENALTY", penalty), ("SOLVER", solver)];
            solved(&[&scene[..], &keys].concat())
        };
        let own = with("1.0", "direct");
        for (penalty, solver) in [("0.01", "direct"), ("100.0", "direct"), ("1.0", "divided")] {
            let other = with(penalty, solver);
            for one in &own.certificate {
                let same = claim(&other.certificate, one.what, &one.place).unwrap();
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
