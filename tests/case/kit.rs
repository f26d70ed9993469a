//! What the tests of case files share: texts, toy meshes, and rendered errors.

use brinell::case::{Case, CaseError, parse};
use brinell::model::mesh::{Body, Face, Mesh, Surface};

/// A bearing in which everything is said.
pub const BEARING: &str = r#"title = "a bearing"
units = "in-kip-ksi"

[bearing]
load = "65 kip"
friction = 0.15
roller_diameter = "3 in"
roller_wall = "0.75 in"
roller_length = "8 in"
offset = "0 in"
slope = "4 deg"
plate_thickness = "1 in"

[steel]
youngs_modulus = "29500 ksi"
poissons_ratio = 0.3
yield_stress = "100 ksi"
hardening = { stress = "138 ksi", strain = 0.157 }

[mesh]
preset = "h025"
"#;

/// A general scene: one block on another.
pub const SCENE: &str = r#"title = "two blocks"
units = "mm-N-MPa"

[mesh]
file = "blocks.msh"

[steel]
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
elastic = true

[[contact]]
upper = "upper_face"
lower = "lower_face"
friction = 0.2

[[support]]
surface = "base"
fixed = "xyz"

[[pressure]]
surface = "top"
value = "10 MPa"
"#;

/// The case of `text`.
pub fn good(text: &str) -> Case {
    parse("cases/test.toml", text).unwrap_or_else(|error| panic!("{}", render(&error)))
}

/// The error of `text`, as it is printed.
pub fn bad(text: &str) -> String {
    match parse("cases/test.toml", text) {
        Ok(_) => panic!("this case should be refused:\n{text}"),
        Err(error) => render(&error),
    }
}

/// The printed form of an error, without colours.
pub fn render(error: &CaseError) -> String {
    let theme = miette::GraphicalTheme::unicode_nocolor();
    let handler = miette::GraphicalReportHandler::new_themed(theme).with_width(200);
    let mut text = String::new();
    handler.render_report(&mut text, error).unwrap();
    text
}

/// `text` with `old` replaced, which must be there.
pub fn with(text: &str, old: &str, new: &str) -> String {
    assert!(text.contains(old), "`{old}` is not in the text");
    text.replacen(old, new, 1)
}

/// Boxes of one hexahedron each: name, lowest and highest corner.
pub type Boxes<'a> = &'a [(&'a str, [f64; 3], [f64; 3])];

/// A mesh of boxes; `surfaces` gives a name, a box and one of its faces as `-x` … `+z`.
pub fn mesh(boxes: Boxes, surfaces: &[(&str, usize, &str)]) -> Mesh {
    let mut mesh = Mesh {
        source: "toy.msh".to_string(),
        ..Mesh::default()
    };
    for (i, (name, low, high)) in boxes.iter().enumerate() {
        let first = mesh.points.len() as u32;
        let high_ends = [[0, 0], [1, 0], [1, 1], [0, 1]];
        for w in 0..2 {
            for [u, v] in high_ends {
                let at = |axis: usize, end: i32| if end == 0 { low[axis] } else { high[axis] };
                mesh.points.push([at(0, u), at(1, v), at(2, w)]);
            }
        }
        mesh.hexes.push([0, 1, 2, 3, 4, 5, 6, 7].map(|n| first + n));
        mesh.bodies.push(Body {
            name: name.to_string(),
            elements: i..i + 1,
        });
    }
    for (name, element, side) in surfaces {
        let corners = match *side {
            "-x" => [0, 4, 7, 3],
            "+x" => [1, 2, 6, 5],
            "-y" => [0, 1, 5, 4],
            "+y" => [2, 3, 7, 6],
            "-z" => [0, 3, 2, 1],
            _ => [4, 5, 6, 7],
        };
        let nodes = corners.map(|c| mesh.hexes[*element][c]);
        let face = Face {
            nodes,
            element: *element as u32,
        };
        mesh.surfaces.push(Surface {
            name: name.to_string(),
            faces: vec![face],
        });
    }
    mesh
}

/// The two blocks of [`SCENE`], each 1 x 1 x 1 mm.
pub fn blocks() -> Mesh {
    mesh(
        &[
            ("lower", [0.0; 3], [1.0; 3]),
            ("upper", [0.0, 0.0, 1.0], [1.0, 1.0, 2.0]),
        ],
        &[
            ("base", 0, "-z"),
            ("lower_face", 0, "+z"),
            ("upper_face", 1, "-z"),
            ("top", 1, "+z"),
            ("side", 0, "-x"),
        ],
    )
}

/// The shipped mesh `name` of the reference study.
pub fn shipped(name: &str) -> Mesh {
    let path = format!(
        "{}/meshes/section-2.6.2/{name}.msh.gz",
        env!("CARGO_MANIFEST_DIR")
    );
    brinell::model::mesh::msh::read(std::path::Path::new(&path)).expect(&path)
}

/// The mesh of [`BEARING`].
pub fn centred() -> Mesh {
    shipped("initial-centre-h025")
}

/// The mesh of [`BEARING`] with rollers 2.5 in off.
pub fn displaced() -> Mesh {
    shipped("initial-offset-2.5-h025")
}
