use crate::block::{along, close, fill_stress, pressed, settle, stack};
use brinell::answer::results::contact_lines::contact_lines;
use brinell::answer::results::depth::mises_along;
use brinell::answer::results::recovery::recover;
use brinell::answer::results::strip_profile::strip_profile;

#[test]
fn half_a_strip_is_written_out_whole_and_ends_at_open_nodes() {
    let scene = stack();
    let mut state = pressed(&scene);
    let field = &mut state.contacts[0];
    for (node, pressure) in field.nodes.iter().zip(&mut field.pressure) {
        let [x, y, _] = scene.mesh.points[*node as usize];
        *pressure = (40.0 - 80.0 * x) * (2.0 - y);
    }
    settle(field);
    // Open nodes have no gap where nothing is within reach.
    for (gap, pressure) in field.gap.iter_mut().zip(&field.pressure) {
        if *pressure == 0.0 {
            *gap = f64::INFINITY;
        }
    }
    let [line] = contact_lines(&scene, &state, 0, &along(&scene, 1))
        .try_into()
        .unwrap();
    let profile = strip_profile(&scene, &state, 0, &along(&scene, 1), &line).unwrap();
    assert_eq!(profile.at, 0.0);
    let expected = [
        (-0.5, 0.0),
        (-0.25, 40.0),
        (0.0, 80.0),
        (0.25, 40.0),
        (0.5, 0.0),
    ];
    assert_eq!(profile.points.len(), expected.len());
    for ((s, p), (x, q)) in profile.points.iter().zip(expected) {
        close(*s, x);
        close(*p, q);
    }
    // The carrier is the underside of the upper block.
    assert_eq!(
        (profile.centre, profile.normal),
        ([0.0; 3], [0.0, 0.0, -1.0])
    );
}

#[test]
fn a_line_into_a_body_reads_the_stress_between_its_elements() {
    let scene = stack();
    let mut state = pressed(&scene);
    fill_stress(&scene, &mut state, |[x, _, z]| {
        [0.0, 0.0, -40.0 - 5.0 * z - x, 0.0, 0.0, 0.0]
    });
    let recovered = recover(&scene, &state);
    let up = [0.0, 0.0, 1.0];
    // Along an edge of the mesh, and inside elements.
    for x in [0.0, 0.1] {
        let read = mises_along(&scene, &recovered, 0, ([x, 0.1, 0.0], up), 2.0);
        let depths: Vec<f64> = read.iter().map(|r| r.0).collect();
        assert_eq!(depths, [0.0, 0.5, 1.0]);
        read.iter()
            .for_each(|(z, mises)| close(*mises, 40.0 + 5.0 * z + x));
    }
    assert!(mises_along(&scene, &recovered, 0, ([9.0, 0.0, 0.0], up), 2.0).is_empty());
    assert!(mises_along(&scene, &recovered, 7, ([0.0; 3], up), 2.0).is_empty());
}
