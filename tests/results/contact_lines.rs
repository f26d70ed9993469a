use crate::block::{along, close, pressed, settle, stack};
use brinell::answer::results::contact_lines::contact_lines;
use brinell::answer::results::edges::LoadedEdges;
use brinell::answer::results::hertz::HeaviestLine;
use brinell::answer::results::line_frame::LineFrame;
use brinell::answer::results::strip_profile::strip_profile;
use brinell::model::scene::Support;

#[test]
fn a_line_cut_by_a_mirror_is_one_and_whole() {
    let scene = stack();
    let [line] = contact_lines(&scene, &pressed(&scene), 0, &along(&scene, 1))
        .try_into()
        .unwrap();
    assert_eq!((line.across, line.images), (0.0, 1));
    assert_eq!(line.at, [0.0, 0.2, 0.5, 1.0]);
    // 32.5 over the whole width of 1.
    line.load.iter().for_each(|load| close(*load, 32.5));
    close(line.mean(), 32.5);
    close(line.length, 2.0);
    close(line.lifted_off, 0.0);
}

/// The same half, moved and turned over: supports hold its plane, and `symmetry` says nothing.
#[test]
fn a_line_cut_by_a_plane_that_supports_make_is_whole_too() {
    for (sign, offset) in [(1.0, 0.0), (1.0, 37.0), (-1.0, 0.0), (-1.0, -5.0)] {
        let mut scene = stack();
        let state = pressed(&scene);
        scene.mirrors = vec![1];
        let slides = |surface: &str| Support {
            surface: surface.to_string(),
            components: [Some(0.0), None, None],
            ..Support::default()
        };
        (scene.supports).extend(["block_u-", "plate_u-"].map(slides));
        (scene.mesh.points.iter_mut()).for_each(|point| point[0] = sign * point[0] + offset);
        let [line] = contact_lines(&scene, &state, 0, &along(&scene, 1))
            .try_into()
            .unwrap();
        assert_eq!((line.across, line.images), (offset, 1));
        line.load.iter().for_each(|load| close(*load, 32.5));
        assert!(line.heaviest.mirrored && !line.heaviest.is_cut());
        assert!(
            line.heaviest.nodes[0].0.abs() < 1e-12,
            "outwards from the plane"
        );
        let profile = strip_profile(&scene, &state, 0, &along(&scene, 1), &line).unwrap();
        let (first, last) = (profile.points[0].0, profile.points.last().unwrap().0);
        close(first, -last);
        // A plane that one of both bodies only ends at is none; nor is one that is held along itself.
        for (body, held) in [("none", None), ("plate_u-", Some(0.0))] {
            let mut other = scene.clone();
            (other.supports[2].surface, other.supports[2].components[2]) = (body.to_string(), held);
            let [line] = contact_lines(&other, &state, 0, &along(&other, 1))
                .try_into()
                .unwrap();
            assert!(!line.heaviest.mirrored);
            line.load.iter().for_each(|load| close(*load, 16.25));
        }
    }
}

#[test]
fn a_line_beside_the_mirror_is_two_and_may_lift_off() {
    let scene = stack();
    let mut state = pressed(&scene);
    let field = &mut state.contacts[0];
    for (node, pressure) in field.nodes.iter().zip(&mut field.pressure) {
        let [x, y, _] = scene.mesh.points[*node as usize];
        if x < 0.4 || y > 0.9 {
            *pressure = 0.0;
        }
    }
    settle(&mut state.contacts[0]);
    let [line] = contact_lines(&scene, &state, 0, &along(&scene, 1))
        .try_into()
        .unwrap();
    assert_eq!((line.across, line.images), (0.5, 2));
    assert!(!line.is_parted);
    // The node at the rim stands for 0.125 of the width.
    (line.load[..3].iter()).for_each(|load| close(*load, 0.125 * 32.5));
    assert_eq!(line.load[3], 0.0);
    close(line.length, 1.5);
    close(line.lifted_off, 0.5);
    let (peak, at) = line.peak().unwrap();
    close(peak, 0.125 * 32.5);
    assert!(at < 0.6);
    close(line.mean(), 0.75 * peak);
    // Even loads on rows at 0, 0.2 and 0.5, which stand for 0.1, 0.25 and 0.4: about 1/3.
    close(line.middle().unwrap(), 0.5);
    close(
        line.spread().unwrap(),
        (0.1 / 3.0 + 0.25 * 0.4 / 3.0 + 0.4 / 6.0) / 0.75,
    );
}

#[test]
fn two_lines_with_open_nodes_between_are_told_apart() {
    let mut scene = stack();
    scene.mirrors.clear();
    let mut state = pressed(&scene);
    let field = &mut state.contacts[0];
    for (node, pressure) in field.nodes.iter().zip(&mut field.pressure) {
        let [x, y, _] = scene.mesh.points[*node as usize];
        // Along x: rows of four nodes, of which the second is open.
        if (y - 0.2).abs() < 1e-9 {
            *pressure = 0.0;
        } else {
            *pressure *= 1.0 + x;
        }
    }
    settle(&mut state.contacts[0]);
    let lines = contact_lines(&scene, &state, 0, &along(&scene, 0));
    let across: Vec<f64> = lines.iter().map(|l| l.across).collect();
    assert_eq!(across.len(), 2);
    assert!(across[0] == 0.0 && across[1] > 0.5);
    assert!(lines.iter().all(|line| line.is_parted));
    assert_eq!(lines[0].peak().unwrap().1, 0.5);
    assert_eq!(LineFrame::of_axis(&scene, 2), None);
}

#[test]
fn nodes_on_the_far_side_of_a_roller_part_no_line() {
    let scene = stack();
    let mut state = pressed(&scene);
    // As if the middle row of nodes lay on the other side of a roller.
    let field = &mut state.contacts[0];
    for (i, node) in field.nodes.iter().enumerate() {
        if (scene.mesh.points[*node as usize][0] - 0.25).abs() < 1e-9 {
            (field.pressure[i], field.gap[i]) = (0.0, f64::INFINITY);
        }
    }
    let [line] = contact_lines(&scene, &state, 0, &along(&scene, 1))
        .try_into()
        .unwrap();
    assert_eq!((line.across, line.images), (0.0, 1));
    line.load.iter().for_each(|load| close(*load, 0.5 * 32.5));
}

/// Rows at 0, 0.55, 0.6 and 1, all but the first so near to the end of the block that they belong to it.
#[test]
fn a_single_row_away_from_edges_stands_out_from_the_row_beside_it() {
    let mut scene = stack();
    for [_, y, _] in &mut scene.mesh.points {
        *y = match *y {
            0.2 => 0.55,
            0.5 => 0.6,
            other => other,
        };
    }
    let mut state = pressed(&scene);
    let field = &mut state.contacts[0];
    for (node, pressure) in field.nodes.iter().zip(&mut field.pressure) {
        let [x, y, _] = scene.mesh.points[*node as usize];
        *pressure *= if x > 0.3 { 0.0 } else { 1.0 - 0.3 * y };
    }
    settle(&mut state.contacts[0]);
    let edges = LoadedEdges::find(&scene, &state);
    let near = [0.0, 0.55, 0.6].map(|y| edges.are_near(&[0.0, y, 0.0]));
    assert_eq!(near, [false, true, true]);
    let line = HeaviestLine::find(&scene, &state, 0, &edges).unwrap();
    assert_eq!(line.line.heaviest.at, 0.0);
    assert!((line.kink - 0.3 * 0.55).abs() < 1e-9, "{}", line.kink);
}
