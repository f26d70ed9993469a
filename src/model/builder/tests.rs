use super::*;
use crate::model::material::Steel;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{Side, Temperature};

fn steel() -> Steel {
    Steel::elastic(210e3, 0.3)
}

fn cube(name: &str) -> Block<'static> {
    let side = || uniform(0.0, 1.0, 2);
    Block::new(name, side(), side(), side())
}

fn text(built: Result<crate::model::scene::Scene, BuildError>) -> String {
    built.unwrap_err().to_string()
}

#[test]
fn wrong_names_and_numbers_are_told() {
    let new = || SceneBuilder::new("test").body(cube("a"), steel());
    assert!(text(SceneBuilder::new("test").build()).contains("no bodies"));
    assert!(text(new().fix("a_top").build()).contains("`a_top`"));
    assert!(text(new().steel("b", steel()).build()).contains("body `b`"));
    assert!(text(new().body(cube("a"), steel()).build()).contains("called `a`"));
    let soft = Steel::elastic(-1.0, 0.3);
    assert!(text(new().steel("a", soft).build()).contains("Young's modulus of `a` is -1"));
    let load = Load::pressure("a_z_max", f64::NAN);
    assert!(text(new().load(load).build()).contains("`a_z_max` is NaN"));
    let step = new().step_but("go", 1.0, &[("push", 2.0)]);
    assert!(text(step.build()).contains("the load `push`"));
    let step = new()
        .warm("a", 10.0, 12e-6)
        .step_but("go", 1.0, &[("a", 2.0)]);
    assert_eq!(step.build().unwrap().factor("a", 0, 1.0), 2.0);
    assert!(text(new().warm("b", 10.0, 12e-6).build()).contains("the temperature `b`"));
    assert!(text(new().warm("a", f64::NAN, 12e-6).build()).contains("`a` is NaN"));
    let twice = new().warm("a", 10.0, 12e-6).warm("a", 20.0, 12e-6);
    assert!(text(twice.build()).contains("two loads called `a`"));
    let contact = Contact::between("a_z_max", "b_z_min");
    assert!(text(new().contact(contact).build()).contains("contact `a_z_max-b_z_min`"));
    let rough = Contact::on_plane("a_z_min", [0.0; 3], [0.0, 0.0, 2.0]).friction(-0.1);
    assert!(text(new().contact(rough).build()).contains("friction"));
    let level = Contact::on_plane("a_z_min", [0.0; 3], [0.0; 3]);
    assert!(text(new().contact(level).build()).contains("coordinate"));
}

#[test]
fn a_mirrored_model_lies_on_one_side_and_is_held_there() {
    let scene = SceneBuilder::new("test").body(cube("a"), steel());
    let scene = scene.mirror(Axis::Y).mirror(Axis::X).build().unwrap();
    assert_eq!(scene.mirrors, [0, 1]);
    let surface = scene.mesh.surface("x_mirror").unwrap();
    assert_eq!(surface.faces.len(), 4);
    assert_eq!(scene.supports[1].components, [None, Some(0.0), None]);
    let away = Block::new(
        "a",
        uniform(-1.0, 1.0, 2),
        uniform(0.0, 1.0, 1),
        uniform(0.0, 1.0, 1),
    );
    let both = SceneBuilder::new("test")
        .body(away, steel())
        .mirror(Axis::X);
    assert!(text(both.build()).contains("cannot be mirrored along x"));
    let across = Temperature {
        name: "a".into(),
        body: "a".into(),
        expansion: 12e-6,
        value: 0.0,
        gradient: [0.0, 1.0, 0.0],
    };
    let warm = SceneBuilder::new("test").body(cube("a"), steel());
    let warm = warm.mirror(Axis::Y).temperature(across);
    assert!(text(warm.build()).contains("zero along an axis that the scene is mirrored along"));
}

#[test]
fn a_force_is_spread_over_its_surface() {
    let load = Load::force("a_z_max", [0.0, 0.0, -6.0]).named("weight");
    let block = Block::new(
        "a",
        uniform(0.0, 2.0, 2),
        uniform(0.0, 1.5, 2),
        uniform(0.0, 1.0, 1),
    );
    let scene = SceneBuilder::new("test").body(block, steel()).load(load);
    let scene = scene
        .step_but("on", 1.0, &[("weight", 0.5)])
        .build()
        .unwrap();
    let traction = &scene.tractions[0];
    assert_eq!(traction.name, "weight");
    let crate::model::scene::TractionValue::Vector(t) = traction.value else {
        panic!("a vector")
    };
    assert!((t[2] + 2.0).abs() < 1e-12);
}

