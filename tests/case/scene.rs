//! The scenes that cases make: names, signs, shares of symmetric models, defaults.

use std::path::Path;

use crate::kit::{BEARING, SCENE, blocks, centred, displaced, good, mesh, render, shipped, with};
use brinell::case::bearing::{CROSSED, RollerEnd};
use brinell::case::{Case, Kind, MisesRead, interfaces, parse, read};
use brinell::model::scene::{Partner, PlaneMotion, Scene, Side, Step, TractionValue};

fn bearing(case: &Case) -> &brinell::case::BearingCase {
    match &case.kind {
        Kind::Bearing(bearing) => bearing,
        Kind::General(_) => panic!("a bearing is expected"),
    }
}

fn scene(text: &str) -> Scene {
    good(text).scene(blocks()).unwrap()
}

#[test]
fn a_centred_bearing_is_a_quarter_model() {
    let scene = good(BEARING).scene(centred()).unwrap();
    assert_eq!(scene.name, "a bearing");
    assert_eq!(scene.mirrors, [0, 1]);
    let names: Vec<_> = scene
        .contacts
        .iter()
        .map(|pair| pair.name.as_str())
        .collect();
    assert_eq!(
        names,
        [
            "upper_plate-upper_roller",
            "upper_roller-intermediate_plate",
            "intermediate_plate-lower_roller",
            "lower_roller-lower_plate"
        ]
    );
    for pair in &scene.contacts {
        let carrier = match pair.carrier {
            Side::Upper => &pair.upper,
            Side::Lower => &pair.lower,
        };
        assert!(matches!(carrier, Partner::Surface(name) if name.ends_with("_roller_surface")));
        assert_eq!(
            (pair.friction, pair.penalty_factor, pair.true_geometry),
            (0.15, 1.0, true)
        );
    }
    let supports: Vec<_> = scene
        .supports
        .iter()
        .map(|s| (&*s.surface, s.components))
        .collect();
    let zero = Some(0.0);
    assert_eq!(
        supports,
        [
            ("lower_plate_bottom", [zero; 3]),
            ("x_symmetry", [zero, None, None]),
            ("y_symmetry", [None, zero, None])
        ]
    );
    let [plane] = scene.rigid_planes.as_slice() else {
        panic!("one rigid plane is expected")
    };
    assert_eq!(plane.surface, "upper_plate_top");
    let held = PlaneMotion::Held(0.0);
    assert_eq!(plane.motion, [held, held, PlaneMotion::Driven(-16.25)]);
    assert_eq!(scene.steps.len(), 1);
    assert_eq!(scene.materials.len(), 5);
}

#[test]
fn a_displaced_bearing_is_whole() {
    let text = with(BEARING, "\"0 in\"", "\"2.5 in\"\nunload = true");
    let scene = good(&text).scene(displaced()).unwrap();
    assert!(scene.mirrors.is_empty());
    assert_eq!(scene.supports.len(), 1);
    assert_eq!(scene.rigid_planes[0].motion[2], PlaneMotion::Driven(-65.0));
    let steps: Vec<_> = scene.steps.iter().map(|s| (&*s.name, s.factor)).collect();
    assert_eq!(steps, [("load", 1.0), ("unload", 1e-3)]);
}

#[test]
fn a_mesh_of_another_bearing_is_not_used() {
    let refused = |text: &str, mesh| {
        let error = good(text).scene(mesh).unwrap_err();
        assert!(render(&error).contains("brinell::case::mesh"));
        error.to_string()
    };
    let longer = with(BEARING, "\"8 in\"", "\"9 in\"");
    assert!(refused(&longer, centred()).contains("of another bearing or preset"));
    let full = with(BEARING, "\"0 in\"", "\"0 in\"\nfull = true");
    assert!(refused(&full, centred()).contains("of another bearing or preset"));
    assert!(refused(BEARING, blocks()).contains("carries no fingerprint"));
}

#[test]
fn rollers_get_their_ends() {
    let crowned = with(
        BEARING,
        "offset =",
        "roller_end = { crown = \"1 mil\" }\noffset =",
    );
    let square = good(BEARING).scene(centred()).unwrap().mesh;
    let shaped = good(&crowned).scene(centred()).unwrap().mesh;
    let moved = square.points.iter().zip(&shaped.points);
    let farthest = moved.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]));
    assert!((farthest.fold(0.0, f64::max) - 0.001).abs() < 1e-9);
}

