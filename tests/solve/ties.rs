//! Ties: parts that are meshed apart and joined by mortar integrals.

use brinell::prelude::*;
use std::f64::consts::FRAC_PI_2;

const E: f64 = 210e3;
const NU: f64 = 0.3;

fn steel() -> Steel {
    Steel::elastic(E, NU)
}

/// A rotation about an axis that is aligned with nothing.
fn tilted(p: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = p;
    let (s, c) = 0.7f64.sin_cos();
    let [x, y] = [c * x - s * y, s * x + c * y];
    let (s, c) = 0.4f64.sin_cos();
    [x, c * y - s * z, s * y + c * z]
}

/// Two blocks one upon the other, `lower` and `upper`, with 3 and 4 elements along each side.
fn stack(map: impl Fn([f64; 3]) -> [f64; 3] + Clone) -> SceneBuilder {
    let side = |n| uniform(0.0, 1.0, n);
    let lower = Block::new("lower", side(3), side(3), uniform(0.0, 1.0, 2)).mapped(map.clone());
    let upper = Block::new("upper", side(4), side(4), uniform(1.0, 2.0, 3)).mapped(map);
    SceneBuilder::new("stack")
        .body(lower, steel())
        .body(upper, steel())
        .tie(Tie::between("lower_z_max", "upper_z_min"))
        .controls(|c| c.residual = 1e-12)
}

/// A displacement gradient with all components, and the stress of it.
const GRADIENT: [[f64; 3]; 3] = [
    [1.0e-3, 4.0e-4, -3.0e-4],
    [2.0e-4, -8.0e-4, 5.0e-4],
    [7.0e-4, -1.0e-4, 6.0e-4],
];

fn stress(gradient: &[[f64; 3]; 3]) -> [f64; 6] {
    let (shear, lame) = (
        E / (2.0 + 2.0 * NU),
        E * NU / ((1.0 + NU) * (1.0 - 2.0 * NU)),
    );
    let trace: f64 = (0..3).map(|i| gradient[i][i]).sum();
    [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].map(|(i, j)| {
        let normal = if i == j { lame * trace } else { 0.0 };
        normal + shear * (gradient[i][j] + gradient[j][i])
    })
}

fn linear(surface: &str) -> Support {
    Support {
        name: surface.into(),
        surface: surface.into(),
        components: [Some(0.0); 3],
        gradient: GRADIENT,
    }
}

/// Largest deviation of any stress from that of the gradient, over the largest component of it.
fn deviation(state: &State) -> f64 {
    let exact = stress(&GRADIENT);
    let size = exact.iter().fold(0.0f64, |size, s| size.max(s.abs()));
    let points = state.stress.iter().flatten();
    let off = points.flat_map(|s| (0..6).map(|i| (s[i] - exact[i]).abs()));
    off.fold(0.0, f64::max) / size
}

const SIDES: [&str; 4] = ["x_min", "x_max", "y_min", "y_max"];

/// Holds the far ends, and on all sides the displacement, or the traction, of a uniform stress.
fn patch(map: impl Fn([f64; 3]) -> [f64; 3] + Clone, held: bool) -> Solved {
    let mut scene = stack(map.clone())
        .support(linear("lower_z_min"))
        .support(linear("upper_z_max"));
    let [xx, yy, zz, xy, yz, zx] = stress(&GRADIENT);
    let tensor = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    let origin = map([0.0; 3]);
    for (axis, side) in [0, 0, 1, 1].into_iter().zip(SIDES) {
        for body in ["lower", "upper"] {
            let surface = format!("{body}_{side}");
            if held {
                scene = scene.support(linear(&surface));
                continue;
            }
            let mut normal = [0.0; 3];
            normal[axis] = if side.ends_with("max") { 1.0 } else { -1.0 };
            let turned = map(normal);
            let normal: [f64; 3] = std::array::from_fn(|i| turned[i] - origin[i]);
            let traction = tensor.map(|row| (0..3).map(|j| row[j] * normal[j]).sum());
            scene = scene.load(Load::traction(&surface, traction));
        }
    }
    Solved::of(scene.build().unwrap()).unwrap()
}

#[test]
fn a_uniform_stress_passes_a_tilted_plane_between_meshes_that_do_not_match() {
    for held in [false, true] {
        let off = deviation(patch(tilted, held).state());
        assert!(off < 1e-10, "held sides {held}: {off:e}");
    }
}

