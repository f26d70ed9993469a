//! Rigid planes that turn: by given angles, or under moments.

use super::kit::scene;
use brinell::answer::results::balance::centre_of_force;
use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::{
    ContactPair, Controls, ElementKind, Partner, PlaneMotion, PlaneTurn, RigidPlane, Scene, Side,
    SolverKind, Support,
};
use brinell::model::state::State;
use brinell::solver::solve::{Silent, solve};

const WIDTH: f64 = 2.0;
const DEPTH: f64 = 3.0;
const HEIGHT: f64 = 4.0;
const YOUNG: f64 = 1000.0;

fn held(surface: &str, components: [Option<f64>; 3]) -> Support {
    Support {
        name: surface.into(),
        surface: surface.into(),
        components,
        ..Support::default()
    }
}

fn turned(mesh: Mesh, steel: Steel, top: RigidPlane) -> Scene {
    Scene {
        rigid_planes: vec![top],
        controls: Controls {
            element: ElementKind::Enhanced,
            residual: 1e-11,
            ..Controls::default()
        },
        ..scene(mesh, steel)
    }
}

/// A plane on the surface `top` that is driven along z, or held there, and otherwise free.
fn plane(top: &str, z: PlaneMotion, turn: [PlaneTurn; 3]) -> RigidPlane {
    RigidPlane {
        name: "top".into(),
        surface: top.into(),
        motion: [PlaneMotion::Free, PlaneMotion::Free, z],
        turn,
        about: None,
    }
}

/// A bar of brick elements that bends exactly: without lateral strain it is held in full at its foot.
fn bar(top: RigidPlane) -> Scene {
    let mesh = Block::new(
        "bar",
        uniform(-1.0, 1.0, 2),
        uniform(-1.5, 1.5, 3),
        uniform(0.0, HEIGHT, 4),
    );
    let mut scene = turned(mesh.build().unwrap(), Steel::elastic(YOUNG, 0.0), top);
    scene.supports = vec![held("z_min", [Some(0.0); 3])];
    scene
}

fn area() -> f64 {
    WIDTH * DEPTH
}

/// Second moments of area about x and y.
fn inertia() -> [f64; 2] {
    [WIDTH * DEPTH.powi(3) / 12.0, DEPTH * WIDTH.powi(3) / 12.0]
}

fn last(scene: &mut Scene) -> State {
    solve(scene, &mut Silent).unwrap().last
}

fn near(found: f64, exact: f64, size: f64) {
    assert!((found - exact).abs() < 1e-9 * size, "{found} {exact}");
}

const FREE: PlaneTurn = PlaneTurn::Driven(0.0);
const STAYS: PlaneTurn = PlaneTurn::Held(0.0);

/// Bernoulli: σ = F/A + F e_x x/I_y + F e_y y/I_x, and the end section turns by M H/(E I).
#[test]
fn an_eccentric_force_turns_the_end_of_a_bar_by_its_moment() {
    let (force, [ex, ey]) = (-6.0, [0.2, -0.3]);
    let [ix, iy] = inertia();
    let turn = [
        force * ey * HEIGHT / (YOUNG * ix),
        -force * ex * HEIGHT / (YOUNG * iy),
    ];
    let moments = [
        PlaneTurn::Driven(force * ey),
        PlaneTurn::Driven(-force * ex),
        STAYS,
    ];
    let central = plane("z_max", PlaneMotion::Driven(force), moments);
    let off = RigidPlane {
        about: Some([ex, ey, HEIGHT]),
        ..plane("z_max", PlaneMotion::Driven(force), [FREE, FREE, STAYS])
    };
    for (top, at) in [(central, [0.0, 0.0]), (off, [ex, ey])] {
        let mut bar = bar(top);
        let state = last(&mut bar);
        let found = state.planes[0];
        near(found.turn[0], turn[0], turn[0].abs());
        near(found.turn[1], turn[1], turn[1].abs());
        let down = force * HEIGHT / (YOUNG * area()) + turn[0] * at[1] - turn[1] * at[0];
        near(found.travel[2], down, down.abs());
        for (element, points) in state.stress.iter().enumerate() {
            let corners = bar.mesh.corners(element);
            let middle = |axis: usize| corners.iter().map(|c| c[axis]).sum::<f64>() / 8.0;
            let mean = points.iter().map(|s| s[2]).sum::<f64>() / 8.0;
            let exact = force / area() + force * ex * middle(0) / iy + force * ey * middle(1) / ix;
            near(mean, exact, 1.0);
        }
        // The work of the force and the moments is what the bar stores.
        assert!(state.energy.unwrap().imbalance().unwrap() < 1e-9);
    }
}

/// M = E I θ / H, beside no force, about the middle; a plane that is held bears it as a reaction.
#[test]
fn a_plane_turned_by_given_angles_bears_the_moments_of_bending() {
    let angles = [1e-3, -2e-3];
    let turn = [
        PlaneTurn::Held(angles[0]),
        PlaneTurn::Held(angles[1]),
        STAYS,
    ];
    for z in [PlaneMotion::Held(0.0), PlaneMotion::Driven(0.0)] {
        let state = last(&mut bar(plane("z_max", z, turn)));
        let found = state.planes[0];
        for axis in 0..2 {
            let exact = YOUNG * inertia()[axis] * angles[axis] / HEIGHT;
            near(found.moment[axis], exact, exact.abs());
            near(found.turn[axis], angles[axis], angles[axis].abs());
        }
        near(found.force[2], 0.0, 1.0);
        near(found.travel[2], 0.0, 1e-3);
        assert!(state.energy.unwrap().imbalance().unwrap() < 1e-9);
    }
}

