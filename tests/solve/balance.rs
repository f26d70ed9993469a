//! Where rigid bodies have no balance the solution says so, and what would hold them.

use brinell::case;
use brinell::model::material::Steel;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::{ContactPair, Partner, Scene, Side, Traction, TractionValue};
use brinell::solver::solve::{NoBalance, Silent, SolveError, resume, solve};
use std::path::Path;

const WIDTH: f64 = 1.0;
const HEIGHT: f64 = 2.0;

/// A block of width 1 and height 2 that stands on a rigid plane, pressed at its top by 1 down and `side`
/// sideways.
fn standing(friction: f64, side: f64) -> Scene {
    let block = Block::new(
        "block",
        uniform(0.0, WIDTH, 4),
        uniform(0.0, WIDTH, 4),
        uniform(0.0, HEIGHT, 8),
    )
    .build()
    .expect("a block");
    let pair = ContactPair {
        name: "ground".into(),
        upper: Partner::Surface("z_min".into()),
        lower: Partner::Plane {
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
        },
        carrier: Side::Upper,
        friction,
        penalty_factor: 1.0,
        true_geometry: true,
    };
    Scene {
        contacts: vec![pair],
        tractions: vec![Traction {
            name: "top".into(),
            surface: "z_max".into(),
            value: TractionValue::Vector([side, 0.0, -1.0]),
        }],
        ..Scene::bare("standing", block, Steel::elastic(1000.0, 0.3))
    }
}

fn no_balance(scene: &mut Scene) -> NoBalance {
    match solve(scene, &mut Silent) {
        Err(SolveError::NoBalance(why)) => *why,
        other => panic!("{:?}", other.map(|solution| solution.complete)),
    }
}

/// Coulomb: it slides where the friction is less than the sideward share of the load.
#[test]
fn a_block_slides_where_friction_is_too_low() {
    let why = no_balance(&mut standing(0.1, 0.2));
    assert!(!why.tips && why.along[0] > 0.99, "{why:?}");
    let friction = why.friction.expect("friction helps");
    assert!((0.1999..0.2001).contains(&friction), "{friction}");
    let says = why.to_string();
    assert!(
        says.contains("`block` slides along (1.000") && says.contains("`ground`"),
        "{says}"
    );
}

/// As much is needed where there is none at all.
#[test]
fn a_block_without_friction_is_told_how_much_it_needs() {
    let why = no_balance(&mut standing(0.0, 0.2));
    let friction = why.friction.expect("friction helps");
    assert!((0.1999..0.2001).contains(&friction), "{friction}");
}

/// It tips about its edge where the load's line passes outside: beyond a sideward share of (1/2) / 2.
#[test]
fn a_block_tips_over_its_edge_whatever_the_friction() {
    let why = no_balance(&mut standing(0.9, 0.26));
    assert!(
        why.tips && why.along[1] > 0.99 && why.friction.is_none(),
        "{why:?}"
    );
    let (_, at) = why.bears.expect("it bears on an edge");
    assert!((at[0] - WIDTH).abs() < 1e-9, "{at:?}");
}

#[test]
fn a_block_that_can_stand_does() {
    let solution = solve(&mut standing(0.3, 0.2), &mut Silent).expect("it stands");
    assert!(solution.complete);
}

/// A displaced roller rolls up a slope: the line through both its contacts leans by half of the slope, across
/// the upper roller and across the lower one, and friction has to lean with both: √2 tan(slope/2).
#[test]
fn a_displaced_bearing_needs_friction_across_both_rollers() {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-offset-2.5.toml");
    let mut case = case::read(&path).expect("the shipped case reads");
    case.set_preset("h025").expect("a preset");
    let mesh =
        brinell::product::job::find_mesh(&case, None, &mut |_| {}).expect("the shipped mesh");
    let mut scene = case.scene(mesh).expect("a scene");
    scene.steps.truncate(1);
    let needed = 2f64.sqrt() * 2f64.to_radians().tan();
    let contacts = scene.contacts.iter_mut();
    contacts.for_each(|pair| pair.friction = 0.5 * needed);
    let friction = no_balance(&mut scene).friction.expect("friction helps");
    // Nodes stand beside the true lines of contact by a part of an element.
    assert!(
        (friction / needed - 1.0).abs() < 0.1,
        "{friction} of {needed}"
    );
}

/// As soft as that it stands, and leans farther than small rotations describe. What was solved before is kept.
#[test]
fn a_block_that_leans_far_is_refused_by_its_angle() {
    let mut scene = standing(0.9, 0.2);
    scene.materials[0].youngs_modulus = 12.0;
    scene.controls.first_increment = 0.1;
    let unfinished = resume(&mut scene, None, &mut Silent).expect_err("it leans");
    let SolveError::TurnsFar {
        percent,
        body,
        angle,
        ..
    } = &unfinished.error
    else {
        panic!("{}", unfinished.error);
    };
    assert!(body == "block" && *angle > 0.1, "{angle}");
    let solution = unfinished.solution.expect("the increments before");
    assert!((100.0 * solution.last.time - percent).abs() < 1e-9 && *percent > 0.0);
}