/// What a case file refuses a builder does, too.
#[test]
fn what_is_there_twice_or_no_number_is_told() {
    let new = || {
        let scene = SceneBuilder::new("test").body(cube("a"), steel());
        scene.body(cube("b"), steel())
    };
    let pair = || Contact::between("b_z_min", "a_z_max");
    let told = |scene: SceneBuilder, words: &str| {
        let text = text(scene.build());
        assert!(text.contains(words), "{words}: {text}");
    };
    told(new().contact(pair()).contact(pair()), "two contacts");
    let swapped = Contact::between("a_z_max", "b_z_min");
    told(new().contact(pair()).contact(swapped), "joins the surfaces");
    let itself = Contact::between("a_z_max", "a_z_max");
    told(new().contact(itself), "with itself");
    let press = || Load::pressure("b_z_max", 1.0);
    told(new().load(press()).load(press()), "two loads");
    told(new().step("s", 1.0).step("s", 2.0), "two steps");
    let twice = [("b_z_max", 1.0), ("b_z_max", 2.0)];
    told(
        new().load(press()).step_but("s", 1.0, &twice),
        "two factors",
    );
    let moved = new()
        .load(press())
        .displace("b_z_max", [Some(0.1), None, None]);
    told(moved.step_but("s", 1.0, &twice[..1]), "prescribed motion");
    told(new().displace("a_z_min", [Some(f64::NAN); 3]), "NaN");
    told(new().controls(|c| c.residual = 1e9), "residual");
    told(
        new().controls(|c| c.first_increment = f64::NAN),
        "first_increment",
    );
    told(new().controls(|c| c.iterations = 0), "iterations");
    told(
        new().controls(|c| c.contact_reach = f64::NAN),
        "contact_reach",
    );
}

/// Ends are surfaces of their own, whatever others are called, along every axis that is named.
#[test]
fn plane_strain_leaves_other_surfaces_alone() {
    let mut mesh = cube("a").mesh().unwrap();
    let named = mesh.surfaces.iter_mut().find(|s| s.name == "a_x_max");
    named.unwrap().name = "z_low_end".into();
    let scene = SceneBuilder::new("test").body(mesh, steel());
    let scene = scene.plane_strain(Axis::Z).plane_strain(Axis::Y);
    let scene = scene.build().unwrap();
    let own = scene.mesh.surface("z_low_end").unwrap();
    assert_eq!(own.faces.len(), 4);
    assert!(scene.supports.iter().all(|s| s.surface != "z_low_end"));
    assert_eq!(scene.supports.len(), 4);
}

#[test]
fn a_mesh_that_is_not_whole_is_told() {
    let mut mesh = cube("a").mesh().unwrap();
    mesh.hexes[0][0] = 9999;
    let broken = text(SceneBuilder::new("test").body(mesh, steel()).build());
    assert!(broken.contains("not whole: element 0"), "{broken}");
}

#[test]
fn what_presses_a_plane_of_symmetry_is_refused() {
    let scene = |surface: &str| {
        let scene = SceneBuilder::new("test").body(cube("a"), steel());
        let scene = scene.mirror(Axis::X);
        scene.load(Load::pressure(surface, 1.0)).build()
    };
    assert!(scene("a_x_max").is_ok());
    let error = scene("a_x_min").unwrap_err().to_string();
    assert!(error.contains("the load `a_x_min`"), "{error}");
}

#[test]
fn the_softer_side_carries_unless_asked_otherwise() {
    let carrier = |contact, modulus| {
        let soft = Steel::elastic(modulus, 0.3);
        let scene = SceneBuilder::new("test").body(cube("a"), steel());
        let scene = scene.body(cube("c"), soft).contact(contact);
        scene.build().unwrap().contacts[0].carrier
    };
    let contact = Contact::between("a_z_min", "c_z_max");
    assert_eq!(carrier(contact.clone(), 210e3), Side::Upper);
    assert_eq!(carrier(contact.clone(), 70e3), Side::Lower);
    assert_eq!(carrier(contact.carried_by(Side::Upper), 70e3), Side::Upper);
}

#[test]
fn cylinders_are_sound_and_marked() {
    let solid = [
        Cylinder::quarter("r", 2.0, 0.5),
        Cylinder::half("r", 2.0, 0.5).below(),
        Cylinder::whole("r", 2.0, 0.5).layers(2),
    ];
    let hollow = solid.clone().map(|shape| shape.bore(1.0));
    for shape in solid.into_iter().chain(hollow) {
        let mesh = shape.clone().mesh().unwrap();
        for part in mesh.quality() {
            assert!(part.min_scaled_jacobian > 0.2, "{shape:?}: {part:?}");
        }
        for name in ["r_contact", "r_top", "r_back", "r_front"] {
            let faces = mesh.surface(name).map_or(0, |s| s.faces.len());
            assert!(faces > 4, "{shape:?}: {name} {faces}");
        }
    }
    let wide = Cylinder::half("r", 2.0, 0.5).bore(2.5).mesh().unwrap_err();
    assert!(wide.to_string().contains("the bore of `r` is 2.5"));
    let fine = Cylinder::half("r", 2.0, 0.5)
        .fine(0.2, 0.1)
        .mesh()
        .unwrap_err();
    assert!(fine.to_string().contains("element size"));
}