#[test]
fn facets_need_not_be_parallelograms() {
    // Nodes in the plane of the tie are moved within it.
    let bent = |p: [f64; 3]| {
        let [x, y, z] = p;
        let wave = |a: f64, b: f64| 0.12 * (a * (1.0 - a) * (1.0 + 2.0 * b)).clamp(-1.0, 1.0);
        tilted([x + wave(x, y), y + wave(y, x) * x, z])
    };
    let scene = |held| {
        let mut scene = stack(bent)
            .support(linear("lower_z_min"))
            .support(linear("upper_z_max"));
        for side in SIDES.into_iter().filter(|_| held) {
            for body in ["lower", "upper"] {
                scene = scene.support(linear(&format!("{body}_{side}")));
            }
        }
        Solved::of(scene.build().unwrap()).unwrap()
    };
    let off = deviation(scene(true).state());
    assert!(off < 1e-10, "{off:e}");
}

#[test]
fn the_force_of_a_tie_is_told_as_it_acts_on_the_second_surface() {
    let solved = patch(|p| p, false);
    let [_, _, zz, _, yz, zx] = stress(&GRADIENT);
    let field = &solved.state().ties[0];
    // Lower block on upper one: the normal out of the lower one is z.
    let exact = [-zx, -yz, -zz];
    for (force, area) in field.force.iter().zip(&field.area) {
        for i in 0..3 {
            let off = (force[i] / area - exact[i]).abs();
            assert!(off < 1e-8 * zz.abs(), "{force:?} {area} {exact:?}");
        }
    }
    let sum: f64 = field.area.iter().sum();
    assert!((sum - 1.0).abs() < 1e-12, "{sum}");
    assert!(
        field
            .pressure
            .iter()
            .all(|p| (p + zz).abs() < 1e-8 * zz.abs())
    );
    let swapped = {
        let mut scene = solved.scene.clone();
        scene.ties[0].surfaces.reverse();
        Solved::of(scene).unwrap()
    };
    let back = &swapped.state().ties[0];
    for (a, b) in field.force.iter().zip(&back.force) {
        assert!(
            (0..3).all(|i| (a[i] + b[i]).abs() < 1e-8 * zz.abs()),
            "{a:?} {b:?}"
        );
    }
}

/// A quarter of a tube from 1 to 2, meshed as two shells that meet at 1.4; `n` elements around the inner one.
fn shells(n: usize) -> SceneBuilder {
    let height = || uniform(0.0, 0.2, 1);
    let shell = |name, radii, around| {
        Block::new(name, radii, uniform(0.0, FRAC_PI_2, around), height()).mapped(cylindrical)
    };
    let inner = shell("inner", uniform(1.0, 1.4, n / 3), n);
    let outer = shell("outer", uniform(1.4, 2.0, n / 3), 3 * n / 4);
    SceneBuilder::new("tube")
        .body(inner, steel())
        .body(outer, steel())
        .tie(Tie::between("inner_x_max", "outer_x_min"))
        .controls(|c| c.residual = 1e-12)
}

#[test]
fn round_shells_that_turn_as_one_are_free_of_stress() {
    let angle = 1e-3;
    for turn in [
        [[0.0, -angle, 0.0], [angle, 0.0, 0.0], [0.0; 3]],
        [[0.0, 0.0, angle], [0.0; 3], [-angle, 0.0, 0.0]],
    ] {
        let scene = shells(12).support(Support {
            gradient: turn,
            ..linear("outer_x_max")
        });
        let solved = Solved::of(scene.build().unwrap()).unwrap();
        let stress = solved.state().stress.iter().flatten().flatten();
        let most = stress.fold(0.0f64, |most, s| most.max(s.abs()));
        assert!(most < 1e-10 * E * angle, "{most:e}");
    }
}

/// Radial displacement of the bore under a pressure of 100 in it, plane strain (Lamé).
fn bore() -> f64 {
    let (a, b, p): (f64, f64, f64) = (1.0, 2.0, 100.0);
    let k = p * a * a / (b * b - a * a);
    (1.0 + NU) / E * k * ((1.0 - 2.0 * NU) * a + b * b / a)
}

