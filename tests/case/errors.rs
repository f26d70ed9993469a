//! One test for each kind of mistake in a case file: the message names the key, the line and the
//! value.

use crate::kit::{BEARING, SCENE, bad, blocks, good, render, with};
use brinell::case::{ErrorKind, parse, read};

/// Asserts that the case is refused, with a message that has all of `parts`.
#[track_caller]
fn refused(text: &str, parts: &[&str]) {
    has(&bad(text), parts);
}

#[track_caller]
fn has(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "`{part}` is not in\n{message}");
    }
}

/// Asserts that the general scene parses but does not fit the toy mesh.
#[track_caller]
fn unfit(text: &str, parts: &[&str]) {
    let error = good(text)
        .scene(blocks())
        .expect_err("the mesh should be refused");
    has(&render(&error), parts);
}

#[test]
fn a_file_that_is_not_there() {
    let error = read(std::path::Path::new("no/such/case.toml")).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Read);
    has(
        &render(&error),
        &["brinell::case::read", "no/such/case.toml"],
    );
}

#[test]
fn not_toml() {
    let text = with(BEARING, "friction = 0.15", "friction = = 0.15");
    refused(
        &text,
        &["brinell::case::syntax", "line 6", "cases/test.toml:6"],
    );
    refused(
        "load = 1\nload = 2\n",
        &["brinell::case::syntax", "duplicate", "2 │ load = 2"],
    );
    refused("\u{0}", &["brinell::case::syntax"]);
}

#[test]
fn an_unknown_key() {
    let text = with(BEARING, "roller_length", "roller_lenght");
    refused(
        &text,
        &[
            "brinell::case::unknown_key",
            "`bearing.roller_lenght`",
            "cases/test.toml:9",
            "did you mean `roller_length`?",
        ],
    );
    refused(
        &with(BEARING, "[mesh]", "[mash]"),
        &["`mash`", "did you mean `mesh`?"],
    );
    refused(
        &with(BEARING, "strain = 0.157", "strian = 0.157"),
        &["did you mean `strain`?"],
    );
    refused(
        &with(SCENE, "fixed = \"xyz\"", "fix = \"xyz\""),
        &["`support#1.fix`", "fixed"],
    );
}

#[test]
fn a_missing_key() {
    refused(
        &with(BEARING, "slope = \"4 deg\"\n", ""),
        &["`bearing.slope` is missing", ":4"],
    );
    refused(
        &with(BEARING, "units = \"in-kip-ksi\"\n", ""),
        &["`units` is missing", "mm-N-MPa"],
    );
    refused(
        &with(SCENE, "file = \"blocks.msh\"\n", ""),
        &["`mesh.file` is missing"],
    );
    refused(
        &with(BEARING, "roller_wall = \"0.75 in\"\n", ""),
        &["`bearing.roller_wall` is missing", "solid = true"],
    );
    refused(
        &with(BEARING, "yield_stress = \"100 ksi\"\n", ""),
        &["needs `yield_stress`"],
    );
    refused("units = \"m-N-Pa\"\n", &["brinell::case::missing_key"]);
}

#[test]
fn an_unknown_unit_system() {
    let text = with(BEARING, "in-kip-ksi", "in-kip-psi");
    refused(
        &text,
        &[
            "units = \"in-kip-psi\"",
            "in-lbf-psi",
            ":2",
            "did you mean `in-kip-ksi`?",
        ],
    );
}

#[test]
fn a_wrong_type() {
    let text = with(BEARING, "\"0.75 in\"", "true");
    refused(
        &text,
        &[
            "brinell::case::wrong_type",
            "bearing.roller_wall = true",
            ":8",
            "boolean",
        ],
    );
    refused(
        &with(BEARING, "\"a bearing\"", "3"),
        &["title = 3", "a string is wanted"],
    );
    refused(
        &with(BEARING, "[mesh]", "[[mesh]]"),
        &["`mesh", "a table is wanted, this is an array"],
    );
    refused(
        &with(SCENE, "[[support]]", "[support]"),
        &["`support", "an array is wanted", "[[support]]"],
    );
    refused(
        &with(SCENE, "\"base\"", "[\"base\"]"),
        &["support#1.surface", "a string is wanted"],
    );
    refused(
        &with(SCENE, "elastic = true", "elastic = 1"),
        &["true or false is wanted"],
    );
}

