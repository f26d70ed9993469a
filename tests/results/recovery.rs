use crate::block::{add_block, close, fill_stress, pressed, settle, stack};
use brinell::answer::results::edges::{ByEdge, LoadedEdges, SingularEdges};
use brinell::answer::results::peaks::{Place, peaks};
use brinell::answer::results::recovery::recover;
use brinell::answer::results::strain::largest_strain;
use brinell::answer::results::tensor::mises;
use brinell::model::mesh::Mesh;
use brinell::model::scene::{Scene, Support};
use brinell::model::state::State;

/// A stress field that is trilinear in position, and symmetric about x = 0 and y = 0: exactly
/// recovered on boxes.
fn trilinear(p: [f64; 3]) -> [f64; 6] {
    let [x, y, z] = p;
    [
        10.0 + x,
        2.0 * y - 3.0 * x * z,
        -40.0 + 5.0 * z,
        0.5 * x * y,
        y * (1.0 + z),
        x * y * z,
    ]
}

#[test]
fn a_trilinear_stress_is_recovered_at_every_node() {
    let scene = stack();
    let mut state = pressed(&scene);
    fill_stress(&scene, &mut state, trilinear);
    let recovered = recover(&scene, &state);
    assert_eq!(recovered.nodal_stress.len(), scene.mesh.points.len());
    for (stress, point) in recovered.nodal_stress.iter().zip(&scene.mesh.points) {
        stress
            .iter()
            .zip(trilinear(*point))
            .for_each(|(a, b)| close(*a, b));
    }
    for (m, stress) in recovered.mises_nodal.iter().zip(&recovered.nodal_stress) {
        close(*m, mises(stress));
    }
    for (e, mean) in recovered.mises_mean.iter().enumerate() {
        let corners = scene.mesh.corners(e);
        let middle = [0, 1, 2].map(|i| corners.iter().map(|c| c[i]).sum::<f64>() / 8.0);
        close(*mean, mises(&trilinear(middle)));
        assert!(recovered.mises_max[e] > *mean);
    }
}

#[test]
fn volumes_are_those_of_the_bodies() {
    let scene = stack();
    let recovered = recover(&scene, &pressed(&scene));
    let of_body = |b: usize| -> f64 {
        scene.mesh.bodies[b]
            .elements
            .clone()
            .flat_map(|e| recovered.volumes[e])
            .sum()
    };
    close(of_body(0), 0.5);
    close(of_body(1), 1.5);
}

#[test]
fn stresses_are_not_averaged_across_bodies_that_share_nodes() {
    let mut mesh = Mesh::default();
    add_block(
        &mut mesh,
        "left",
        [&[0.0, 1.0], &[0.0, 1.0], &[0.0, 1.0]],
        |p| p,
    );
    add_block(
        &mut mesh,
        "right",
        [&[1.0, 2.0], &[0.0, 1.0], &[0.0, 1.0]],
        |p| p,
    );
    // Glue: the left nodes of the right body become the right nodes of the left one.
    for (from, to) in [(8, 1), (10, 3), (12, 5), (14, 7)] {
        mesh.hexes[1]
            .iter_mut()
            .filter(|n| **n == from)
            .for_each(|n| *n = to);
    }
    let scene = Scene { mesh, ..stack() };
    let state = State {
        stress: vec![
            [[7.0, 0.0, 0.0, 0.0, 0.0, 0.0]; 8],
            [[0.0, 3.0, 0.0, 0.0, 0.0, 0.0]; 8],
        ],
        ..State::default()
    };
    let recovered = recover(&scene, &state);
    assert_eq!(recovered.points.node.len(), 20);
    assert_eq!(recovered.points.node[16..], [1, 3, 5, 7]);
    assert_eq!(recovered.points.body_of(16), Some(1));
    assert_eq!(recovered.points.body_of(8), None);
    for point in 0..20 {
        let expected = match recovered.points.body_of(point) {
            Some(0) => 7.0,
            Some(_) => 3.0,
            None => 0.0,
        };
        close(recovered.mises_nodal[point], expected);
    }
}