#[test]
fn the_two_meanings_of_an_offset() {
    let of = |is: &str| {
        let text = with(
            BEARING,
            "\"0 in\"",
            &format!("\"2.5 in\"\noffset_is = \"{is}\""),
        );
        bearing(&good(&text)).geometry.offset()
    };
    assert_eq!((of("roller"), of("bearing")), (2.5, 1.25));
}

#[test]
fn dimensions_of_a_bearing() {
    let text = with(
        BEARING,
        "roller_wall = \"0.75 in\"",
        "solid = true\nroller_end = { crown = \"0.2 mil\" }\nplate_size = [\"9 in\", 10]",
    );
    let thick = "{ upper = 1, intermediate = \"2 in\", lower = 3 }";
    let case = good(&with(
        &text,
        "plate_thickness = \"1 in\"",
        &format!("plate_thickness = {thick}"),
    ));
    let geometry = bearing(&case).geometry.crossed().unwrap();
    assert_eq!(geometry.roller.wall, None);
    assert_eq!(geometry.roller.end, RollerEnd::Crown(2e-4));
    assert_eq!(geometry.plan, [9.0, 10.0]);
    assert_eq!(geometry.upper_thickness, 1.0);
    assert_eq!(geometry.intermediate_thickness, 2.0);
    assert_eq!(geometry.lower_thickness, 3.0);
    assert_eq!(geometry.slope, 4f64.to_radians());
}

#[test]
fn hardening_from_its_second_point() {
    let steel = |text: &str| good(text).scene(centred()).unwrap().materials[0];
    let total = steel(BEARING);
    assert!(
        (total.hardening_modulus - 249.471).abs() < 5e-4,
        "{}",
        total.hardening_modulus
    );
    let plastic = steel(&with(
        BEARING,
        "0.157 }",
        "0.157, strain_is = \"plastic\" }",
    ));
    assert!((plastic.hardening_modulus - 38.0 / 0.157).abs() < 1e-9);
    let hardening = "hardening = { stress = \"138 ksi\", strain = 0.157 }";
    let tangent = steel(&with(BEARING, hardening, "tangent_modulus = \"295 ksi\""));
    assert!((tangent.hardening_modulus - 29500.0 / 99.0).abs() < 1e-9);
    let perfect = steel(&with(BEARING, hardening, ""));
    assert_eq!(
        (perfect.yield_stress, perfect.hardening_modulus),
        (100.0, 0.0)
    );
}

#[test]
fn steels_of_single_bodies() {
    let text = format!(
        "{BEARING}[steel.upper_roller]\nelastic = true\n\
         [steel.lower_roller]\nyield_stress = \"120 ksi\"\nhardening_modulus = 0\n"
    );
    let scene_of_bearing = good(&text).scene(centred()).unwrap();
    let steel = |body: &str| scene_of_bearing.materials[scene_of_bearing.mesh.body(body).unwrap()];
    assert_eq!(steel("upper_roller").yield_stress, f64::INFINITY);
    let lower = steel("lower_roller");
    assert_eq!((lower.yield_stress, lower.hardening_modulus), (120.0, 0.0));
    assert_eq!(lower.youngs_modulus, 29500.0);
    assert_eq!(steel("upper_plate").yield_stress, 100.0);
    // The default hardens, and so does what it completes.
    let text = format!("{BEARING}[steel.upper_plate]\nyield_stress = \"120 ksi\"\n");
    let mut said = good(&text).assumptions.into_iter();
    assert!(!said.any(|a| a.key == "steel.upper_plate.hardening_modulus"));

    let text = format!("{SCENE}[[body]]\nname = \"upper\"\nsteel = {{ yield_stress = 300 }}\n");
    let steels = scene(&text).materials;
    assert_eq!(steels[0].yield_stress, f64::INFINITY);
    assert_eq!(
        (steels[1].yield_stress, steels[1].youngs_modulus),
        (300.0, 2e5)
    );
}

