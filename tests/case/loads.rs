//! Planes that turn, temperatures, and loads of the template off its centre.

use crate::kit::{BEARING, SCENE, bad, blocks, good, render, with};
use brinell::case::Kind;
use brinell::model::scene::{PlaneMotion, PlaneTurn, RigidPlane, Scene};

const STAYS: PlaneTurn = PlaneTurn::Held(0.0);

fn scene(text: &str) -> Scene {
    good(text).scene(blocks()).unwrap()
}

fn lid(lines: &str) -> String {
    let table = "[[rigid_plane]]\nname = \"lid\"\nsurface = \"top\"\nfixed = \"xy\"\n\
                 force = { z = \"-2 kN\" }\n";
    format!("{SCENE}{table}{lines}\n")
}

#[test]
fn a_plane_is_turned_and_turns() {
    let text = lid("rotation = { x = \"2 mrad\" }\nturns = \"y\"\nmoment = { y = \"3 N*m\" }");
    let whole = scene(&text);
    let plane = &whole.rigid_planes[0];
    assert_eq!(
        plane.turn,
        [PlaneTurn::Held(0.002), PlaneTurn::Driven(3000.0), STAYS]
    );
    assert_eq!(plane.point(&whole.mesh, &[]), [0.5, 0.5, 2.0]);
    let about = scene(&lid("turns = \"x\"\nabout = [\"1 cm\", 0, 2]"));
    assert_eq!(about.rigid_planes[0].about, Some([10.0, 0.0, 2.0]));
    // A turn about the mirrored axis keeps the symmetry, and the half bears half of the moment.
    let text = lid("turns = \"x\"\nmoment = { x = 8 }").replace("fixed = \"xy\"", "fixed = \"y\"");
    let half = with(&text, "[mesh]", "symmetry = [\"x\"]\n[mesh]");
    assert_eq!(scene(&half).rigid_planes[0].turn[0], PlaneTurn::Driven(4.0));
}

#[test]
fn turns_that_cannot_be_are_refused() {
    let mirrored = with(
        &lid("turns = \"y\""),
        "[mesh]",
        "symmetry = [\"x\"]\n[mesh]",
    );
    assert!(bad(&mirrored).contains("breaks the symmetry about x = 0"));
    let both = lid("turns = \"x\"\nrotation = { x = 0.01 }");
    assert!(bad(&both).contains("it is free to turn about x"));
    let held = bad(&lid("moment = { x = 1 }"));
    assert!(
        held.contains("does not turn about x") && held.contains("turns = \"x\""),
        "{held}"
    );
    assert!(bad(&lid("rotation = { x = \"200 mrad\" }")).contains("0.1 rad"));
    assert!(bad(&lid("turns = \"xx\"")).contains("each once"));
    let loose = lid("turns = \"z\"").replace("fixed = \"xy\"\n", "");
    assert!(bad(&loose).contains("moves nothing"));
    // A flat face that is driven across itself only has no lever.
    let flat = format!(
        "{SCENE}[[rigid_plane]]\nname = \"lid\"\nsurface = \"top\"\nforce = {{ x = \"1 N\" }}\n\
         turns = \"y\"\nmoment = {{ y = \"1 N*mm\" }}\n"
    );
    let error = render(&good(&flat).scene(blocks()).unwrap_err());
    assert!(error.contains("a turn about y moves nothing"), "{error}");
    let driven = with(&flat, "x = \"1 N\"", "x = \"1 N\", z = 0");
    assert!(good(&driven).scene(blocks()).is_ok());
}

#[test]
fn a_mesh_ends_in_its_plane_of_symmetry_and_is_held_there() {
    let half = with(SCENE, "[mesh]", "symmetry = [\"x\"]\n[mesh]");
    let off = |x: f64| {
        let mut mesh = blocks();
        mesh.points.iter_mut().for_each(|point| point[0] += x);
        good(&half).scene(mesh)
    };
    let scene = off(0.0).unwrap();
    let own = scene.supports.last().unwrap();
    assert_eq!(own.components, [Some(0.0), None, None]);
    assert_eq!(scene.mesh.surface(&own.surface).unwrap().faces.len(), 2);
    // Rounded coordinates are meant to be zero.
    let rounded = off(1e-9).unwrap();
    assert!(
        rounded
            .mesh
            .points
            .iter()
            .all(|p| p[0] == 0.0 || p[0] > 0.5)
    );
    for (x, says) in [
        (1e-4, "next to the plane of symmetry"),
        (0.1, "no face of the mesh"),
        (-0.1, "on both sides"),
        (-1.0, "on the negative side"),
    ] {
        let error = render(&off(x).unwrap_err());
        assert!(error.contains(says), "{error}");
    }
    let moved = format!(
        "{half}[[support]]\nname = \"pull\"\nsurface = \"upper_face\"\ndisplacement = {{ x = 0.1 }}\n"
    );
    let error = render(&good(&moved).scene(blocks()).unwrap_err());
    assert!(error.contains("which symmetry holds"), "{error}");
    let pressed = format!("{half}[[pressure]]\nsurface = \"side\"\nvalue = \"1 MPa\"\n");
    let error = render(&good(&pressed).scene(blocks()).unwrap_err());
    assert!(error.contains("inside the whole"), "{error}");
}

