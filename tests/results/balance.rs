use crate::block::{close, pressed, stack};
use brinell::answer::results::balance::{balances, centre_of_force};

#[test]
fn bodies_that_something_holds_need_no_balance() {
    let scene = stack();
    assert!(balances(&scene, &pressed(&scene)).is_empty());
}

#[test]
fn mirrors_double_forces_and_cancel_moments() {
    let mut scene = stack();
    scene.rigid_planes.clear();
    let [block] = balances(&scene, &pressed(&scene)).try_into().unwrap();
    assert_eq!(block.body, "block");
    assert_eq!(block.force[..2], [0.0, 0.0]);
    close(block.force[2], 65.0);
    assert_eq!(block.moment, [0.0; 3]);
}

#[test]
fn moments_are_about_the_middle_of_the_body() {
    let mut scene = stack();
    scene.rigid_planes.clear();
    scene.mirrors.clear();
    let state = pressed(&scene);
    let [block] = balances(&scene, &state).try_into().unwrap();
    let [_, y, z] = block.force;
    close(y, -1.625);
    close(z, 16.25);
    // Pressure acts at (0.25, 0.5, 0); the mean of the elements' nodes is (0.25, 0.4, 0.5).
    close(block.moment[0], 0.1 * z + 0.5 * y);
    assert!(block.moment[1].abs() < 1e-12 && block.moment[2].abs() < 1e-12);
    let centre = centre_of_force(&scene, &state, 0).unwrap();
    close(centre[0], 0.25);
    close(centre[1], 0.5);
}

#[test]
fn without_pressure_there_is_no_centre() {
    let scene = stack();
    let mut state = pressed(&scene);
    state.contacts[0].force.fill([0.0; 3]);
    assert_eq!(centre_of_force(&scene, &state, 0), None);
}