#[test]
fn assumptions_are_named_and_say_whether_they_were_given() {
    let case = good(BEARING);
    let given = |key: &str| {
        let found = case.assumptions.iter().find(|a| a.key == key);
        found.unwrap_or_else(|| panic!("no assumption {key}")).given
    };
    assert!(!given("bearing.plate_size"));
    assert!(!given("bearing.roller_end"));
    assert!(!given("bearing.full"));
    assert!(!given("steel.hardening.strain_is"));
    assert!(given("mesh.preset"));
    assert!(case.discrepancies.is_empty());
}

#[test]
fn a_scale_multiplies_every_element_size() {
    let sizes = |line: &str| {
        let case = good(&format!("{BEARING}{line}\n"));
        let mut assumptions = case.assumptions.iter();
        let text = assumptions.find(|a| a.key == "mesh.preset");
        let bearing = bearing(&case);
        let sizes = bearing.mesh.sizes(bearing.layout());
        (sizes, text.map(|a| a.value.clone()))
    };
    let ((base, plain), (finer, text)) = (sizes(""), sizes("scale = 0.5"));
    assert_eq!(finer, base.scaled(0.5));
    assert_eq!(plain.as_deref(), Some("h025"));
    let text = text.unwrap_or_default();
    assert_eq!(text, "h025, every element 0.5 times as large");
}

#[test]
fn a_case_can_be_changed_from_outside() {
    let mut case = good(&format!("{BEARING}growth = 1.5\n"));
    case.set_preset("report-like").unwrap();
    case.set_full().unwrap();
    assert_eq!(bearing(&case).mesh.preset.name(), "report-like");
    assert!(bearing(&case).mesh.overrides.is_empty());
    assert!(bearing(&case).is_whole() && case.model().mirrors.is_empty());
    let value = |key: &str| {
        &case
            .assumptions
            .iter()
            .find(|a| a.key == key)
            .unwrap()
            .value
    };
    assert_eq!(value("mesh.preset"), "report-like");
    assert_eq!(value("mesh"), "report-like alone");
    assert_eq!(value("bearing.full"), "the whole bearing");
    let error = good(BEARING).set_preset("h0025").unwrap_err();
    assert!(render(&error).contains("did you mean `h025`?"));
    let error = good(SCENE).set_full().unwrap_err();
    assert!(
        error
            .to_string()
            .contains("`two blocks` is a general scene")
    );
}

#[test]
fn the_template_has_the_names_that_the_case_uses() {
    let (_, template) = CROSSED.files[0];
    let sides = interfaces::INTERFACES
        .iter()
        .flat_map(|i| [i.upper, i.lower]);
    let bodies = bearing(&good(BEARING)).geometry.bodies();
    let faces = [interfaces::TOP, interfaces::BOTTOM];
    let surfaces = sides.chain(faces).chain(interfaces::SYMMETRIES);
    for (kind, name) in surfaces
        .map(|name| ("Surface", name))
        .chain(bodies.iter().map(|(name, _)| ("Volume", name.as_str())))
    {
        let line = format!("Physical {kind}(\"{name}\") =");
        assert!(template.contains(&line), "`{line}` is not in the template");
    }
}

#[test]
fn a_general_scene() {
    let scene = scene(SCENE);
    assert_eq!(scene.contacts[0].name, "upper_face-lower_face");
    assert_eq!(scene.contacts[0].carrier, Side::Upper);
    assert_eq!(scene.contacts[0].friction, 0.2);
    assert_eq!(scene.supports[0].name, "base");
    assert_eq!(scene.tractions[0].value, TractionValue::Pressure(10.0));
    assert_eq!((scene.steps[0].factor, scene.steps.len()), (1.0, 1));
    assert_eq!(scene.materials[1].youngs_modulus, 2e5);
    assert_eq!(
        good(SCENE).mesh_file().as_deref(),
        Some(Path::new("cases/blocks.msh"))
    );
}

