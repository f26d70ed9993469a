//! Ties beside supports, mirror planes and contact, and what is refused.

use super::*;
use brinell::model::mesh::{Face, Surface};

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
            _ => found.next_back(),
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

/// Two cubes, one upon the other; 3 and 4 elements along each side.
fn cubes() -> SceneBuilder {
    let side = |n| uniform(0.0, 1.0, n);
    SceneBuilder::new("cubes")
        .body(Block::new("a", side(3), side(3), side(3)), steel())
        .body(
            Block::new("b", side(4), side(4), uniform(1.0, 2.0, 3)),
            steel(),
        )
        .tie(Tie::between("a_z_max", "b_z_min"))
}

#[test]
fn where_a_support_holds_the_facets_of_one_side_the_other_side_follows() {
    // The finer side would follow; held, it is what the coarser one hangs on.
    let scene = cubes()
        .support(linear("b_z_min"))
        .support(linear("a_z_min"));
    let solved = Solved::of(scene.build().unwrap()).unwrap();
    assert_eq!(solved.state().ties[0].follows, 0);
    let mesh = &solved.scene.mesh;
    for node in mesh.surface("a_z_max").unwrap().nodes() {
        let (x, u) = (
            mesh.points[node as usize],
            solved.state().displacement[node as usize],
        );
        for i in 0..3 {
            let exact: f64 = (0..3).map(|j| GRADIENT[i][j] * x[j]).sum();
            assert!((u[i] - exact).abs() < 1e-12, "{x:?}: {u:?}");
        }
    }
}

#[test]
fn where_supports_hold_facets_of_both_sides_nothing_can_be_tied() {
    let mut scene = cubes().fix("a_z_min").build().unwrap();
    // A strip of either surface, on either side.
    for (whole, part, left) in [("a_z_max", "left", true), ("b_z_min", "right", false)] {
        let faces = scene.mesh.surface(whole).unwrap().faces.clone();
        let points = &scene.mesh.points;
        let inside = |face: &&Face| {
            let x = |n: &u32| points[*n as usize][0];
            face.nodes.iter().all(|n| (x(n) < 0.4) == left)
        };
        let faces: Vec<Face> = faces.iter().filter(inside).copied().collect();
        assert!(!faces.is_empty());
        scene.mesh.surfaces.push(Surface {
            name: part.into(),
            faces,
        });
        scene.supports.push(Support {
            components: [Some(0.0), None, None],
            gradient: [[0.0; 3]; 3],
            ..linear(part)
        });
    }
    let said = Solved::of(scene).map(|_| ()).unwrap_err();
    let said = said.to_string();
    assert!(
        said.contains("along x") && said.contains("nothing is left to tie"),
        "{said}"
    );
    // Plane strain holds both sides alike: there is nothing to tie along that axis, and nothing wrong.
    let thin = |n| uniform(0.0, 1.0, n);
    let scene = SceneBuilder::new("strip")
        .body(Block::new("a", thin(3), thin(1), thin(2)), steel())
        .body(
            Block::new("b", thin(4), thin(1), uniform(1.0, 2.0, 2)),
            steel(),
        )
        .tie(Tie::between("a_z_max", "b_z_min"))
        .plane_strain(Axis::Y)
        .fix("a_z_min")
        .load(Load::pressure("b_z_max", 1.0));
    assert!(Solved::of(scene.build().unwrap()).is_ok());
}

#[test]
fn what_is_tied_is_not_in_contact() {
    let scene = cubes()
        .fix("a_z_min")
        .contact(Contact::between("b_z_min", "a_z_max"))
        .load(Load::pressure("b_z_max", 1.0));
    let said = Solved::of(scene.build().unwrap()).map(|_| ()).unwrap_err();
    let said = said.to_string();
    assert!(
        said.contains("`a_z_max-b_z_min`") && said.contains("`b_z_min-a_z_max`"),
        "{said}"
    );
}