#[test]
fn temperatures_have_units_and_names() {
    let table = |lines: &str| format!("{SCENE}[[temperature]]\nbody = \"upper\"\n{lines}\n");
    let text = table("value = \"36 degF\"\ngradient = [0, 0, \"2 K/m\"]");
    let scene = scene(&text);
    let heated = &scene.temperatures[0];
    assert!((heated.value - 20.0).abs() < 1e-12 && heated.name == "upper");
    assert!((heated.gradient[2] - 0.002).abs() < 1e-15);
    assert_eq!(heated.expansion, 12e-6);
    let assumed = good(&text).assumptions;
    assert!(
        assumed
            .iter()
            .any(|a| a.key == "steel.upper.expansion" && !a.given)
    );
    let own = with(
        &text,
        "elastic = true",
        "elastic = true\nexpansion = \"9e-6 1/degF\"",
    );
    let expansion = good(&own).scene(blocks()).unwrap().temperatures[0].expansion;
    assert!((expansion - 16.2e-6).abs() < 1e-18);
    assert!(bad(&table("")).contains("does not differ"));
    assert!(bad(&table("value = \"20 mm\"")).contains("a difference of temperature"));
    let mirrored = with(
        &table("gradient = [1, 0, 0]"),
        "[mesh]",
        "symmetry = [\"x\"]\n[mesh]",
    );
    assert!(bad(&mirrored).contains("breaks the symmetry about x = 0"));
    let nobody = table("value = 20").replace("body = \"upper\"", "body = \"uper\"");
    let error = good(&nobody).scene(blocks()).unwrap_err();
    assert!(
        format!("{error}").contains("no body called `uper`"),
        "{error}"
    );
}

/// The top of a bearing with these lines; and is the whole of it modelled?
fn top(lines: &str) -> (RigidPlane, bool) {
    let text = with(
        BEARING,
        "load = \"65 kip\"",
        &format!("load = \"65 kip\"\n{lines}"),
    );
    let case = good(&text);
    let Kind::Bearing(bearing) = &case.kind else {
        panic!("a bearing is expected");
    };
    let plane = case.model().loads.planes[0].value.clone();
    (plane, bearing.is_whole())
}

#[test]
fn a_bearing_bears_what_is_off_its_centre() {
    let held = PlaneMotion::Held(0.0);
    let (plane, whole) = top("");
    assert_eq!((plane.turn, whole), ([STAYS; 3], false));
    // A free top turns nowhere under a central load: the quarter stays.
    let (plane, whole) = top("top = \"free\"");
    assert_eq!((plane.turn, whole), ([STAYS; 3], false));
    // M = e × F with F down.
    let (plane, whole) =
        top("top = \"free\"\neccentricity = [\"0.5 in\", \"-2 in\"]\nmoment = [\"10 kip*in\", 0]");
    assert_eq!(plane.motion, [held, held, PlaneMotion::Driven(-65.0)]);
    let moments = [
        PlaneTurn::Driven(10.0 + 130.0),
        PlaneTurn::Driven(32.5),
        STAYS,
    ];
    assert_eq!((plane.turn, whole), (moments, true));
    let (plane, whole) = top("top = { tilt = [\"2 mrad\", \"0 mrad\"] }");
    assert_eq!(
        (plane.turn, whole),
        ([PlaneTurn::Held(0.002), STAYS, STAYS], true)
    );
    let (plane, whole) = top("horizontal = [0, \"3 kip\"]");
    assert_eq!(
        (plane.motion[0], plane.motion[1]),
        (held, PlaneMotion::Driven(3.0))
    );
    assert!(whole);
}

