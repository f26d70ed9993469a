//! Edges of bodies at which elastic stresses have no bound: told by their shape, by what holds them and by what they are
//! joined to.

use brinell::answer::results::edges::SingularEdges;
use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, cylindrical, uniform};
use brinell::model::scene::{Scene, Support, Tie};
use brinell::model::state::State;

fn block(name: &str, x: [f64; 2], z: [f64; 2]) -> Mesh {
    let along = |[from, to]: [f64; 2]| uniform(from, to, ((to - from) * 10.0).round() as usize);
    let block = Block::new(name, along(x), along([0.0, 1.0]), along(z)).build();
    block.unwrap().prefixed(&format!("{name}_"))
}

fn scene(mesh: Mesh) -> Scene {
    Scene::bare("edges", mesh, Steel::elastic(200e3, 0.3))
}

fn hold(scene: &mut Scene, surface: &str, axes: [bool; 3]) {
    scene.supports.push(Support {
        name: surface.to_string(),
        surface: surface.to_string(),
        components: axes.map(|held| held.then_some(0.0)),
        ..Support::default()
    });
}

fn is_singular(scene: &Scene, at: [f64; 3]) -> bool {
    SingularEdges::find(scene, &State::default()).are_near(&at)
}

#[test]
fn a_clamped_edge_is_singular_and_one_that_slides_is_not() {
    let mut scene = scene(block("b", [0.0, 1.0], [0.0, 1.0]));
    let edge = [0.5, 0.0, 0.0];
    assert!(!is_singular(&scene, edge));
    hold(&mut scene, "b_z_min", [false, false, true]);
    assert!(!is_singular(&scene, edge));
    hold(&mut scene, "b_z_min", [true, true, false]);
    assert!(is_singular(&scene, edge) && is_singular(&scene, [1.0, 1.0, 0.0]));
    assert!(!is_singular(&scene, [0.5, 0.5, 0.0]) && !is_singular(&scene, [0.5, 0.0, 0.5]));
    // What slides along the side is half of a wider one, and its edge lies inside of that.
    hold(&mut scene, "b_y_min", [false, true, false]);
    assert!(!is_singular(&scene, edge) && is_singular(&scene, [0.5, 1.0, 0.0]));
}

#[test]
fn a_mirror_has_no_edge_of_its_own() {
    let mut scene = scene(block("b", [0.0, 1.0], [0.0, 1.0]));
    hold(&mut scene, "b_z_min", [true; 3]);
    assert!(is_singular(&scene, [0.0, 0.5, 0.0]));
    scene.mirrors = vec![0];
    assert!(!is_singular(&scene, [0.0, 0.5, 0.0]) && is_singular(&scene, [1.0, 0.5, 0.0]));
}

#[test]
fn an_inner_corner_is_singular_and_a_coarse_bore_is_none() {
    let parts = [
        block("p", [0.0, 1.0], [0.0, 1.0]),
        block("q", [1.0, 2.0], [0.0, 0.5]),
    ];
    let scene_of_l = scene(Mesh::weld("l", parts, 1e-6).unwrap());
    assert!(is_singular(&scene_of_l, [1.0, 0.5, 0.5]));
    assert!(
        !is_singular(&scene_of_l, [2.0, 0.5, 0.5]) && !is_singular(&scene_of_l, [1.0, 0.5, 0.0])
    );
    let turn = std::f64::consts::TAU;
    let ring = Block::new(
        "r",
        uniform(1.0, 2.0, 4),
        uniform(0.0, turn, 8),
        uniform(0.0, 1.0, 4),
    );
    let ring = Mesh::weld("r", [ring.mapped(cylindrical).build().unwrap()], 1e-6).unwrap();
    assert!(!is_singular(&scene(ring), [1.0, 0.0, 0.5]));
}

#[test]
fn the_rim_of_a_tie_is_singular_where_bodies_do_not_go_on_as_one() {
    let tied = |width: f64, stiffer: f64| {
        let parts = [
            block("low", [0.0, width], [-1.0, 0.0]),
            block("top", [0.0, 1.0], [0.0, 1.0]),
        ];
        let mut scene = scene(Mesh::join(parts).unwrap());
        scene.materials[1].youngs_modulus *= stiffer;
        scene.ties.push(Tie::between("top_z_min", "low_z_max"));
        is_singular(&scene, [1.0, 0.5, 0.0])
    };
    // Flush blocks of one steel, of two, and a step.
    assert!(!tied(1.0, 1.0) && tied(1.0, 2.0) && tied(2.0, 1.0));
}
