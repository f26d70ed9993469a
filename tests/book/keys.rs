//! Every key that the reference describes is read: a value of a type that no key takes is refused by
//! name.

use brinell::case::keys::{self, Keys};
use brinell::case::parse;

/// No key takes a date.
const DATE: &str = "2001-01-01";

const STEEL: &str = "[steel]\nyoungs_modulus = 1\npoissons_ratio = 0.3\n";
const SCENE: &str = "units = \"m-N-Pa\"\n";

/// Refused, naming `key`?
#[track_caller]
fn refused(text: &str, key: &str) {
    let error = match parse("case.toml", text) {
        Ok(_) => panic!("`{key}` is not read:\n{text}"),
        Err(error) => error.to_string(),
    };
    let known = !error.contains("is not a key");
    assert!(known && error.contains(key), "`{key}`: {error}\n{text}");
}

/// Puts the date in place of each key of `keys` in turn. `place` makes a case of the line and of what
/// the table needs besides.
#[track_caller]
fn all_read(keys: &Keys, others: &[(&str, &str)], place: impl Fn(&str) -> String) {
    for key in keys.names() {
        let beside = others.iter().filter(|(name, _)| *name != key);
        let beside: String = beside
            .map(|(name, value)| format!("{name} = {value}\n"))
            .collect();
        refused(&place(&format!("{beside}{key} = {DATE}\n")), key);
    }
}

/// The same of an inline table.
#[track_caller]
fn all_read_inline(keys: &Keys, others: &[(&str, &str)], place: impl Fn(&str) -> String) {
    all_read(keys, others, |lines| {
        place(&lines.trim_end().replace('\n', ", "))
    });
}

#[test]
fn keys_of_every_case_are_read() {
    let others = [
        ("units", "\"m-N-Pa\""),
        ("mesh", "{ file = \"a.msh\" }"),
        (
            "steel",
            "{ youngs_modulus = 1, poissons_ratio = 0.3, elastic = true }",
        ),
    ];
    all_read(&keys::ROOT, &others, |l| {
        format!("{l}[[pressure]]\nsurface = \"a\"\nvalue = 1\n")
    });
    all_read(&keys::SCENE, &[], |l| {
        format!("{SCENE}mesh = {{ file = \"a.msh\" }}\n{l}")
    });
    all_read(&keys::TITLE_BLOCK, &[], |l| {
        format!(
            "{SCENE}{STEEL}elastic = true\n[mesh]\nfile = \"a.msh\"\n[[pressure]]\nsurface = \"a\"\nvalue = 1\n[title_block]\n{l}"
        )
    });
    let steel = |l: &str| format!("{SCENE}[mesh]\nfile = \"a.msh\"\n[steel]\n{l}");
    // Of three keys for the hardening a steel has one.
    all_read(&keys::STEEL, &[], steel);
    let hardening = |l: &str| {
        steel(&format!(
            "youngs_modulus = 1\npoissons_ratio = 0.3\nyield_stress = 1\nhardening = {{ {l} }}\n"
        ))
    };
    let point = [("stress", "2"), ("strain", "0.1")];
    all_read_inline(&keys::HARDENING, &point, hardening);
    all_read(&keys::CONTROLS, &[], |l| {
        format!("{SCENE}{STEEL}[controls]\n{l}")
    });
    // Comparisons are read last, so the case around has to be whole.
    let whole = |l: &str| {
        format!(
            "{SCENE}{STEEL}elastic = true\n[mesh]\nfile = \"a.msh\"\n[[pressure]]\nsurface = \"a\"\n\
             value = 1\n[comparison]\n{l}"
        )
    };
    all_read(&keys::COMPARISON, &[], whole);
}

const BEARING: [(&str, &str); 8] = [
    ("load", "\"65 kip\""),
    ("friction", "0.15"),
    ("roller_diameter", "3"),
    ("roller_wall", "0.75"),
    ("roller_length", "8"),
    ("offset", "1"),
    ("slope", "\"4 deg\""),
    ("plate_thickness", "1"),
];

