//! Stiff blocks that ride on a soft one: what rounding leaves of their balance.

use brinell::answer::results::interface::interfaces;
use brinell::prelude::{Axis, Block, Contact, Load, SceneBuilder, Steel, uniform};
use brinell::solver::solve::{Obstacle, Silent, SolveError, solve};

/// mm, MPa.
const SIDE: f64 = 10.0;
const HEIGHT: f64 = 7.0;
const STIFF: f64 = 2e5;
/// Pressure over the modulus of the soft block.
const STRAIN: f64 = 0.01;

/// Three stiff blocks on one of the modulus `soft`: the descent of the top, and the forces between them over the load.
fn column(soft: f64) -> Result<(f64, Vec<f64>), SolveError> {
    let mut scene = SceneBuilder::new("column");
    for (k, name) in ["a", "b", "c", "d"].into_iter().enumerate() {
        // Facets do not match.
        let along = || uniform(0.0, SIDE, 3 + k % 2);
        let z = uniform(k as f64 * HEIGHT, (k + 1) as f64 * HEIGHT, 2);
        let modulus = if k == 0 { soft } else { STIFF };
        let block = Block::new(name, along(), along(), z)
            .build()
            .expect("a block");
        scene = scene
            .body(
                block.prefixed(&format!("{name}_")),
                Steel::elastic(modulus, 0.3),
            )
            .hold(&format!("{name}_x_min"), Axis::X)
            .hold(&format!("{name}_y_min"), Axis::Y);
    }
    for pair in [["b", "a"], ["c", "b"], ["d", "c"]] {
        let [upper, lower] = pair;
        scene = scene.contact(Contact::between(
            &format!("{upper}_z_min"),
            &format!("{lower}_z_max"),
        ));
    }
    let scene = scene.hold("a_z_min", Axis::Z);
    let mut scene = scene
        .load(Load::pressure("d_z_max", STRAIN * soft))
        .build()
        .expect("a scene");
    let state = solve(&mut scene, &mut Silent)?.last;
    let top = scene.mesh.surface("d_z_max").expect("a top").nodes()[0];
    let forces = interfaces(&scene, &state);
    let load = STRAIN * soft * SIDE * SIDE;
    let shares = forces.iter().map(|i| i.normal_force / load).collect();
    Ok((-state.displacement[top as usize][2], shares))
}

/// Rounding leaves more than 1e-8 of the load, and all that can be asked for is there: p h / E.
#[test]
fn stiff_blocks_on_a_soft_one_are_solved_as_far_as_rounding_lets_them() {
    for ratio in [1e4, 1e5, 1e6] {
        let soft = STIFF / ratio;
        let (descent, shares) = column(soft).expect("converges");
        let exact = STRAIN * HEIGHT * (1.0 + 3.0 / ratio);
        assert!(
            (descent / exact - 1.0).abs() < 1e-6,
            "{ratio}: {descent} {exact}"
        );
        for share in shares {
            assert!((share - 1.0).abs() < 1e-5, "{ratio}: {share}");
        }
    }
}

/// Where rounding leaves more than an answer may, the message says so, and what helps.
#[test]
fn what_rounding_takes_is_told() {
    let error = column(STIFF / 1e10).expect_err("is lost to rounding");
    let SolveError::NotConverged { obstacle, .. } = &error else {
        panic!("{error}")
    };
    let Some(Obstacle::Rounding(share)) = obstacle.as_deref() else {
        panic!("{error}")
    };
    assert!(*share > 1e-5, "{share}");
    assert!(error.to_string().contains("rounding alone"), "{error}");
    let help = miette::Diagnostic::help(&error).expect("help").to_string();
    assert!(help.contains("`residual`"), "{help}");
}