/// One half, mirrored across x, of a bar that turns about x says what the whole says.
#[test]
fn a_turn_about_the_mirrored_axis_keeps_the_half() {
    let moment = 2.0;
    let turn = |share: f64| [PlaneTurn::Driven(moment * share), STAYS, STAYS];
    let whole = last(&mut bar(plane(
        "z_max",
        PlaneMotion::Driven(-4.0),
        turn(1.0),
    )));
    let mesh = Block::new(
        "bar",
        uniform(0.0, 1.0, 1),
        uniform(-1.5, 1.5, 3),
        uniform(0.0, HEIGHT, 4),
    );
    let top = plane("z_max", PlaneMotion::Driven(-2.0), turn(0.5));
    let mut half = turned(mesh.build().unwrap(), Steel::elastic(YOUNG, 0.0), top);
    half.supports = vec![
        held("z_min", [Some(0.0); 3]),
        held("x_min", [Some(0.0), None, None]),
    ];
    half.mirrors = vec![0];
    let half = last(&mut half);
    let [whole, half] = [whole, half].map(|state| state.planes[0]);
    near(half.turn[0], whole.turn[0], whole.turn[0].abs());
    near(half.travel[2], whole.travel[2], whole.travel[2].abs());
}

/// Two blocks, one on the other, of meshes that do not match; the top is driven down at `about`, held sideways.
fn stack(about: [f64; 2], turn: [PlaneTurn; 3], steel: Steel) -> Scene {
    let lower = Block::new(
        "lower",
        uniform(-1.0, 1.0, 5),
        uniform(-1.5, 1.5, 6),
        uniform(0.0, 1.0, 3),
    );
    let upper = Block::new(
        "upper",
        uniform(-1.0, 1.0, 4),
        uniform(-1.5, 1.5, 4),
        uniform(1.0, 2.0, 3),
    );
    let lower = lower.build().unwrap().prefixed("lower_");
    let upper = upper.build().unwrap().prefixed("upper_");
    let top = RigidPlane {
        motion: [
            PlaneMotion::Held(0.0),
            PlaneMotion::Held(0.0),
            PlaneMotion::Driven(-12.0),
        ],
        about: Some([about[0], about[1], 2.0]),
        ..plane("upper_z_max", PlaneMotion::Free, turn)
    };
    let mut scene = turned(Mesh::join([lower, upper]).unwrap(), steel, top);
    scene.controls.element = ElementKind::Bbar;
    scene.supports = vec![held("lower_z_min", [Some(0.0); 3])];
    scene.contacts = vec![ContactPair {
        name: "upper-lower".into(),
        upper: Partner::Surface("upper_z_min".into()),
        lower: Partner::Surface("lower_z_max".into()),
        carrier: Side::Upper,
        friction: 0.0,
        penalty_factor: 1.0,
        true_geometry: true,
    }];
    scene
}

#[test]
fn the_pressure_on_a_free_top_passes_through_the_load() {
    // Within the core of the section, and beyond it, where a part of the surface lifts off.
    for about in [[0.1, -0.2], [0.5, 0.0]] {
        for solver in [SolverKind::Direct, SolverKind::Divided] {
            let mut stack = stack(about, [FREE, FREE, STAYS], Steel::elastic(YOUNG, 0.3));
            stack.controls.solver = solver;
            let state = last(&mut stack);
            let centre = centre_of_force(&stack, &state, 0).unwrap();
            for axis in 0..2 {
                let off = (centre[axis] - about[axis]).abs();
                assert!(off < 1e-8, "{centre:?} {about:?}");
            }
            assert!(state.energy.unwrap().imbalance().unwrap() < 1e-7);
        }
    }
}

#[test]
fn a_free_top_under_a_central_load_does_what_a_held_one_does() {
    let [free, held] = [[FREE, FREE, STAYS], [STAYS; 3]].map(|turn| {
        let mut stack = stack([0.0; 2], turn, Steel::elastic(YOUNG, 0.3));
        last(&mut stack)
    });
    let size = held.planes[0].travel[2].abs();
    let pairs = free
        .displacement
        .iter()
        .flatten()
        .zip(held.displacement.iter().flatten());
    pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-8 * size, "{a} {b}"));
    // What holds a top that does not turn is told, too: here nothing.
    assert!(held.planes[0].moment.iter().all(|m| m.abs() < 1e-8 * 12.0));
}

/// Beyond yield: the balance of moments and of energy, and the same from one solver as from the other.
#[test]
fn a_free_top_turns_further_where_steel_yields() {
    let steel = Steel {
        yield_stress: 2.5,
        hardening_modulus: 20.0,
        ..Steel::elastic(YOUNG, 0.3)
    };
    let solved = |solver| {
        let mut stack = stack([0.25, 0.1], [FREE, FREE, STAYS], steel);
        stack.controls.solver = solver;
        stack.controls.residual = 1e-9;
        let state = last(&mut stack);
        (centre_of_force(&stack, &state, 0).unwrap(), state)
    };
    let (centre, state) = solved(SolverKind::Direct);
    assert!(state.peeq.iter().flatten().any(|p| *p > 1e-4));
    assert!((centre[0] - 0.25).abs() < 1e-7 && (centre[1] - 0.1).abs() < 1e-7);
    assert!(state.energy.unwrap().imbalance().unwrap() < 1e-4);
    let (_, other) = solved(SolverKind::Divided);
    for axis in 0..2 {
        let [a, b] = [&state, &other].map(|state| state.planes[0].turn[axis]);
        assert!((a - b).abs() < 1e-5 * a.abs(), "{a} {b}");
    }
}