#[test]
fn a_tube_of_two_shells_tends_to_lames_with_the_second_order() {
    let error = |n| {
        let scene = shells(n)
            .mirror(Axis::X)
            .mirror(Axis::Y)
            .plane_strain(Axis::Z)
            .load(Load::pressure("inner_x_min", 100.0));
        let solved = Solved::of(scene.build().unwrap()).unwrap();
        let mesh = &solved.scene.mesh;
        let nodes = mesh.surface("inner_x_min").unwrap().nodes();
        let radial = nodes.iter().map(|n| {
            let (x, u) = (
                mesh.points[*n as usize],
                solved.state().displacement[*n as usize],
            );
            (x[0] * u[0] + x[1] * u[1]) / x[0].hypot(x[1])
        });
        let off = radial.map(|u| (u / bore() - 1.0).abs());
        off.fold(0.0, f64::max)
    };
    let [coarse, fine] = [12, 24].map(error);
    let order = (coarse / fine).log2();
    assert!(
        order > 1.8 && fine < 2e-3,
        "{coarse:e} {fine:e}: order {order}"
    );
}

/// A beam along x, 4 long, bent by a force at its end; in one part, or in two that meet at 1.7.
fn beam(parts: usize, change: impl FnOnce(SceneBuilder) -> SceneBuilder) -> Solved {
    let section = |n| uniform(-0.25, 0.25, n);
    let scene = SceneBuilder::new("beam").controls(|c| {
        c.element = ElementKind::Enhanced;
        c.residual = 1e-10;
    });
    let scene = match parts {
        1 => {
            let one = Block::new("end", uniform(0.0, 4.0, 32), section(4), section(4));
            scene.body(one, steel()).fix("end_x_min")
        }
        _ => {
            let root = Block::new("root", uniform(0.0, 1.7, 14), section(4), section(4));
            let end = Block::new("end", uniform(1.7, 4.0, 15), section(3), section(3));
            scene
                .body(root, steel())
                .body(end, steel())
                .tie(Tie::between("root_x_max", "end_x_min"))
                .fix("root_x_min")
        }
    };
    let scene = scene.load(Load::force("end_x_max", [0.0, 0.0, -10.0]));
    Solved::of(change(scene).build().unwrap()).unwrap()
}

fn tip(solved: &Solved) -> f64 {
    solved.travel_of("end_x_max", solved.state())[2]
}

#[test]
fn a_beam_of_two_parts_bends_as_one() {
    let (one, two) = (beam(1, |s| s), beam(2, |s| s));
    let ratio = tip(&two) / tip(&one);
    // What the coarser half bends more by.
    assert!((ratio - 1.0).abs() < 2e-3, "{ratio}");
    let force = two.answer.ties.0[0].1.force;
    assert!(
        force[0].abs() < 1e-6 && (force[2] - 10.0).abs() < 1e-6,
        "{force:?}"
    );
}

#[test]
fn the_answer_depends_neither_on_threads_nor_on_the_linear_solver() {
    let whole = beam(2, |s| s);
    let pool = |n| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(n)
            .build()
            .unwrap()
    };
    let same = |other: &Solved, within: f64| {
        let ratio = tip(other) / tip(&whole);
        assert!((ratio - 1.0).abs() < within, "{ratio}");
    };
    same(&pool(1).install(|| beam(2, |s| s)), 1e-9);
    same(&pool(3).install(|| beam(2, |s| s)), 1e-9);
    let divided = |s: SceneBuilder| s.controls(|c| c.solver = SolverKind::Divided);
    same(&beam(2, divided), 1e-6);
}

#[test]
fn a_scene_in_another_position_has_the_same_answer() {
    let sides = |n| uniform(0.0, 1.0, n);
    let turned = |p: [f64; 3]| [p[2], p[0], p[1]];
    let of = |map: fn([f64; 3]) -> [f64; 3], swap: bool, force: [f64; 3]| {
        let mut bodies = vec![
            Block::new("a", sides(3), sides(3), sides(3)),
            Block::new("b", sides(4), sides(4), uniform(1.0, 2.0, 3)),
        ];
        if swap {
            bodies.reverse();
        }
        let mut scene = SceneBuilder::new("cubes");
        for body in bodies {
            scene = scene.body(body.mapped(map), steel());
        }
        let scene = scene
            .tie(Tie::between("a_z_max", "b_z_min"))
            .fix("a_z_min")
            .load(Load::force("b_z_max", force));
        let solved = Solved::of(scene.build().unwrap()).unwrap();
        solved.travel_of("b_z_max", solved.state())
    };
    let first = of(|p| p, false, [1.0, 2.0, 3.0]);
    let second = of(turned, true, turned([1.0, 2.0, 3.0]));
    for (a, b) in turned(first).into_iter().zip(second) {
        assert!((a / b - 1.0).abs() < 1e-9, "{first:?} {second:?}");
    }
}