#[test]
fn a_wrong_unit() {
    refused(
        &with(BEARING, "\"8 in\"", "\"8 ksi\""),
        &[
            "brinell::case::unit",
            "`bearing.roller_length`: `8 ksi` is a stress; a length is wanted: in, ft",
            "cases/test.toml:9",
        ],
    );
    refused(
        &with(BEARING, "\"8 in\"", "\"8\""),
        &["`8` has no unit; a length is wanted"],
    );
    refused(
        &with(BEARING, "\"8 in\"", "\"8 inn\""),
        &["the unit `inn` is not known"],
    );
    refused(
        &with(BEARING, "\"8 in\"", "\"eight\""),
        &["`eight` does not begin with a number"],
    );
    refused(
        &with(BEARING, "\"8 in\"", "\"inf in\""),
        &["`inf in` is not finite"],
    );
    refused(
        &with(BEARING, "\"8 in\"", "inf"),
        &["bearing.roller_length = inf", "not finite"],
    );
    refused(
        &with(BEARING, "\"8 in\"", "nan"),
        &["bearing.roller_length = nan", "not finite"],
    );
    refused(
        &with(BEARING, "0.15", "\"0.15 in\""),
        &["is a length; a number without a unit"],
    );
    refused(
        &with(BEARING, "\"65 kip\"", "\"65 lbs\""),
        &["did you mean `lbf`?"],
    );
    let text = with(
        SCENE,
        "file = \"blocks.msh\"",
        "file = \"blocks.msh\"\nunit = \"N\"",
    );
    refused(&text, &["mesh.unit = \"N\"", "a unit of length"]);
}

#[test]
fn an_unphysical_steel() {
    let e = |value: &str| with(BEARING, "\"29500 ksi\"", value);
    refused(
        &e("-29500"),
        &[
            "brinell::case::value",
            "steel.youngs_modulus = -29500",
            ":15",
        ],
    );
    refused(
        &e("\"0 ksi\""),
        &["steel.youngs_modulus = \"0 ksi\"", "must be positive"],
    );
    let nu = |value: &str| with(BEARING, "poissons_ratio = 0.3", value);
    refused(
        &nu("poissons_ratio = 0.5"),
        &["steel.poissons_ratio = 0.5", "between -1 and 0.5"],
    );
    refused(
        &nu("poissons_ratio = -1"),
        &["steel.poissons_ratio = -1", ":16"],
    );
    let y = with(BEARING, "\"100 ksi\"", "\"0 ksi\"");
    refused(
        &y,
        &["steel.yield_stress = \"0 ksi\"", ":17", "must be positive"],
    );
    let point = |old: &str, new: &str| with(BEARING, old, new);
    refused(
        &point("\"138 ksi\"", "\"98 ksi\""),
        &[
            "steel.hardening.stress = \"98 ksi\"",
            "below the yield stress of `",
            ", 100 ksi",
            ":18",
        ],
    );
    refused(
        &point("strain = 0.157", "strain = 0.004"),
        &["steel.hardening.strain = 0.004", "at that stress, 0.004678"],
    );
    refused(
        &point("strain = 0.157", "strain = -0.1"),
        &["must be positive"],
    );
    refused(
        &point(
            "hardening = { stress = \"138 ksi\", strain = 0.157 }",
            "tangent_modulus = 30000",
        ),
        &[
            "steel.tangent_modulus = 30000",
            "less than Young's modulus of `",
            ", 29500 ksi",
        ],
    );
    refused(
        &point(
            "hardening = { stress = \"138 ksi\", strain = 0.157 }",
            "hardening_modulus = -1",
        ),
        &["steel.hardening_modulus = -1", "must not be negative"],
    );
    refused(
        &point(
            "strain = 0.157",
            "strain = 0.157, strain_is = \"engineering\"",
        ),
        &[
            "steel.hardening.strain_is = \"engineering\"",
            "total, plastic",
        ],
    );
}

#[test]
fn contradictions_in_a_steel() {
    let text = format!("{BEARING}[steel.upper_roller]\nelastic = true\nyield_stress = 90\n");
    refused(
        &text,
        &[
            "brinell::case::conflict",
            "steel.upper_roller.yield_stress = 90",
            ":24",
        ],
    );
    let both = with(
        BEARING,
        "hardening = {",
        "tangent_modulus = 200\nhardening = {",
    );
    refused(
        &both,
        &["given already by `steel.hardening`", "tangent_modulus"],
    );
}

