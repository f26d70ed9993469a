use crate::block::{close, pressed, stack};
use brinell::answer::results::dent::dent;

#[test]
fn a_rigid_motion_leaves_no_dent() {
    let mut scene = stack();
    scene.mirrors.clear();
    let mut state = pressed(&scene);
    for (u, [x, y, z]) in state.displacement.iter_mut().zip(&scene.mesh.points) {
        *u = [1.0 - 1e-3 * y + 2e-3 * z, 2.0 + 1e-3 * x, -3.0 - 2e-3 * x];
    }
    let surface = scene.mesh.surface("plate_w+").unwrap();
    assert!(
        dent(&scene, &state.displacement, 1, surface)
            .unwrap()
            .depth
            .abs()
            < 1e-14
    );
}

#[test]
fn a_node_pressed_in_is_the_dent() {
    let scene = stack();
    let mut state = pressed(&scene);
    let at = [0.0, 0.7, 0.0];
    let place = scene.mesh.points.iter().rposition(|p| *p == at).unwrap();
    let surface = scene.mesh.surface("plate_w+").unwrap();
    state.displacement.iter_mut().for_each(|u| u[2] = -0.25);
    state.displacement[place][2] -= 1e-3;
    let found = dent(&scene, &state.displacement, 1, surface).unwrap();
    assert_eq!(found.at, at);
    // The body's best fit follows the node by its share of the volume: two elements of
    // 0.4 x 0.4 by 0.7 and 0.8, each an eighth; no turn, by symmetry.
    let share = 0.4 * 0.4 * 1.5 / 8.0 / 1.5;
    close(found.depth, 1e-3 * (1.0 - share));
}