/// A uniaxial stress that is a parabola in x: at the node of the peak the average is above it by 2 c h²/12, which is found;
/// and so is how much higher its vertex is. On a mirror plane half of it tells as much, beside a shear that turns its sign there.
#[test]
fn averages_at_nodes_overshoot_a_parabola_by_a_twelfth_of_its_curvature() {
    let (fall, size) = (40.0, 0.3);
    for (x, mirrors, vertex) in [
        (vec![-0.6, -0.3, 0.0, 0.3, 0.6], vec![], 0.05),
        (vec![0.0, 0.3, 0.6], vec![0], 0.0),
    ] {
        let mut mesh = Mesh::default();
        add_block(&mut mesh, "block", [&x, &[0.0, 1.0], &[0.0, 1.0]], |p| p);
        let scene = Scene {
            mirrors,
            ..Scene::bare("parabola", mesh, stack().materials[0])
        };
        let mut state = State {
            stress: vec![[[0.0; 6]; 8]; scene.mesh.hexes.len()],
            peeq: vec![[0.0; 8]; scene.mesh.hexes.len()],
            ..State::default()
        };
        let stress = |x: f64| 100.0 - fall * (x - vertex).powi(2);
        fill_stress(&scene, &mut state, |p| {
            let shear = if scene.mirrors.is_empty() {
                0.0
            } else {
                10.0 * p[0]
            };
            [0.0, 0.0, stress(p[0]), 0.0, 0.0, shear]
        });
        let recovered = recover(&scene, &state);
        let found = peaks((&scene, &state), &recovered, &SingularEdges::default(), &[]);
        let (peak, around) = (found[0].nodal.unwrap(), found[0].around);
        assert_eq!(peak.at[0], 0.0);
        close(around.curvature.overshoot, fall * size * size / 6.0);
        close(peak.value - around.curvature.overshoot, stress(0.0));
        close(1.0 + around.curvature.vertex, 1.0 + 100.0 - stress(0.0));
    }
}

#[test]
fn peaks_are_found_per_body_and_ties_go_to_the_lowest_index() {
    let scene = stack();
    let mut state = pressed(&scene);
    fill_stress(&scene, &mut state, |_| [0.0, 0.0, -50.0, 0.0, 0.0, 0.0]);
    let third = scene.mesh.bodies[1].elements.start + 2;
    state.stress[third][5] = [0.0, 0.0, -130.0, 0.0, 0.0, 0.0];
    state.peeq[third][5] = 1e-3;
    state.peeq[third][6] = 2e-3;
    let recovered = recover(&scene, &state);
    let [block, plate] = peaks((&scene, &state), &recovered, &SingularEdges::default(), &[])
        .try_into()
        .unwrap();
    assert_eq!(block.name, "block");
    assert_eq!(block.centroid.map(|p| p.place), Some(Place::Element(0)));
    let first = Place::IntegrationPoint {
        element: 0,
        point: 0,
    };
    assert_eq!(block.integration_point.map(|p| p.place), Some(first));
    close(block.centroid.unwrap().value, 50.0);
    assert_eq!(block.yielded_volume, 0.0);
    close(block.volume, 4.0 * 0.5);
    let peak = plate.integration_point.unwrap();
    assert_eq!(
        peak.place,
        Place::IntegrationPoint {
            element: third,
            point: 5
        }
    );
    assert_eq!(peak.element(), Some(third));
    close(peak.value, 130.0);
    close(plate.centroid.unwrap().value, 60.0);
    close(plate.peeq_max, 2e-3);
    // Two of eight points of an element 0.4 x 0.8 x 0.6, four times for the quarter model.
    close(plate.yielded_volume, 4.0 * 0.4 * 0.8 * 0.6 * 2.0 / 8.0);
    let node = plate.nodal.unwrap();
    assert!(matches!(node.place, Place::Node(n) if scene.mesh.points[n] == node.at));
}

