//! Uniform stress across ties.

use super::*;
use brinell::model::scene::Temperature;

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
            normal[axis] = 1.0;
            let sign = if side.ends_with("max") { 1.0 } else { -1.0 };
            let turned = map(normal);
            let normal: [f64; 3] = std::array::from_fn(|i| sign * (turned[i] - origin[i]));
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
    // With held sides every node of the rim is held: then what its functions carry goes to nodes within.
    for held in [false, true] {
        let off = deviation(patch(bent, held).state());
        assert!(off < 1e-10, "held sides {held}: {off:e}");
    }
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

#[test]
fn a_tie_between_blocks_that_are_free_to_grow_carries_nothing() {
    let warm = |body: &str| Temperature {
        name: format!("{body} is warm"),
        body: body.into(),
        expansion: 12e-6,
        value: 50.0,
        gradient: [0.0; 3],
    };
    let mut scene = stack(|p| p)
        .hold("lower_z_min", Axis::Z)
        .hold("lower_x_min", Axis::X)
        .hold("upper_x_min", Axis::X)
        .hold("lower_y_min", Axis::Y)
        .hold("upper_y_min", Axis::Y)
        .build()
        .unwrap();
    scene.temperatures = ["lower", "upper"].map(warm).into();
    let solved = Solved::of(scene).unwrap();
    let held = E * 12e-6 * 50.0;
    for force in solved.state().ties[0].force.iter().flatten() {
        assert!(force.abs() < 1e-9 * held, "{force} of {held}");
    }
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