#[test]
fn an_unknown_body_of_a_bearing() {
    let text = format!("{BEARING}[steel.uper_roller]\nyield_stress = 90\n");
    refused(
        &text,
        &[
            "brinell::case::unknown_name",
            "uper_roller",
            "did you mean `upper_roller`?",
        ],
    );
}

#[test]
fn an_impossible_bearing() {
    let set = |old: &str, new: &str| with(BEARING, old, new);
    refused(
        &set("\"0.75 in\"", "\"-0.75 in\""),
        &["bearing.roller_wall = \"-0.75 in\"", "0.03 and 1.47", ":8"],
    );
    refused(
        &set("\"0.75 in\"", "\"1.5 in\""),
        &[
            "bearing.roller_wall = \"1.5 in\"",
            "0.01 and 0.49 diameters",
        ],
    );
    refused(
        &set("\"3 in\"", "0"),
        &["bearing.roller_diameter = 0", "must be more than 0"],
    );
    refused(
        &set("0.15", "-0.15"),
        &["bearing.friction = -0.15", "must not be negative", ":6"],
    );
    refused(
        &set("\"65 kip\"", "\"-65 kip\""),
        &["bearing.load = \"-65 kip\"", ":5"],
    );
    refused(
        &set("\"4 deg\"", "\"0 deg\""),
        &["bearing.slope = \"0 deg\"", "between 0.05 and 45 deg"],
    );
    refused(
        &set("\"4 deg\"", "50"),
        &["bearing.slope = 50", "between 0.05 and 45 deg"],
    );
    refused(
        &set("\"0 in\"", "\"-1 in\""),
        &["bearing.offset = \"-1 in\"", "must be at least 0"],
    );
    refused(
        &set("\"0 in\"", "\"4 in\""),
        &["bearing.offset = \"4 in\"", "must cross each other"],
    );
    refused(
        &set("\"0 in\"", "\"3.95 in\""),
        &["bearing.offset = \"3.95 in\"", "less than 3.89536"],
    );
    refused(
        &set(
            "offset = \"0 in\"",
            "offset = \"8 in\"\noffset_is = \"bearing\"",
        ),
        &["each roller less than 3.89536", "allows twice as much"],
    );
    refused(
        &set("\"1 in\"", "\"0 in\""),
        &["bearing.plate_thickness = \"0 in\""],
    );
    refused(
        &set("offset =", "plate_size = \"0.2 in\"\noffset ="),
        &[
            "bearing.plate_size = \"0.2 in\"",
            "rest on the intermediate plate",
        ],
    );
    refused(
        &set("\"1 in\"", "{ upper = 1, intermediate = 1, lower = -1 }"),
        &["bearing.plate_thickness.lower = -1", ":12"],
    );
    refused(
        &set("\"1 in\"", "{ upper = 1, lower = 1 }"),
        &["intermediate` is missing"],
    );
    refused(
        &set("offset =", "plate_size = [1, 2, 3]\noffset ="),
        &["bearing.plate_size", "two"],
    );
    refused(
        &set("\"0.75 in\"", "\"0.75 in\"\nsolid = true"),
        &[
            "bearing.roller_wall = \"0.75 in\"",
            "contradicts `bearing.solid = true`",
        ],
    );
    let end = |value: &str| set("offset =", &format!("roller_end = {value}\noffset ="));
    refused(
        &end("\"round\""),
        &["bearing.roller_end = \"round\"", "{ radius = … }"],
    );
    refused(
        &end("{ radius = 0.8 }"),
        &["bearing.roller_end.radius = 0.8", "at most 0.375"],
    );
    refused(
        &end("{ crown = 0 }"),
        &["bearing.roller_end.crown = 0", "must be more than 0"],
    );
    refused(
        &end("{ radius = 0.3, crown = 0.2 }"),
        &[
            "bearing.roller_end.crown = 0.2",
            "takes 0.5 with the radius, and at most 0.375 is left (half the wall)",
        ],
    );
    refused(&end("{ }"), &["must have radius, crown, or both"]);
}