#[test]
fn the_largest_strain_is_principal() {
    let scene = stack();
    let mut displacement = vec![[0.0; 3]; scene.mesh.points.len()];
    for (u, [_, y, z]) in displacement.iter_mut().zip(&scene.mesh.points) {
        // Pure shear of 0.03 beside a stretch of 0.01.
        *u = [0.01 * u[0], 0.03 * z, 0.03 * y];
    }
    let (strain, _) = largest_strain(&scene.mesh, &displacement).unwrap();
    close(strain, 0.03);
}

#[test]
fn a_rotation_is_no_strain() {
    let scene = stack();
    let turn = |[x, y, _]: &[f64; 3]| [-1e-3 * y, 1e-3 * x, 0.0];
    let displacement: Vec<[f64; 3]> = scene.mesh.points.iter().map(turn).collect();
    let (strain, _) = largest_strain(&scene.mesh, &displacement).unwrap();
    assert!(strain < 1e-15);
}

#[test]
fn a_peak_beside_a_loaded_edge_is_known_on_both_bodies() {
    let mut scene = stack();
    // A square block on a larger plate is singular along its edges at x = 0.5 and y = 1.
    let mut state = pressed(&scene);
    let all = recover(&scene, &state);
    let touches =
        |scene: &brinell::model::scene::Scene, state: &State, at: [f64; 3], body: usize| {
            let mut stress = state.clone();
            fill_stress(scene, &mut stress, |p| {
                let d: f64 = (0..3).map(|i| (p[i] - at[i]).powi(2)).sum();
                [100.0 / (0.01 + d), 0.0, 0.0, 0.0, 0.0, 0.0]
            });
            let recovered = recover(scene, &stress);
            let edges = SingularEdges::find(scene, state);
            let peak = peaks((scene, &stress), &recovered, &edges, &[])[body]
                .nodal
                .unwrap();
            edges.are_near(&peak.at)
        };
    assert!(touches(&scene, &state, [0.5, 1.0, 0.0], 0));
    assert!(touches(&scene, &state, [0.4, 0.7, 0.0], 1));
    assert!(!touches(&scene, &state, [0.0, 0.0, 1.0], 0));
    // Without pressure at the edge there is nothing singular; mirror planes are no edges.
    let field = &mut state.contacts[0];
    for (node, p) in field.nodes.iter().zip(&mut field.pressure) {
        let [x, y, _] = scene.mesh.points[*node as usize];
        *p *= f64::from(u8::from(x < 0.4 && y < 0.9));
    }
    settle(field);
    assert!(LoadedEdges::find(&scene, &state).is_empty());
    scene.mirrors.clear();
    assert!(!LoadedEdges::find(&scene, &state).is_empty());
    assert_eq!(all.mises_max.len(), scene.mesh.hexes.len());
}

/// A bar of `elements` a unit of length along x from `from` to 1, on another one as long, both 0.01 wide and thick and with
/// their sides held; pressed together everywhere, so that the edges are loaded at its ends alone.
fn bar(from: f64, elements: usize) -> (Scene, State) {
    let count = ((1.0 - from) * elements as f64).round() as usize;
    let along: Vec<f64> = (0..=count)
        .map(|i| from + (1.0 - from) * i as f64 / count as f64)
        .collect();
    let mut scene = stack();
    scene.mesh = Mesh::default();
    add_block(
        &mut scene.mesh,
        "block",
        [&along, &[0.0, 0.01], &[0.0, 0.01]],
        |p| p,
    );
    add_block(
        &mut scene.mesh,
        "plate",
        [&along, &[0.0, 0.01], &[-0.01, 0.0]],
        |p| p,
    );
    scene.mirrors = if from == 0.0 { vec![0] } else { vec![] };
    for side in ["block_v-", "block_v+", "plate_v-", "plate_v+"] {
        scene.supports.push(Support {
            name: side.to_string(),
            surface: side.to_string(),
            components: [None, Some(0.0), None],
            ..Support::default()
        });
    }
    let state = pressed(&scene);
    (scene, state)
}

