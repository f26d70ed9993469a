use crate::block::{close, pressed, settle, stack};
use brinell::answer::results::interface::interfaces;
use brinell::answer::results::line_load::{Slices, line_load};
use brinell::answer::results::load;
use brinell::answer::results::strip::{Strip, half_width};
use brinell::model::scene::{PlaneMotion, Step, Traction, TractionValue};
use brinell::model::state::ContactField;

#[test]
fn the_whole_bearing_carries_the_load() {
    let scene = stack();
    let mut state = pressed(&scene);
    state.contacts[0].gap[3] = -4e-5;
    state.contacts[0].gap[4] = f64::INFINITY;
    state.contacts[0].status[0] = 2;
    let [interface] = interfaces(&scene, &state).try_into().unwrap();
    assert_eq!(interface.name, "block-plate");
    // The tangential force along y is cancelled by the mirrored quarters.
    assert_eq!(interface.force[..2], [0.0, 0.0]);
    close(interface.force[2], -65.0);
    close(interface.normal_force, 65.0);
    close(interface.pressure_integral, 65.0);
    close(interface.area, 2.0);
    close(interface.max_pressure, 32.5);
    assert_eq!(interface.max_pressure_at, Some([0.0, 0.0, 0.0]));
    assert_eq!(interface.max_penetration, 1e-6);
    assert_eq!(interface.contact_error, 4e-5);
    let counts = interface.status_counts;
    assert_eq!((counts.open, counts.stick, counts.slip), (0, 11, 1));
    assert_eq!(interface.coulomb_violation, 0.0);
    close(interface.face_side.unwrap(), 0.2);
}

#[test]
fn traction_beyond_friction_is_seen() {
    let scene = stack();
    let mut state = pressed(&scene);
    state.contacts[0].traction[2] = [0.2 * 32.5, 0.0, 0.0];
    let [interface] = interfaces(&scene, &state).try_into().unwrap();
    close(interface.coulomb_violation, 0.05 / 0.15);
}

#[test]
fn without_mirrors_the_friction_is_kept() {
    let mut scene = stack();
    scene.mirrors.clear();
    let [interface] = interfaces(&scene, &pressed(&scene)).try_into().unwrap();
    close(interface.force[1], 0.1 * 65.0 / 4.0);
    close(interface.normal_force, 65.0 / 4.0);
}

#[test]
fn an_even_line_load_is_even_in_slices_that_cut_elements() {
    let scene = stack();
    let state = pressed(&scene);
    let slices = Slices {
        along: [0.0, 1.0, 0.0],
        edges: vec![0.0, 0.13, 0.31, 0.77, 1.0],
    };
    let load = line_load(&scene, &state, 0, &slices).unwrap();
    assert!(load.mirrored);
    load.q.iter().for_each(|q| close(*q, 32.5));
    assert!(load.outside.abs() < 1e-12);
}

#[test]
fn slices_and_what_lies_outside_sum_to_the_load() {
    let mut scene = stack();
    let mut state = pressed(&scene);
    for (i, force) in state.contacts[0].force.iter_mut().enumerate() {
        force[2] *= 1.0 + (i as f64).sin();
    }
    let slices = Slices {
        along: [0.0, 1.0, 0.0],
        edges: vec![0.1, 0.3, 0.8],
    };
    for (mirrors, doubled) in [(vec![0, 1], 2.0), (vec![0], 1.0), (vec![], 1.0)] {
        scene.mirrors = mirrors;
        let load = line_load(&scene, &state, 0, &slices).unwrap();
        let sum = load.q[0] * 0.2 + load.q[1] * 0.5 + load.outside;
        close(doubled * sum, interfaces(&scene, &state)[0].normal_force);
        assert_eq!(load.mirrored, doubled == 2.0);
    }
    let backwards = Slices {
        along: [0.0, 1.0, 0.0],
        edges: vec![0.3, 0.1],
    };
    assert_eq!(line_load(&scene, &state, 0, &backwards), None);
}

#[test]
fn equal_slices_lie_along_the_longer_side() {
    let slices = Slices::equal(&stack(), 0, 4).unwrap();
    assert_eq!(
        slices,
        Slices {
            along: [0.0, 1.0, 0.0],
            edges: vec![0.0, 0.25, 0.5, 0.75, 1.0]
        }
    );
}