#[test]
fn impossible_stages_of_a_load() {
    for (stages, parts) in [
        (
            r#"["20 kip", "10 kip"]"#,
            ["bearing.stages#2", "10 kip", "more than the stage before"],
        ),
        (
            r#"["20 kip", "65 kip"]"#,
            ["bearing.stages#2", "65 kip", "less than `bearing.load`"],
        ),
        (
            r#"["0 kip"]"#,
            ["bearing.stages#1", "0 kip", "must be positive"],
        ),
        (r#"["3 in"]"#, ["bearing.stages#1", "3 in", "a force"]),
        (
            r#""20 kip""#,
            ["bearing.stages", "array", "cases/test.toml:5"],
        ),
    ] {
        let load = format!("stages = {stages}\nload =");
        refused(&with(BEARING, "load =", &load), &parts);
    }
}

#[test]
fn a_displaced_bearing_needs_grip() {
    let displaced = with(BEARING, "\"0 in\"", "\"2.5 in\"");
    refused(
        &with(&displaced, "0.15", "0.03"),
        &["bearing.friction = 0.03", "tan(slope/2) = 0.0349", ":6"],
    );
}

#[test]
fn an_impossible_family_of_meshes() {
    let of = |lines: &str| with(SCENE, "file = \"blocks.msh\"", lines);
    refused(
        &of("family = \"problem-i\""),
        &["mesh.family = \"problem-i\"", "problem-h"],
    );
    refused(
        &of("family = \"problem-h\"\nlevel = 9"),
        &["mesh.level = 9", "between 1 and 8"],
    );
    refused(
        &of("family = \"problem-h\"\nfile = \"a.msh\""),
        &["`mesh.file` is not a key"],
    );
}

#[test]
fn an_impossible_mesh_preset() {
    refused(
        &with(BEARING, "h025", "h25"),
        &["mesh.preset = \"h25\"", "did you mean `h025`?"],
    );
    let with_size = |line: &str| format!("{BEARING}{line}\n");
    refused(
        &with_size("roller_size = \"0 in\""),
        &["mesh.roller_size = \"0 in\"", "1e-4 diameters", ":22"],
    );
    refused(
        &with_size("growth = 0.5"),
        &["mesh.growth = 0.5", "between 1 and 10"],
    );
    refused(
        &with_size("scale = 0"),
        &["mesh.scale = 0", "between 0.02 and 5"],
    );
    refused(
        &with_size("fine_elements = 100\nscale = 0.02"),
        &["`mesh.scale = 0.02`: makes `fine_elements` 5000"],
    );
    good(&with_size("scale = 3"));
    refused(
        &with_size("fine_layers = 1.5"),
        &["mesh.fine_layers = 1.5", "whole number"],
    );
    refused(
        &with_size("file = \"x.msh\""),
        &["`mesh.file` is not a key"],
    );
}

#[test]
fn a_bearing_is_not_a_scene() {
    let text = format!("{BEARING}[[support]]\nsurface = \"base\"\nfixed = \"x\"\n");
    refused(
        &text,
        &["brinell::case::conflict", "`support", "makes its own scene"],
    );
}

#[test]
fn impossible_controls() {
    let with_control = |line: &str| format!("{BEARING}[controls]\n{line}\n");
    refused(
        &with_control("residual = 0"),
        &["controls.residual = 0", "more than 0", ":23"],
    );
    refused(
        &with_control("first_increment = 2"),
        &["controls.first_increment = 2", "at most 1"],
    );
    refused(
        &with_control("smallest_increment = 0.5"),
        &[
            "controls.smallest_increment = 0.5",
            "more than first_increment, 0.25",
        ],
    );
    refused(
        &with_control("iterations = 0"),
        &["controls.iterations = 0", "1 or more"],
    );
    refused(
        &with_control("solver = \"spooles\""),
        &[
            "controls.solver",
            "spooles",
            "\"auto\", \"direct\" or \"divided\"",
        ],
    );
    refused(
        &with_control("element = \"c3d8\""),
        &[
            "controls.element",
            "c3d8",
            "\"bbar\", \"full\" or \"enhanced\"",
        ],
    );
    refused(
        &with_control("iterations = -3"),
        &["controls.iterations = -3"],
    );
    refused(
        &with_control("iterations = 99999999999999999999"),
        &["whole number"],
    );
}

#[test]
fn an_unknown_place_of_comparison() {
    let text = format!("{BEARING}[comparison]\nmises = {{ roller = \"49 ksi\" }}\n");
    refused(
        &text,
        &["comparison.mises.roller", "did you mean `rollers`?", ":23"],
    );
    let text = with(&text, "roller =", "rollers = -1 #");
    refused(
        &with(&text, " #", " } #"),
        &["comparison.mises.rollers = -1", "must be positive"],
    );
    unfit(
        &format!("{SCENE}[comparison.mises]\nuper = 3\n"),
        &["comparison.mises.uper", "did you mean `upper`?"],
    );
    unfit(
        &format!("{SCENE}[comparison.max_pressure]\nupper = 3\n"),
        &["comparison.max_pressure.upper", "is not an interface"],
    );
}

#[test]
fn an_impossible_contact() {
    let set = |old: &str, new: &str| with(SCENE, old, new);
    refused(
        &set("\"lower_face\"", "\"upper_face\""),
        &[
            "contact#1.lower = \"upper_face\"",
            "in contact with itself",
            ":14",
        ],
    );
    refused(
        &set("friction = 0.2", "friction = -0.2"),
        &["contact#1.friction = -0.2", ":15"],
    );
    refused(
        &set("friction = 0.2", "penalty_factor = 0"),
        &["contact#1.penalty_factor = 0", "must be positive"],
    );
    let plane = "{ plane = { point = [0, 0, \"1 mm\"], normal = [0, 0, 1] } }";
    refused(
        &set("\"lower_face\"", &format!("{plane}\ncarrier = \"lower\"")),
        &["contact#1.carrier = \"lower\"", "is a plane"],
    );
    refused(
        &set("\"lower_face\"", &plane.replace("0, 0, 1]", "0, 0, 0]")),
        &[
            "contact#1.lower.plane.normal = [0, 0, 0]",
            "must not be zero",
        ],
    );
    refused(
        &set("\"lower_face\"", &plane.replace(", 1]", "]")),
        &["contact#1.lower.plane.normal = [0, 0]", "three components"],
    );
    let planes = set("\"lower_face\"", plane);
    let other = plane.replace("1 mm", "2 mm");
    refused(
        &with(&planes, "\"upper_face\"", &other),
        &["both sides are planes"],
    );
    refused(
        &set("friction = 0.2", "carrier = \"both\""),
        &["upper, lower"],
    );
}

#[test]
fn duplicates() {
    let again = "[[contact]]\nupper = \"lower_face\"\nlower = \"upper_face\"\n";
    refused(
        &format!("{SCENE}{again}"),
        &["brinell::case::duplicate", "the same two sides", ":25"],
    );
    let named = "[[contact]]\nname = \"upper_face-lower_face\"\nupper = \"a\"\nlower = \"b\"\n";
    refused(
        &format!("{SCENE}{named}"),
        &["two contacts called `upper_face-lower_face`", ":25"],
    );
    let support = "[[support]]\nsurface = \"base\"\nfixed = \"x\"\n";
    refused(
        &format!("{SCENE}{support}"),
        &["already a support or load called `base`", "`name`"],
    );
    let steps = "[[step]]\nname = \"a\"\n[[step]]\nname = \"a\"\n";
    refused(
        &format!("{SCENE}{steps}"),
        &["step#2.name = \"a\"", "two steps called `a`"],
    );
    let bodies = "[[body]]\nname = \"upper\"\n[[body]]\nname = \"upper\"\n";
    refused(
        &format!("{SCENE}{bodies}"),
        &["two steels for one body", "body#2.name = \"upper\""],
    );
    let axes = with(SCENE, "[mesh]", "symmetry = [\"x\", \"x\"]\n[mesh]");
    refused(&axes, &["symmetry#2 = \"x\"", "given twice"]);
}

#[test]
fn two_steels_for_one_body() {
    let text = format!(
        "{SCENE}[steel.upper]\npoissons_ratio = 0.2\n\
         [[body]]\nname = \"upper\"\nsteel = {{ poissons_ratio = 0.1 }}\n"
    );
    refused(
        &text,
        &[
            "body#1.name = \"upper\"",
            "two steels for the body `upper`",
            ":27",
        ],
    );
}

#[test]
fn an_impossible_support_or_load() {
    let set = |old: &str, new: &str| with(SCENE, old, new);
    refused(
        &set("\"xyz\"", "\"xw\""),
        &["support#1.fixed = \"xw\"", "letters x, y, z", ":19"],
    );
    refused(
        &set("\"xyz\"", "\"xx\""),
        &["support#1.fixed = \"xx\"", "each once"],
    );
    refused(
        &set("fixed = \"xyz\"\n", ""),
        &["the support `base` holds nothing", ":17"],
    );
    refused(
        &set(
            "fixed = \"xyz\"",
            "fixed = \"xyz\"\ndisplacement = { z = 1 }",
        ),
        &["support#1.displacement.z = 1", "already fixed"],
    );
    refused(&set("\"10 MPa\"", "0"), &["the case has no load"]);
    let off = "[[step]]\nname = \"off\"\nfactor = 0\n";
    refused(&format!("{SCENE}{off}"), &["the case has no load"]);
    let plane = "[[rigid_plane]]\nname = \"lid\"\nsurface = \"top\"\nfixed = \"xy\"\n";
    refused(
        &format!("{SCENE}{plane}force = {{ x = \"1 N\" }}\n"),
        &["force.x", "already fixed"],
    );
    let half = with(SCENE, "[mesh]", "symmetry = [\"z\"]\n[mesh]");
    refused(
        &format!("{half}{plane}force = {{ z = \"1 N\" }}\n"),
        &[
            "rigid_plane#1.force.z = \"1 N\"",
            "breaks the symmetry about z = 0",
        ],
    );
    refused(
        &format!("{SCENE}[[step]]\nname = \"push\"\nfactors = {{ tip = 0.5 }}\n"),
        &["step#1.factors.tip", "did you mean `top`?", "base, top"],
    );
}

#[test]
fn names_that_the_mesh_does_not_have() {
    unfit(
        &with(SCENE, "\"lower_face\"", "\"lower_fase\""),
        &[
            "brinell::case::unknown_name",
            "contact#1.lower = \"lower_fase\"",
            "the mesh toy.msh has no surface called `lower_fase`",
            "did you mean `lower_face`?",
            "base, lower_face, upper_face, top, side",
            ":14",
        ],
    );
    unfit(
        &with(SCENE, "\"base\"", "\"bed\""),
        &["support#1.surface = \"bed\"", ":18"],
    );
    unfit(
        &with(SCENE, "\"top\"", "\"lid\""),
        &["pressure#1.surface = \"lid\"", ":22"],
    );
    unfit(
        &format!("{SCENE}[steel.uper]\npoissons_ratio = 0.2\n"),
        &[
            "steel.uper",
            "did you mean `upper`? there are: lower, upper",
        ],
    );
    unfit(
        &format!("{SCENE}[[body]]\nname = \"third\"\n"),
        &["body#1.name = \"third\"", "upper"],
    );
    let plane = "[[rigid_plane]]\nsurface = \"lid\"\nforce = { z = -1 }\n";
    unfit(
        &format!("{SCENE}{plane}"),
        &["rigid_plane#1.surface = \"lid\""],
    );
    let none = with(SCENE, "[steel]", "[steel.upper]");
    unfit(&none, &["the body `lower` has no steel", "[steel.lower]"]);
}

#[test]
fn a_mesh_on_both_sides_of_a_symmetry_plane() {
    let half = with(SCENE, "[mesh]", "symmetry = [\"x\"]\n[mesh]");
    let mut mesh = blocks();
    for point in &mut mesh.points {
        point[0] -= 0.5;
    }
    let error = good(&half).scene(mesh).unwrap_err();
    has(
        &render(&error),
        &[
            "brinell::case::mesh",
            "both sides of x = 0",
            "from -0.5 to 0.5",
        ],
    );
}

/// Cutting a case short or garbling a byte gives a case or an error, never a panic.
#[test]
fn no_text_makes_it_panic() {
    for text in [BEARING, SCENE] {
        for end in 0..text.len() {
            let _ = parse("cut.toml", &text[..end]);
        }
        for at in 0..text.len() {
            for garbage in ["µ", "\"", "0", "\n", "[", "-", "{"] {
                let garbled = format!("{}{garbage}{}", &text[..at], &text[at + 1..]);
                if let Err(error) = parse("garbled.toml", &garbled) {
                    render(&error);
                }
            }
        }
    }
}