#[test]
fn what_is_beside_an_edge_is_as_long_in_the_half_as_in_the_whole() {
    // A fiftieth of the length of 2, and more than the diagonal of a face, 0.014.
    for (from, elements) in [(0.0, 100), (-1.0, 100)] {
        let (scene, state) = bar(from, elements);
        let edges = SingularEdges::find(&scene, &state);
        let near = |x: f64| edges.are_near(&[x, 0.0, 0.0]);
        assert!(near(0.961) && !near(0.959), "from {from}");
        assert!(!near(0.0));
    }
}

#[test]
fn a_peak_elsewhere_is_not_the_largest_where_an_edge_presses() {
    let (scene, mut state) = bar(0.0, 100);
    fill_stress(&scene, &mut state, |p| {
        let hump = (-(10.0 * (p[0] - 0.5)).powi(2)).exp();
        [100.0 * hump, 0.0, 0.0, 0.0, 0.0, 0.0]
    });
    let by_edge = |state: &State| {
        let edges = SingularEdges::find(&scene, state);
        let bodies = peaks((&scene, state), &recover(&scene, state), &edges, &[]);
        let by_edge = bodies.iter().map(|body| body.away.map(|(by, _)| by));
        by_edge.collect::<Vec<_>>()
    };
    let press = |state: &mut State, share: &dyn Fn(f64) -> f64| {
        let field = &mut state.contacts[0];
        for (node, p) in field.nodes.iter().zip(&mut field.pressure) {
            *p *= share(scene.mesh.points[*node as usize][0]);
        }
    };
    // An even pressure is that of blocks of one size.
    assert_eq!(by_edge(&state), [None; 2]);
    press(&mut state, &|x| if x > 0.995 { 1.5 } else { 1.0 });
    assert_eq!(by_edge(&state), [Some(ByEdge::OnFinerMeshes); 2]);
    // What is light at the edge makes no large stress there.
    press(&mut state, &|x| if x > 0.995 { 0.1 } else { 1.0 });
    assert_eq!(by_edge(&state), [None; 2]);
}

#[test]
fn a_peak_at_the_border_of_what_is_beside_an_edge_is_doubted() {
    let (scene, mut state) = bar(0.0, 100);
    let peak = |state: &State| {
        let edges = SingularEdges::find(&scene, state);
        let block = peaks((&scene, state), &recover(&scene, state), &edges, &[]).swap_remove(0);
        let (by, away) = block.away.unwrap();
        assert_eq!(by, ByEdge::Here);
        away
    };
    fill_stress(&scene, &mut state, |p| {
        [100.0 * p[0], 0.0, 0.0, 0.0, 0.0, 0.0]
    });
    let rising = peak(&state);
    // The node farthest from the pressed face of those at x = 0.96 is just not beside the edge; its elements reach to 0.97.
    assert!((rising.nodal.at[0] - 0.96).abs() < 1e-9);
    let border = rising.around.border;
    assert!((border - 100.0 * (0.97 - 0.96)).abs() < 1e-9, "{border}");
    // A hump far from the edge is not doubted.
    fill_stress(&scene, &mut state, |p| {
        let hump = (-(10.0 * (p[0] - 0.5)).powi(2)).exp();
        [
            100.0 * hump + if p[0] > 0.97 { 200.0 } else { 0.0 },
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ]
    });
    let hump = peak(&state);
    assert!((hump.nodal.at[0] - 0.5).abs() < 0.006);
    assert_eq!(hump.around.border, 0.0);
}

#[test]
fn a_state_of_another_scene_is_refused_by_name() {
    let scene = stack();
    let mut state = pressed(&scene);
    assert_eq!(state.check(&scene), Ok(()));
    state.contacts[0].gap.pop();
    let misfit = state.check(&scene).unwrap_err();
    assert_eq!(misfit.what, "gap of block-plate");
    state.contacts.clear();
    assert_eq!(state.check(&scene).unwrap_err().what, "contacts");
}