#[test]
fn a_half_says_what_the_whole_says_of_a_tie_at_its_mirror_plane() {
    let of = |half: bool| {
        let side = |n: usize| match half {
            true => uniform(0.0, 1.0, n),
            false => uniform(-1.0, 1.0, 2 * n),
        };
        let across = |n| uniform(0.0, 1.0, n);
        let scene = SceneBuilder::new("half")
            .body(Block::new("a", side(3), across(3), across(2)), steel())
            .body(
                Block::new("b", side(4), across(4), uniform(1.0, 1.5, 2)).mapped(|p| p),
                Steel::elastic(E / 10.0, 0.4),
            )
            .tie(Tie::between("a_z_max", "b_z_min"))
            .fix("a_z_min")
            .load(Load::pressure("b_z_max", 100.0));
        let scene = if half { scene.mirror(Axis::X) } else { scene };
        Solved::of(scene.build().unwrap()).unwrap()
    };
    let (half, whole) = (of(true), of(false));
    let of_whole = |at: &[f64; 3], body: &str| {
        let points = &whole.scene.mesh.points;
        let near = |p: &[f64; 3]| (0..3).all(|i| (p[i] - at[i]).abs() < 1e-9);
        // Nodes of both bodies may be in one place: those of the lower one come first.
        let mut found = (0..points.len()).filter(|n| near(&points[*n]));
        let node = match body {
            "a" => found.next(),
            _ => found.last(),
        };
        whole.state().displacement[node.unwrap()]
    };
    let scale = half.descent().unwrap();
    for body in ["a", "b"] {
        let mesh = &half.scene.mesh;
        let own = mesh.bodies[mesh.body(body).unwrap()].elements.clone();
        for node in mesh.hexes[own].iter().flatten() {
            let u = half.state().displacement[*node as usize];
            let v = of_whole(&mesh.points[*node as usize], body);
            let off = (0..3).map(|i| (u[i] - v[i]).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9 * scale, "{body} {node}: {u:?} {v:?}");
        }
    }
    let [one, two] = [&half, &whole].map(|s| s.answer.ties.0[0].1.force);
    assert!((one[2] / two[2] - 1.0).abs() < 1e-9, "{one:?} {two:?}");
}

#[test]
fn contact_may_run_across_a_tie() {
    // A soft block on two that are tied side by side, with a uniform pressure.
    let side = |n| uniform(0.0, 1.0, n);
    let scene = SceneBuilder::new("seam")
        .body(Block::new("left", side(3), side(3), side(2)), steel())
        .body(
            Block::new("right", uniform(1.0, 2.0, 4), side(4), side(3)),
            steel(),
        )
        .body(
            Block::new("top", uniform(0.0, 2.0, 5), side(2), uniform(1.0, 1.5, 2)),
            steel(),
        );
    let mut mesh = scene
        .tie(Tie::between("left_x_max", "right_x_min"))
        .hold("left_x_min", Axis::X)
        .hold("left_y_min", Axis::Y)
        .hold("right_y_min", Axis::Y)
        .hold("left_z_min", Axis::Z)
        .hold("right_z_min", Axis::Z)
        .hold("top_x_min", Axis::X)
        .hold("top_y_min", Axis::Y)
        .contact(Contact::between("top_z_min", "left_z_max").carried_by(Side::Lower))
        .load(Load::pressure("top_z_max", 100.0))
        .controls(|c| (c.residual, c.penetration) = (1e-11, 1e-11))
        .build()
        .unwrap();
    // One surface over both.
    let right = mesh.mesh.surface("right_z_max").unwrap().faces.clone();
    let both = mesh.mesh.surfaces.iter_mut();
    let both = both.filter(|s| s.name == "left_z_max");
    both.for_each(|s| s.faces.extend(right.iter().copied()));
    let solved = Solved::of(mesh).unwrap();
    let field = &solved.state().contacts[0];
    let pressures = field.pressure.iter().zip(&field.area);
    let carried: Vec<f64> = pressures
        .filter(|(_, a)| **a > 0.0)
        .map(|(p, _)| *p)
        .collect();
    assert!(
        carried.iter().all(|p| (p - 100.0).abs() < 1e-5),
        "{carried:?}"
    );
    let zz = solved.state().stress.iter().flatten().map(|s| s[2]);
    let off = zz.fold(0.0f64, |off, s| off.max((s + 100.0).abs()));
    assert!(off < 1e-5, "{off:e}");
}