#[test]
fn rigid_planes_tractions_and_steps() {
    let text = format!(
        "{SCENE}[[rigid_plane]]\nname = \"lid\"\nsurface = \"top\"\nfixed = \"x\"\n\
         displacement = {{ y = \"1 µm\" }}\nforce = {{ z = \"-2 kN\" }}\n\
         [[traction]]\nname = \"shear\"\nsurface = \"upper_face\"\nvalue = [1, \"2 kPa\", 0]\n\
         [[step]]\nname = \"push\"\n\
         [[step]]\nname = \"release\"\nfactor = 0.5\nfactors = {{ lid = \"10 %\" }}\n"
    );
    let half = with(&text, "[mesh]", "symmetry = [\"x\"]\n[mesh]");
    let whole = scene(&text);
    let motion = whole.rigid_planes[0].motion;
    assert_eq!(motion[0], PlaneMotion::Held(0.0));
    assert_eq!(motion[1], PlaneMotion::Held(0.001));
    assert_eq!(motion[2], PlaneMotion::Driven(-2000.0));
    assert_eq!(
        scene(&half).rigid_planes[0].motion[2],
        PlaneMotion::Driven(-1000.0)
    );
    assert_eq!(
        whole.tractions[1].value,
        TractionValue::Vector([1.0, 0.002, 0.0])
    );
    assert_eq!(whole.steps[0].factor_of("lid"), 1.0);
    assert_eq!(whole.steps[1].factor_of("lid"), 0.1);
    assert_eq!(whole.steps[1].factor_of("top"), 0.5);
}

#[test]
fn ties() {
    let tie = "[[tie]]\nsurfaces = [\"top\", \"base\"]\n";
    let text = format!("{SCENE}{tie}name = \"weld\"\ntolerance = \"20 µm\"\n");
    let read = &scene(&text).ties[0];
    assert_eq!(read.surfaces, ["top", "base"]);
    assert_eq!((read.name.as_str(), read.tolerance), ("weld", Some(0.02)));
    let plain = &scene(&format!("{SCENE}{tie}")).ties[0];
    assert_eq!((plain.name.as_str(), plain.tolerance), ("top-base", None));
    for (wrong, says) in [
        ("[\"top\"]", "joins two surfaces, and here are 1"),
        ("[\"top\", \"top\"]", "cannot be tied to itself"),
        ("[\"top\", 3]", "surfaces"),
    ] {
        let text = format!("{SCENE}[[tie]]\nsurfaces = {wrong}\n");
        let error = parse("case.toml", &text)
            .map(|_| ())
            .unwrap_err()
            .to_string();
        assert!(error.contains(says), "{wrong}: {error}");
    }
    let twice = format!("{SCENE}{tie}{tie}");
    let error = parse("case.toml", &twice)
        .map(|_| ())
        .unwrap_err()
        .to_string();
    assert!(error.contains("two ties called `top-base`"), "{error}");
}

#[test]
fn planes_as_partners_are_never_carriers() {
    let plane = "{ plane = { point = [0, 0, \"1 cm\"], normal = [0, 0, 2] } }";
    let below = scene(&with(SCENE, "\"lower_face\"", plane));
    let expected = Partner::Plane {
        point: [0.0, 0.0, 10.0],
        normal: [0.0, 0.0, 1.0],
    };
    assert_eq!(below.contacts[0].lower, expected);
    assert_eq!(below.contacts[0].carrier, Side::Upper);
    assert_eq!(below.contacts[0].name, "upper_face-plane");
    let above = scene(&with(SCENE, "\"upper_face\"", plane));
    assert_eq!(above.contacts[0].carrier, Side::Lower);
}