fn bearing(lines: &str) -> String {
    format!("units = \"in-kip-ksi\"\n[bearing]\n{lines}")
}

/// The bearing with one key otherwise, and what comes after it.
fn bearing_but(key: &str, value: &str, after: &str) -> String {
    let lines = BEARING.iter().filter(|(name, _)| *name != key);
    let lines: String = lines
        .map(|(name, value)| format!("{name} = {value}\n"))
        .collect();
    bearing(&format!("{lines}{key} = {value}\n{after}"))
}

#[test]
fn keys_of_a_bearing_are_read() {
    all_read(&keys::BEARING, &BEARING, bearing);
    let thick = [("upper", "1"), ("intermediate", "1"), ("lower", "1")];
    all_read_inline(&keys::PLATE_THICKNESS, &thick, |l| {
        bearing_but("plate_thickness", &format!("{{ {l} }}"), "")
    });
    all_read_inline(&keys::TILTED_TOP, &[], |l| {
        bearing_but("load", "65", &format!("top = {{ {l} }}"))
    });
    all_read_inline(&keys::ROLLER_END, &[], |l| {
        bearing_but("roller_end", &format!("{{ {l} }}"), "")
    });
    all_read(&keys::BEARING_MESH, &[], |l| {
        bearing_but("load", "65", &format!("[mesh]\n{l}"))
    });
}

#[test]
fn keys_of_a_scene_are_read() {
    let mesh = |l: &str| {
        format!(
            "{SCENE}{STEEL}elastic = true\n[[pressure]]\nsurface = \"a\"\nvalue = 1\n[mesh]\n{l}"
        )
    };
    all_read(&keys::FILE_MESH, &[("file", "\"a.msh\"")], mesh);
    all_read(&keys::FAMILY_MESH, &[("family", "\"problem-h\"")], mesh);
    let table = |heading: &str| {
        let heading = heading.to_string();
        move |l: &str| {
            format!("{SCENE}{STEEL}elastic = true\n[mesh]\nfile = \"a.msh\"\n[[{heading}]]\n{l}")
        }
    };
    all_read(&keys::BODY, &[("name", "\"a\"")], table("body"));
    let sides = [("upper", "\"a\""), ("lower", "\"b\"")];
    all_read(&keys::CONTACT, &sides, table("contact"));
    let contact = |l: &str| table("contact")(&format!("upper = \"a\"\nlower = {{ {l} }}\n"));
    all_read_inline(&keys::PARTNER, &[], contact);
    let plane = [("point", "[0, 0, 0]"), ("normal", "[0, 0, 1]")];
    all_read_inline(&keys::PLANE, &plane, |l| {
        contact(&format!("plane = {{ {l} }}"))
    });
    all_read(&keys::TIE, &[("surfaces", "[\"a\", \"b\"]")], table("tie"));
    let surface = [("surface", "\"a\"")];
    all_read(&keys::SUPPORT, &surface, table("support"));
    let heated = [("body", "\"a\""), ("value", "1")];
    all_read(&keys::TEMPERATURE, &heated, table("temperature"));
    all_read(&keys::RIGID_PLANE, &surface, table("rigid_plane"));
    let axes = |key: &'static str| {
        move |l: &str| table("rigid_plane")(&format!("surface = \"a\"\n{key} = {{ {l} }}\n"))
    };
    all_read_inline(&keys::AXES, &[], axes("displacement"));
    all_read_inline(&keys::AXES, &[], axes("force"));
    all_read_inline(&keys::AXES, &[], |l| axes("fixed = \"xyz\"\nrotation")(l));
    all_read_inline(&keys::AXES, &[], |l| {
        axes("fixed = \"xyz\"\nturns = \"xyz\"\nmoment")(l)
    });
    for load in ["pressure", "traction"] {
        all_read(&keys::LOAD, &surface, table(load));
    }
    all_read(&keys::STEP, &[("name", "\"a\"")], table("step"));
}