#[test]
fn a_fine_block_set_into_a_coarse_body_is_tied_at_all_its_faces() {
    // Under the stress of a linear displacement: at edges two ties meet.
    let coarse = |name, x, y, z| Block::new(name, x, y, z).mapped(tilted);
    let scene = SceneBuilder::new("inset")
        .body(
            coarse(
                "fine",
                uniform(1.0, 2.0, 4),
                uniform(0.0, 1.0, 4),
                uniform(0.0, 1.0, 4),
            ),
            steel(),
        )
        .body(
            coarse(
                "left",
                uniform(0.0, 1.0, 1),
                uniform(0.0, 1.0, 3),
                uniform(0.0, 1.0, 3),
            ),
            steel(),
        )
        .body(
            coarse(
                "under",
                uniform(0.0, 2.0, 3),
                uniform(0.0, 1.0, 2),
                uniform(-1.0, 0.0, 2),
            ),
            steel(),
        )
        .tie(Tie::between("fine_x_min", "left_x_max"))
        .tie(Tie::between("fine_z_min", "under_z_max"))
        .tie(Tie::between("left_z_min", "under_z_max").named("under left"))
        .support(linear("under_z_min"))
        .support(linear("fine_z_max"))
        .support(linear("left_z_max"))
        .support(linear("left_x_min"))
        .support(linear("fine_x_max"))
        .controls(|c| c.residual = 1e-12);
    let mut scene = scene;
    for body in ["fine", "left", "under"] {
        for side in ["y_min", "y_max"] {
            scene = scene.support(linear(&format!("{body}_{side}")));
        }
    }
    for side in ["x_min", "x_max"] {
        scene = scene.support(linear(&format!("under_{side}")));
    }
    let solved = Solved::of(scene.build().unwrap()).unwrap();
    let off = deviation(solved.state());
    assert!(off < 1e-10, "{off:e}");
}

#[test]
fn surfaces_that_do_not_belong_together_are_refused_by_name() {
    let side = |n| uniform(0.0, 1.0, n);
    let with = |from: f64, second: &str| {
        let scene = SceneBuilder::new("apart")
            .body(Block::new("a", side(2), side(2), side(2)), steel())
            .body(
                Block::new("b", side(3), side(3), uniform(from, from + 1.0, 2)),
                steel(),
            )
            .tie(Tie::between("a_z_max", second))
            .fix("a_z_min")
            .load(Load::pressure("b_z_max", 1.0));
        Solved::of(scene.build().unwrap())
            .map(|_| ())
            .unwrap_err()
            .to_string()
    };
    let far = with(1.3, "b_z_min");
    assert!(
        far.contains("`a_z_max` and `b_z_min`") && far.contains("3.000e-1 apart"),
        "{far}"
    );
    let wrong = with(1.0, "b_x_min");
    assert!(wrong.contains("do not lie upon each other"), "{wrong}");
}

#[test]
fn a_distance_that_is_bridged_lets_bodies_turn_as_one() {
    let side = |n| uniform(0.0, 1.0, n);
    let angle = 1e-3;
    let scene = SceneBuilder::new("bridged")
        .body(Block::new("a", side(3), side(3), side(2)), steel())
        .body(
            Block::new("b", side(4), side(4), uniform(1.2, 2.0, 2)),
            steel(),
        )
        .tie(Tie::between("a_z_max", "b_z_min").within(0.25))
        .support(Support {
            gradient: [[0.0, 0.0, angle], [0.0; 3], [-angle, 0.0, 0.0]],
            ..linear("a_z_min")
        });
    let solved = Solved::of(scene.build().unwrap()).unwrap();
    let stress = solved.state().stress.iter().flatten().flatten();
    let most = stress.fold(0.0f64, |most, s| most.max(s.abs()));
    assert!(most < 1e-10 * E * angle, "{most:e}");
    assert!((solved.state().ties[0].distance - 0.2).abs() < 1e-12);
}