/// The side whose layer of facets is the less stiff: E / (1 - ν²) over the shortest side of a facet.
#[test]
fn the_softer_or_the_coarser_side_carries() {
    let carrier = |lower: f64, steel: &str| {
        let mesh = mesh(
            &[
                ("lower", [0.0, 0.0, 1.0 - lower], [lower, lower, 1.0]),
                ("upper", [0.0, 0.0, 1.0], [1.0, 1.0, 2.0]),
            ],
            &[
                ("base", 0, "-z"),
                ("lower_face", 0, "+z"),
                ("upper_face", 1, "-z"),
                ("top", 1, "+z"),
            ],
        );
        let text = format!("{SCENE}\n{steel}");
        good(&text).scene(mesh).unwrap().contacts[0].carrier
    };
    let softer = |times: f64| {
        let modulus = 2e5 / times;
        format!("[steel.lower]\nyoungs_modulus = {modulus}\npoissons_ratio = 0.3\nelastic = true\n")
    };
    // Alike within a tenth: the upper side.
    assert_eq!(carrier(1.0, &softer(1.0)), Side::Upper);
    assert_eq!(carrier(1.05, &softer(1.0)), Side::Upper);
    assert_eq!(carrier(1.5, &softer(1.0)), Side::Lower);
    assert_eq!(carrier(0.5, &softer(1.0)), Side::Upper);
    // Softer by more than it is finer.
    assert_eq!(carrier(0.5, &softer(3.0)), Side::Lower);
    assert_eq!(carrier(1.5, &softer(0.5)), Side::Upper);
}

#[test]
fn a_mesh_in_another_unit_is_scaled() {
    let text = with(SCENE, "file =", "unit = \"in\"\nfile =");
    assert_eq!(scene(&text).mesh.points[6], [25.4; 3]);
    assert_eq!(scene(SCENE).mesh.points[6], [1.0; 3]);
}

#[test]
fn stages_of_the_load_are_steps() {
    let staged = |more: &str| with(BEARING, "friction =", &format!("{more}\nfriction ="));
    let steps = |text: &str| {
        let case = good(text);
        let model = case.model();
        let name = |step: &Step| (step.name.clone(), step.factor);
        model.loads.steps.iter().map(name).collect::<Vec<_>>()
    };
    let named = |steps: &[(&str, f64)]| -> Vec<(String, f64)> {
        steps.iter().map(|(n, f)| (n.to_string(), *f)).collect()
    };
    assert_eq!(steps(BEARING), named(&[("load", 1.0)]));
    assert_eq!(steps(&staged("stages = []")), named(&[("load", 1.0)]));
    let text = staged("stages = [\"13 kip\", \"32500 lbf\"]\nunload = true");
    let all = [
        ("stage 1", 0.2),
        ("stage 2", 0.5),
        ("load", 1.0),
        ("unload", 1e-3),
    ];
    assert_eq!(steps(&text), named(&all));
    let full = |text: &str| good(text).scene(centred()).unwrap().reported_step();
    assert_eq!((full(BEARING), full(&text)), (0, 2));
}

#[test]
fn shipped_cases() {
    let folder = Path::new("cases/section-2.6.2");
    for (design, length) in [("initial", 8.0), ("revised", 10.5)] {
        for (place, offset) in [("centre", 0.0), ("offset-1.25", 1.25), ("offset-2.5", 2.5)] {
            let case = read(&folder.join(format!("{design}-{place}.toml"))).unwrap();
            let bearing = bearing(&case);
            let geometry = bearing.geometry.crossed().unwrap();
            assert_eq!((geometry.roller.length, geometry.offset), (length, offset));
            assert_eq!((bearing.load, bearing.friction), (65.0, 0.15));
            assert_eq!(
                (geometry.roller.diameter, geometry.roller.wall),
                (3.0, Some(0.75))
            );
            assert_eq!(bearing.is_whole(), offset > 0.0);
            assert!(case.discrepancies.len() >= 4);
            let mesh = shipped(&format!("{design}-{place}-auto"));
            assert_eq!(
                case.scene(mesh).unwrap().mirrors.len(),
                if offset > 0.0 { 0 } else { 2 }
            );
            let mut like = case.clone();
            like.set_preset("report-like").unwrap();
            like.scene(shipped(&format!("{design}-{place}-report-like")))
                .unwrap();
        }
    }
    let centre = read(&folder.join("initial-centre.toml"))
        .unwrap()
        .comparison
        .unwrap();
    assert_eq!(centre.mises_read, MisesRead::Centroid);
    let printed: Vec<_> = centre.values.iter().map(|p| (&*p.place, p.value)).collect();
    assert!(printed.contains(&("overall", 70.0)) && printed.contains(&("rollers", 49.0)));

    let h = read(Path::new("cases/problem-h.toml")).unwrap();
    assert_eq!(h.model().mirrors, [0]);
    assert_eq!(h.mesh_file(), None);
}