#[test]
fn parallel_rollers_bear_the_same_loads() {
    let text = "units = \"mm-N-MPa\"\nsteel = \"S355\"\n[line_bearing]\nload = \"900 kN\"\nfriction = 0.1\n\
                roller_diameter = 120\nsolid = true\nroller_length = 400\nplate_thickness = 60\n";
    let case = good(&format!("{text}top = {{ tilt = [\"0.2 mrad\", 0] }}\n"));
    let model = case.model();
    let plane = &model.loads.planes[0].value;
    assert_eq!(plane.turn[0], PlaneTurn::Held(0.2e-3));
    // It turns about the axis of the roller; a force on the top, 120 mm above, has a moment about it.
    assert_eq!(plane.about, Some([0.0; 3]));
    let pushed = good(&format!(
        "{text}top = \"free\"\nhorizontal = [\"1 kN\", \"2 kN\"]\neccentricity = [3, 5]\n"
    ));
    let turn = pushed.model().loads.planes[0].value.turn;
    let moments = [-900e3 * 5.0 - 2e3 * 120.0, 900e3 * 3.0 + 1e3 * 120.0];
    let driven = moments.map(PlaneTurn::Driven);
    assert_eq!([turn[0], turn[1]], driven);
    assert!(model.mirrors.is_empty());
    let said = case
        .assumptions
        .iter()
        .find(|a| a.key == "line_bearing.full");
    assert!(said.expect("a note").why.contains("a tilted top"));
    assert_eq!(good(text).model().mirrors, [0, 1]);
}

#[test]
fn what_differs_from_side_to_side_is_not_mirrored() {
    let text = "units = \"mm-N-MPa\"\nsteel = \"S355\"\n[line_bearing]\nload = \"900 kN\"\nfriction = 0.1\n\
                rollers = 2\nspacing = 200\ntop = \"free\"\n\
                roller_diameter = 120\nsolid = true\nroller_length = 400\nplate_thickness = 60\n";
    let warm = |body: &str, lines: &str| format!("[[temperature]]\nbody = \"{body}\"\n{lines}\n");
    let model = |lines: &str| good(&format!("{text}{lines}")).model();
    let turns = [STAYS, PlaneTurn::Driven(0.0), STAYS];
    let one = model(&warm("roller_1", "value = 20"));
    assert_eq!(one.mirrors, [1]);
    // Across y = 0 the top is free to turn about y.
    assert_eq!(one.loads.planes[0].value.turn, turns);
    let both = warm("roller_1", "value = 20") + &warm("roller_2", "value = 20");
    let both = model(&both);
    assert_eq!(
        (&both.mirrors[..], both.loads.planes[0].value.turn),
        (&[0, 1][..], [STAYS; 3])
    );
    let heated: Vec<&str> = (both.loads.temperatures.iter())
        .map(|t| t.value.body.as_str())
        .collect();
    assert_eq!(heated, ["roller_2"]);
    let nobody = bad(&format!("{text}{}", warm("roler_1", "value = 20")));
    assert!(
        nobody.contains("no body called `roler_1`") && nobody.contains("`roller_1`?"),
        "{nobody}"
    );
    let across = bad(&format!(
        "{text}{}",
        warm("upper_plate", "gradient = [1, 0, 0]")
    ));
    assert!(
        across.contains("`full = true` in [line_bearing]"),
        "{across}"
    );
}

#[test]
fn symmetry_that_a_load_breaks_is_said_to_be_off() {
    let text = with(
        BEARING,
        "slope =",
        "top = { tilt = [\"1 mrad\", 0] }\nslope =",
    );
    let said = good(&text).assumptions;
    let said = said
        .iter()
        .find(|a| a.key == "bearing.full")
        .expect("a note");
    assert!(
        said.why.contains("a tilted top breaks the symmetry"),
        "{}",
        said.why
    );
}

#[test]
fn loads_that_change_nothing_are_refused() {
    let with_line = |line: &str| with(BEARING, "slope =", &format!("{line}\nslope ="));
    let error = bad(&with_line("eccentricity = [1, 0]"));
    assert!(
        error.contains("changes nothing") && error.contains("top = \"free\""),
        "{error}"
    );
    assert!(bad(&with_line("top = { tilt = [\"1 rad\", 0] }")).contains("0.1 rad at most"));
    assert!(bad(&with_line("moment = [1]")).contains("two components"));
}
