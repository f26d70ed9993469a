//! Every kind of wrong mesh file is refused with an error that names the place.
//!
//! Source: two cubes side by side, written out by hand in MSH 2.2 and 4.1; every test spoils
//! one thing in one of them.

use brinell::model::mesh::msh::{MeshError, parse};
use miette::Diagnostic;

/// Nodes 1 to 12 at x = 0, 1, 2 (fastest), y = 0, 1, z = 0, 1; two hexahedra; the base.
const V2: &str = "$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 \"base\"
3 2 \"block\"
$EndPhysicalNames
$Nodes
12
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
7 0 0 1
8 1 0 1
9 2 0 1
10 0 1 1
11 1 1 1
12 2 1 1
$EndNodes
$Elements
4
21 3 2 1 1 1 2 5 4
22 3 2 1 1 2 3 6 5
31 5 2 2 1 1 2 5 4 7 8 11 10
32 5 2 2 1 2 3 6 5 8 9 12 11
$EndElements
";

const V4: &str = "$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 \"base\"
3 2 \"block\"
$EndPhysicalNames
$Entities
0 0 1 1
7 0 0 0 2 1 0 1 1 0
8 0 0 0 2 1 1 1 2 0
$EndEntities
$Nodes
2 12 1 12
2 7 0 6
1
2
3
4
5
6
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1 0
3 8 0 6
7
8
9
10
11
12
0 0 1
1 0 1
2 0 1
0 1 1
1 1 1
2 1 1
$EndNodes
$Elements
2 4 21 32
2 7 3 2
21 1 2 5 4
22 2 3 6 5
3 8 5 2
31 1 2 5 4 7 8 11 10
32 2 3 6 5 8 9 12 11
$EndElements
";