#[test]
fn half_widths_are_integrated_in_the_hat_basis() {
    let scene = stack();
    let mut field = pressed(&scene).contacts.remove(0);
    let surface = scene.mesh.surface("block_w-").unwrap();
    let width = |field: &ContactField, strip: &Strip| {
        half_width(&scene.mesh, surface, field, strip).unwrap()
    };
    let cut = Strip {
        middle: Some(0.0),
        ..Strip::across(0)
    };
    // Even over |x| < 0.5.
    close(width(&field, &cut), 2.0 * (0.25f64 / 3.0).sqrt());
    // The modelled half alone, about its own centre.
    close(
        width(&field, &Strip::across(0)),
        2.0 * (0.0625f64 / 3.0).sqrt(),
    );
    // A hat over |x| < 0.25.
    for (node, p) in field.nodes.iter().zip(&mut field.pressure) {
        *p = f64::from(u8::from(scene.mesh.points[*node as usize][0] == 0.0));
    }
    settle(&mut field);
    close(width(&field, &cut), 2.0 * (0.0625f64 / 6.0).sqrt());
    let mut part = cut;
    part.within[1] = (0.2, 1.0);
    close(width(&field, &part), 2.0 * (0.0625f64 / 6.0).sqrt());
    field.pressure.fill(0.0);
    settle(&mut field);
    assert_eq!(half_width(&scene.mesh, surface, &field, &cut), None);
}

#[test]
fn the_load_follows_the_steps() {
    let mut scene = stack();
    let mut state = pressed(&scene);
    let unload = Step::to("unload", 0.001);
    scene.steps.push(unload);
    state.time = 0.5;
    close(load::applied(&scene, &state), 32.5);
    (state.step, state.time) = (1, 1.0);
    close(load::applied(&scene, &state), 0.065);
    assert_eq!(load::direction(&scene), [0.0, 0.0, -1.0]);
    close(load::descent(&scene, &state).unwrap(), 0.01);
}

#[test]
fn pressure_on_a_surface_is_a_load() {
    let mut scene = stack();
    scene.rigid_planes[0].motion[2] = PlaneMotion::Free;
    scene.tractions.push(Traction {
        name: "pressure".to_string(),
        surface: "block_w+".to_string(),
        value: TractionValue::Pressure(10.0),
    });
    let mut state = pressed(&scene);
    close(load::applied(&scene, &state), 4.0 * 10.0 * 0.5);
    assert_eq!(load::direction(&scene), [0.0, 0.0, -1.0]);
    // The travel of the surface that it acts on.
    for node in scene.mesh.surface("block_w+").unwrap().nodes() {
        state.displacement[node as usize][2] = -0.01;
    }
    close(load::descent(&scene, &state).unwrap(), 0.01);
}

#[test]
fn a_prescribed_motion_loads_by_its_force() {
    let mut scene = stack();
    scene.rigid_planes[0].motion[2] = PlaneMotion::Held(-0.01);
    let state = pressed(&scene);
    close(load::applied(&scene, &state), 65.0);
    close(load::descent(&scene, &state).unwrap(), 0.01);
}

#[test]
fn what_pushes_sideways_is_across_the_largest_load() {
    let mut scene = stack();
    scene.mirrors.clear();
    let value = TractionValue::Vector([2.0, 0.0, 0.0]);
    let (name, surface) = ("side".to_string(), "block_w+".to_string());
    scene.tractions.push(Traction {
        name,
        surface,
        value,
    });
    let state = pressed(&scene);
    assert!(load::direction(&scene)[0] > 0.0);
    assert_eq!(load::main_direction(&scene, &state), [0.0, 0.0, -1.0]);
}

#[test]
fn planes_that_squeeze_load_along_their_motion() {
    let mut scene = stack();
    scene.mirrors.clear();
    let mut state = pressed(&scene);
    scene.rigid_planes.push(scene.rigid_planes[0].clone());
    state.planes.push(state.planes[0]);
    for (plane, moved, force) in [(0, 0.01, 5.0), (1, -0.01, -5.0)] {
        scene.rigid_planes[plane].motion = [
            PlaneMotion::Held(moved),
            PlaneMotion::Free,
            PlaneMotion::Free,
        ];
        state.planes[plane].force = [force, 0.0, 0.0];
    }
    assert!(load::oppose(&scene, &state));
    assert_eq!(load::along(&scene, &state), [1.0, 0.0, 0.0]);
}
