//! Solids and contact on blocks: patch tests and the uniaxial curve.

use super::kit::{held, scene};
use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::{
    ContactPair, Partner, PlaneMotion, RigidPlane, Side, Step, Support, Traction, TractionValue,
};
use brinell::model::state::State;
use brinell::solver::solve::{Silent, Solution, solve};

fn report_steel() -> Steel {
    Steel {
        youngs_modulus: 29500.0,
        poissons_ratio: 0.3,
        yield_stress: 100.0,
        hardening_modulus: 249.471,
    }
}

/// Uniaxial stress at total strain 0.05 with the report's steel: 111.53040 ksi; unloaded from
/// there the residual strain is 0.04621931 (closed form of the bilinear curve, H = 249.471 ksi).
#[test]
fn uniaxial_cube_follows_the_bilinear_curve_and_unloads_elastically() {
    let mesh = Block::new(
        "cube",
        uniform(0.0, 1.0, 2),
        uniform(0.0, 1.0, 2),
        uniform(0.0, 1.0, 2),
    )
    .build()
    .unwrap();
    let mut s = scene(mesh, report_steel());
    s.supports = vec![held("x_min", 0), held("y_min", 1), held("z_min", 2)];
    s.controls.residual = 1e-12;
    s.rigid_planes = vec![RigidPlane {
        name: "pull".into(),
        surface: "z_max".into(),
        motion: [
            PlaneMotion::Free,
            PlaneMotion::Free,
            PlaneMotion::Held(0.05),
        ],
        ..RigidPlane::default()
    }];
    let solution = solve(&mut s, &mut Silent).unwrap();
    let state = solution.states.last().unwrap();
    let (h, e, y) = (249.471, 29500.0, 100.0);
    let et = e * h / (e + h);
    let exact = y + et * (0.05 - y / e);
    for points in &state.stress {
        for stress in points {
            assert!(
                (stress[2] - exact).abs() < 1e-8 * exact,
                "{} {exact}",
                stress[2]
            );
            assert!(stress[0].abs() < 1e-7 && stress[3].abs() < 1e-7);
        }
    }
}

/// Two blocks of different steel and meshes that do not match, uniform pressure on the top of the
/// upper block and on the exposed top of the lower one (Taylor and Papadopoulos 1991): the
/// pressure is uniform and no other stress appears (equal nu / E not needed without friction).
#[test]
fn contact_patch_test_is_uniform() {
    let lower = Block::new(
        "lower",
        vec![0.0, 0.5, 1.0, 2.0, 3.0],
        uniform(0.0, 1.0, 3),
        uniform(0.0, 1.0, 2),
    )
    .build()
    .unwrap()
    .prefixed("lower_");
    let upper = Block::new(
        "upper",
        uniform(0.0, 1.0, 3),
        uniform(0.0, 1.0, 2),
        uniform(1.0, 2.0, 2),
    )
    .build()
    .unwrap()
    .prefixed("upper_");
    let mut mesh = Mesh::join([lower, upper]).unwrap();
    let exposed: Vec<_> = mesh
        .surface("lower_z_max")
        .unwrap()
        .faces
        .iter()
        .filter(|f| f.nodes.iter().all(|n| mesh.points[*n as usize][0] >= 1.0))
        .copied()
        .collect();
    mesh.surfaces.push(brinell::model::mesh::Surface {
        name: "exposed".into(),
        faces: exposed,
    });
    let mut s = scene(mesh, Steel::elastic(1000.0, 0.3));
    s.materials[1] = Steel::elastic(3000.0, 0.2);
    s.controls.residual = 1e-11;
    s.controls.penetration = 1e-10;
    s.supports = ["lower_", "upper_"]
        .iter()
        .flat_map(|b| [held(&format!("{b}x_min"), 0), held(&format!("{b}y_min"), 1)])
        .chain([held("lower_z_min", 2)])
        .collect();
    let pressure = |surface: &str| Traction {
        name: surface.into(),
        surface: surface.into(),
        value: TractionValue::Pressure(2.0),
    };
    s.tractions = vec![pressure("upper_z_max"), pressure("exposed")];
    s.contacts = vec![ContactPair {
        name: "upper-lower".into(),
        upper: Partner::Surface("upper_z_min".into()),
        lower: Partner::Surface("lower_z_max".into()),
        carrier: Side::Upper,
        friction: 0.0,
        penalty_factor: 1.0,
        true_geometry: true,
    }];
    let solution = solve(&mut s, &mut Silent).unwrap();
    let state = solution.states.last().unwrap();
    for p in &state.contacts[0].pressure {
        assert!((p - 2.0).abs() < 1e-8, "{p}");
    }
    for stress in state.stress.iter().flatten() {
        assert!((stress[2] + 2.0).abs() < 1e-8, "{stress:?}");
        assert!(stress[0].abs() < 1e-8);
    }
}