/// `text` with `from`, which is there, made `to`.
fn spoiled(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

/// The text is refused with `code`, in words that contain all of `words`, and with help.
#[track_caller]
fn refused(text: impl AsRef<[u8]>, code: &str, words: &[&str]) -> MeshError {
    let error = parse(text.as_ref(), "part.msh").expect_err("the file is wrong");
    let message = error.to_string();
    assert_eq!(
        error.code().unwrap().to_string(),
        format!("brinell::mesh::{code}"),
        "{message}"
    );
    for word in words.iter().chain(&["part.msh"]) {
        assert!(message.contains(word), "`{word}` is not in: {message}");
    }
    assert!(error.help().is_some());
    error
}

#[test]
fn the_files_are_right_before_they_are_spoiled() {
    let meshes = [V2, V4].map(|text| parse(text.as_bytes(), "part.msh").unwrap());
    assert_eq!(meshes[0], meshes[1]);
    assert_eq!(meshes[0].surfaces[0].faces.len(), 2);
}

#[test]
fn a_missing_file() {
    let error = brinell::model::mesh::msh::read("no/such/part.msh".as_ref()).unwrap_err();
    assert!(error.to_string().contains("no/such/part.msh"));
}

#[test]
fn something_else_than_a_mesh() {
    refused("solid part\nfacet normal", "not_msh", &[]);
    refused("", "not_msh", &[]);
    refused(
        "$Nodes\n0\n$EndNodes\n",
        "missing_section",
        &["$MeshFormat"],
    );
}

#[test]
fn another_version() {
    refused(spoiled(V4, "4.1 0", "4.0 0"), "version", &["line 2", "4.0"]);
    refused(
        spoiled(V4, "4.1 0", "4.1 7"),
        "version",
        &["line 2", "encoding `7`"],
    );
    refused(
        spoiled(V4, "0 8\n", "0 4\n"),
        "version",
        &["line 2", "`4` bytes"],
    );
}

#[test]
fn unknown_node_tags() {
    let text = spoiled(V2, "2 3 6 5 8 9 12 11", "2 3 6 5 8 9 99 11");
    refused(
        text,
        "unknown_node",
        &["line 29", "$Elements", "element 32", "node 99"],
    );
    let text = spoiled(V4, "32 2 3 6 5 8 9 12", "32 2 3 6 5 8 9 99");
    refused(text, "unknown_node", &["line 50", "element 32", "node 99"]);
    // Also in an element that would not be needed.
    let text = spoiled(V2, "\n4\n21", "\n5\n5 15 2 0 1 77\n21");
    refused(text, "unknown_node", &["line 26", "element 5", "node 77"]);
}

#[test]
fn duplicate_tags() {
    refused(
        spoiled(V2, "\n5 1 1 0", "\n4 1 1 0"),
        "duplicate_tag",
        &["line 15", "node 4", "line 14"],
    );
    refused(
        spoiled(V2, "\n32 5", "\n31 5"),
        "duplicate_tag",
        &["line 29", "element 31", "line 28"],
    );
    refused(
        spoiled(V2, "\n3 2 \"b", "\n2 1 \"b"),
        "duplicate_tag",
        &["line 7", "surface 1", "line 6"],
    );
    let text = spoiled(V4, "0 0 1 1\n", "0 0 2 1\n7 0 0 0 2 1 0 1 1 0\n");
    refused(text, "duplicate_tag", &["line 12", "surface 7", "line 11"]);
}

#[test]
fn volumes_that_are_not_hexahedra() {
    let text = spoiled(V2, "31 5 2 2 1 1 2 5 4 7 8 11 10", "31 4 2 2 1 1 2 5 7");
    refused(
        text,
        "not_hexahedron",
        &["line 28", "element 31", "`block`", "four-node tetrahedron"],
    );
    let text = spoiled(
        V2,
        "32 5 2 2 1 2 3 6 5 8 9 12 11",
        "32 6 2 2 1 2 3 6 8 9 12",
    );
    refused(text, "not_hexahedron", &["element 32", "`block`", "prism"]);
    let text = spoiled(V2, "4 7 8 11 10", "4 7 8 11 10 1 2 3 4 5 6 7 8 9 10 11 12");
    let text = spoiled(&text, "31 5", "31 17");
    refused(
        text,
        "not_hexahedron",
        &["element 31", "20-node hexahedron"],
    );
}

#[test]
fn surfaces_that_are_not_quadrilaterals() {
    let text = spoiled(V2, "21 3 2 1 1 1 2 5 4", "21 2 2 1 1 1 2 5");
    refused(
        text,
        "not_quadrilateral",
        &["line 26", "element 21", "`base`", "triangle"],
    );
}

#[test]
fn an_unknown_element_type() {
    refused(
        spoiled(V2, "31 5", "31 555"),
        "syntax",
        &["line 28", "element type", "555"],
    );
    refused(
        spoiled(V4, "3 8 5 2", "3 8 3 2"),
        "syntax",
        &["line 48", "dimension 3", "quadrilateral"],
    );
}

#[test]
fn inverted_elements() {
    // Only one of the two elements is numbered for its mirror image.
    let text = spoiled(V2, "2 3 6 5 8 9 12 11", "8 9 12 11 2 3 6 5");
    refused(
        text,
        "inverted",
        &["line 29", "element 32", "`block`", "-1.000"],
    );
    // A node moved through the element.
    let text = spoiled(V4, "\n2 1 1\n$End", "\n0.5 0.5 -1\n$End");
    refused(
        text,
        "inverted",
        &["line 50", "element 32", "`block`", "node 6"],
    );
}

#[test]
fn degenerate_elements() {
    let text = spoiled(V2, "8 9 12 11\n", "8 9 12 12\n");
    refused(
        text,
        "degenerate",
        &["line 29", "element 32", "`block`", "node 12 twice"],
    );
    let text = spoiled(V2, "\n12 2 1 1", "\n12 2 0 1");
    refused(
        text,
        "degenerate",
        &["line 29", "element 32", "flat", "node 9"],
    );
    let text = V2.replace(" 1\n", " 0\n");
    refused(text, "degenerate", &["line 28", "element 31"]);
}

#[test]
fn the_same_hexahedron_twice() {
    let text = spoiled(
        V2,
        "32 5 2 2 1 2 3 6 5 8 9 12 11",
        "32 5 2 4 1 1 2 5 4 7 8 11 10",
    );
    refused(
        text,
        "repeated_element",
        &["line 29", "31", "32", "`block`", "`volume_4`"],
    );
}

#[test]
fn missing_groups() {
    refused(V2.replace("5 2 2 1", "5 2 0 1"), "no_physical_volume", &[]);
    refused(
        spoiled(V4, "1 1 1 2 0", "1 1 1 0 0"),
        "no_physical_volume",
        &[],
    );
    refused(
        spoiled(V4, "1 1 1 2 0", "1 1 0 0"),
        "no_physical_volume",
        &[],
    );
    refused(
        V2.replace("\n31 5 2 2 1", "\n31 5 2 0 1"),
        "ungrouped_volume",
        &["line 28", "element 31", "volume 1"],
    );
    let text = spoiled(V4, "1 1 1 2 0", "1 1 2 2 5 0");
    refused(
        text,
        "several_volumes",
        &["line 49", "volume 8", "`block`", "`volume_5`"],
    );
    let text: String = V4
        .lines()
        .take(8)
        .chain(V4.lines().skip(13))
        .map(|l| format!("{l}\n"))
        .collect();
    refused(text, "missing_section", &["$Entities"]);
    refused(
        spoiled(V4, "\n3 8 5", "\n3 9 5"),
        "unknown_entity",
        &["line 49", "volume 9", "$Entities"],
    );
    let flat = V2.lines().filter(|l| !l.starts_with('3') || l.len() < 20);
    let text = flat
        .map(|l| format!("{l}\n"))
        .collect::<String>()
        .replace("\n4\n", "\n2\n");
    refused(text, "no_volumes", &[]);
}

#[test]
fn groups_without_elements_or_names() {
    let text = spoiled(V2, "\n2\n2 1", "\n3\n3 9 \"roller\"\n2 1");
    refused(text, "empty_group", &["volume `roller`", "9"]);
    let text = spoiled(V4, "0 0 1 1\n", "0 0 2 1\n6 0 0 0 2 1 0 1 1 0\n");
    refused(text, "empty_group", &["`base`", "surface 6"]);
    let text = spoiled(V2, "\"block\"", "\"\"");
    assert_eq!(
        parse(text.as_bytes(), "part.msh").unwrap().bodies[0].name,
        "volume_2"
    );
    let text = spoiled(V2, "\n2\n2 1", "\n3\n3 4 \"block\"\n2 1");
    let text = spoiled(&text, "\n32 5 2 2", "\n32 5 2 4");
    refused(text, "duplicate_name", &["volume", "`block`"]);
    refused(
        spoiled(V2, "\"block\"", "block"),
        "syntax",
        &["line 7", "block"],
    );
}

#[test]
fn nodes_that_no_element_uses() {
    let text = spoiled(V4, "2 12 1 12\n", "3 13 1 13\n1 44 0 1\n13\n5 5 5\n");
    refused(
        text,
        "unused_node",
        &["line 17", "$Nodes", "node 13", "curve 44", "no element"],
    );
    let text = spoiled(V2, "\n12\n1 ", "\n13\n13 5 5 5\n1 ");
    refused(&text, "unused_node", &["line 11", "node 13"]);
    // Used by a physical point.
    let text = spoiled(&text, "\n4\n21", "\n5\n20 15 2 6 1 13\n21");
    refused(
        text,
        "unused_node",
        &["line 11", "node 13", "physical point `point_6`"],
    );
}

#[test]
fn surface_faces_that_fit_no_hexahedron() {
    let text = spoiled(V2, "21 3 2 1 1 1 2 5 4", "21 3 2 1 1 1 3 6 4");
    refused(
        text,
        "surface_face",
        &[
            "line 26",
            "element 21",
            "`base`",
            "no hexahedron",
            "1, 3, 6, 4",
        ],
    );
    let text = spoiled(V2, "21 3 2 1 1 1 2 5 4", "21 3 2 1 1 2 5 11 8");
    refused(
        &text,
        "surface_face",
        &["line 26", "`base`", "inside", "`block`"],
    );
    let text = text.replace("\n32 5 2 2", "\n32 5 2 4");
    refused(
        text,
        "surface_face",
        &["element 21", "between", "`block`", "`volume_4`"],
    );
    let text = spoiled(V2, "22 3 2 1 1 2 3 6 5", "22 3 2 1 1 4 1 2 5");
    refused(
        text,
        "surface_face",
        &["line 27", "element 22", "same face as element 21"],
    );
}

#[test]
fn wrong_counts() {
    refused(
        spoiled(V2, "\n12\n", "\n11\n"),
        "surplus",
        &["line 22", "$Nodes", "12 2 1 1"],
    );
    refused(
        spoiled(V2, "\n12\n", "\n13\n"),
        "syntax",
        &["line 23", "a node", "$EndNodes"],
    );
    refused(
        spoiled(V2, "\n4\n21", "\n3\n21"),
        "surplus",
        &["line 29", "$Elements"],
    );
    refused(
        spoiled(V2, "\n4\n21", "\n5\n21"),
        "syntax",
        &["line 30", "$EndElements"],
    );
    refused(
        spoiled(V4, "2 12 1 12", "2 13 1 12"),
        "count",
        &["$Nodes", "13", "12"],
    );
    refused(
        spoiled(V4, "2 12 1 12", "2 11 1 12"),
        "count",
        &["line 29", "11 nodes", "12"],
    );
    refused(
        spoiled(V4, "2 4 21 32", "2 3 21 32"),
        "count",
        &["line 48", "3 elements", "4"],
    );
    refused(
        spoiled(V4, "2 4 21 32", "3 4 21 32"),
        "syntax",
        &["line 51", "$EndElements"],
    );
    refused(
        spoiled(V4, "2 12 1 12", "1 12 1 12"),
        "count",
        &["line 29", "12 nodes", "6"],
    );
    refused(
        spoiled(V2, "\n2\n2 1", "\n3\n2 1"),
        "syntax",
        &["line 8", "physical name"],
    );
    refused(
        spoiled(V2, "\n2\n2 1", "\n1\n2 1"),
        "surplus",
        &["line 7", "$PhysicalNames"],
    );
}

#[test]
fn hostile_counts() {
    refused(
        spoiled(V2, "\n12\n", "\n1000000000000\n"),
        "count",
        &["line 11", "1000000000000 nodes"],
    );
    refused(
        spoiled(V4, "2 12 1 12", "2 18446744073709551615 1 12"),
        "count",
        &["18446744073709551615"],
    );
    refused(
        spoiled(V4, "2 7 0 6", "2 7 0 18446744073709551615"),
        "count",
        &["line 16"],
    );
    refused(
        spoiled(V4, "0 0 1 1\n", "999999999999 0 1 1\n"),
        "count",
        &["entities"],
    );
    refused(
        spoiled(V4, "2 4 21 32", "2 999999999999 21 32"),
        "count",
        &["elements"],
    );
    refused(
        spoiled(V2, "31 5 2 2", "31 5 99999999999 2"),
        "syntax",
        &["line 28"],
    );
    refused(
        spoiled(V2, "\n12\n", "\n99999999999999999999999\n"),
        "syntax",
        &["line 10"],
    );
    // The same in binary.
    let mut bytes = b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n".to_vec();
    for number in [1u64, 1 << 40, 1, 1 << 40] {
        bytes.extend(number.to_le_bytes());
    }
    refused(
        bytes,
        "count",
        &["byte 79", "$Nodes", "1099511627776 nodes"],
    );
}

#[test]
fn truncated_files() {
    for text in [V2, V4] {
        for end in 0..text.trim_end().len() {
            let error = parse(&text.as_bytes()[..end], "part.msh").expect_err("the end is missing");
            assert!(error.to_string().contains("part.msh"), "{error}");
        }
    }
    let half = &V2[..V2.find("\n7 0 0 1").unwrap() + 6];
    refused(half, "count", &["line 11", "12 nodes"]);
    let part = &V2[..V2.find(" 8 11 10").unwrap()];
    refused(part, "truncated", &["line 28", "$Elements", "node tag"]);
    refused(
        &V2[..V2.find("$Elements").unwrap()],
        "missing_section",
        &["$Elements"],
    );
    refused(
        &V2[..V2.find("$EndElements").unwrap()],
        "truncated",
        &["$EndElements"],
    );
}

#[test]
fn dangling_data() {
    refused(
        spoiled(V2, "$EndNodes\n", "$EndNodes\n13 1 1 1\n"),
        "syntax",
        &["line 24", "13 1 1 1"],
    );
    refused(format!("{V2}$EndElements\n"), "syntax", &["line 31"]);
    refused(
        spoiled(V2, "\n5 1 1 0", "\n5 1 1 0 0"),
        "syntax",
        &["line 15", "end of the line"],
    );
    refused(
        spoiled(V2, "\n5 1 1 0", "\n5 1 1"),
        "syntax",
        &["line 15", "coordinate"],
    );
    let twice = V2.find("$Nodes").unwrap()..V2.find("$Elements").unwrap();
    refused(
        format!("{V2}{}", &V2[twice]),
        "repeated_section",
        &["line 32", "$Nodes"],
    );
    refused(
        format!("{V2}$Periodic\n1\n"),
        "truncated",
        &["$EndPeriodic"],
    );
}

#[test]
fn coordinates_that_are_no_numbers() {
    refused(
        spoiled(V2, "\n5 1 1 0", "\n5 1 nan 0"),
        "not_finite",
        &["line 15", "node 5", "y", "NaN"],
    );
    refused(
        spoiled(V2, "\n5 1 1 0", "\n5 1 1 -inf"),
        "not_finite",
        &["line 15", "z", "-inf"],
    );
    refused(
        spoiled(V2, "\n5 1 1 0", "\n5 1 1e999 0"),
        "not_finite",
        &["line 15", "inf"],
    );
    refused(
        spoiled(V2, "\n5 1 1 0", "\n5 1 one 0"),
        "syntax",
        &["line 15", "`one`"],
    );
}

#[test]
fn damaged_compression() {
    refused([0x1f, 0x8b, 8, 0, 0, 0, 0], "gzip", &[]);
    let mut bomb = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    std::io::Write::write_all(&mut bomb, &vec![b' '; 64 << 20]).unwrap();
    refused(bomb.finish().unwrap(), "gzip", &["grow"]);
}