/// A cube pulled beyond yield and then sheared while it is held: its flow turns, and the stress depends
/// on the increments. Source: the same with increments of a thousandth. With the mean direction of the flow it is off by a quarter of a
/// percent at most; the estimate, from increments twice as large that do without, is of first order and covers it.
#[test]
fn the_error_of_increments_is_known_where_flow_turns() {
    let solved = |first_increment: f64| {
        let list = || uniform(0.0, 1.0, 2);
        let mesh = Block::new("cube", list(), list(), list()).build().unwrap();
        let mut s = scene(mesh, report_steel());
        // Simple shear and stretch of all nodes: the strain is given, only the stress is sought.
        let moved = |name: &str, surface: &str, gradient: [[f64; 3]; 3]| Support {
            name: name.into(),
            surface: surface.into(),
            components: [Some(0.0); 3],
            gradient,
        };
        s.supports = vec![held("x_min", 0), held("y_min", 1), held("z_min", 2)];
        s.supports[0].surface = "z_min".into();
        s.supports[1].surface = "z_min".into();
        let pull = [[0.0; 3], [0.0; 3], [0.0, 0.0, 0.01]];
        let shear = [[0.0, 0.0, 0.02], [0.0; 3], [0.0; 3]];
        let mut top = moved("top", "z_max", [[0.0; 3]; 3]);
        top.gradient = [shear[0], [0.0; 3], [0.0; 3]];
        top.components = [Some(0.0), Some(0.0), None];
        s.supports.push(top);
        let mut up = moved("up", "z_max", pull);
        up.components = [None, None, Some(0.0)];
        s.supports.push(up);
        let step = |name: &str, top: f64, up: f64| Step {
            name: name.into(),
            factor: 0.0,
            factors: vec![("top".into(), top), ("up".into(), up)],
        };
        s.steps = vec![step("pull", 0.0, 1.0), step("shear", 1.0, 1.0)];
        s.controls.first_increment = first_increment;
        solve(&mut s, &mut Silent).unwrap()
    };
    let [coarse, fine, exact] = [0.3, 0.01, 0.001].map(solved);
    let between = |one: &State, other: &State| {
        let off: [f64; 6] = std::array::from_fn(|i| one.stress[0][0][i] - other.stress[0][0][i]);
        brinell::answer::results::tensor::mises(&off)
    };
    let estimate = |solution: &Solution| between(&solution.last, solution.doubled.last().unwrap());
    let size = brinell::answer::results::tensor::mises(&exact.last.stress[0][0]);
    for solution in [&coarse, &fine] {
        let error = between(&solution.last, &exact.last);
        assert!(
            error < 2.5e-3 * size && error < estimate(solution),
            "{error}"
        );
    }
}

/// A block that sticks to a rigid plane everywhere is one that is fixed there. Only its nodes in contact are left of it where
/// elastic parts are condensed, and none of them moves.
#[test]
fn a_block_that_sticks_all_over_is_a_fixed_one() {
    let block = || {
        let axes = [(8, 20.0), (4, 10.0), (3, 5.0)].map(|(cells, to)| uniform(0.0, to, cells));
        let [x, y, z] = axes;
        Block::new("block", x, y, z).build().unwrap()
    };
    let traction = |name: &str, value| Traction {
        name: name.into(),
        surface: "z_max".into(),
        value,
    };
    let solved = |sticks: bool| {
        let mut s = scene(block(), Steel::elastic(210e3, 0.3));
        if sticks {
            let plane = Partner::Plane {
                point: [0.0; 3],
                normal: [0.0, 0.0, 1.0],
            };
            s.contacts = vec![ContactPair {
                name: "foot".into(),
                upper: Partner::Surface("z_min".into()),
                lower: plane,
                carrier: Side::Upper,
                friction: 2.0,
                penalty_factor: 1.0,
                true_geometry: true,
            }];
        } else {
            s.supports = vec![Support {
                components: [Some(0.0); 3],
                ..held("z_min", 2)
            }];
        }
        s.tractions = vec![
            traction("press", TractionValue::Pressure(10.0)),
            traction("push", TractionValue::Vector([-1.0, 0.0, 0.0])),
        ];
        s.steps = vec![Step::to("load", 1.0)];
        let solution = solve(&mut s, &mut Silent).unwrap();
        solution.states.last().unwrap().displacement.clone()
    };
    let [stuck, fixed] = [true, false].map(solved);
    let size = |u: &[f64; 3]| u.iter().map(|v| v.abs()).fold(0.0, f64::max);
    let largest = fixed.iter().map(size).fold(0.0, f64::max);
    for (a, b) in stuck.iter().zip(&fixed) {
        let off = size(&[a[0] - b[0], a[1] - b[1], a[2] - b[2]]);
        assert!(off < 1e-8 * largest, "{off} of {largest}");
    }
}
