//! One geometry, meshed by gmsh itself and written in every format that is read, gives one mesh.
//!
//! Source of the expected numbers: the geometry `fixtures/two-boxes.geo`, counted by hand.

use std::io::Write;
use std::path::Path;
use std::process::Command;

use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::mesh::hexahedron::{CORNERS, mirrored};
use brinell::model::mesh::msh::{parse, parse_with_notes, read, write};

const FORMATS: [(&str, bool); 4] = [
    ("msh41", false),
    ("msh41", true),
    ("msh22", false),
    ("msh22", true),
];

/// The bytes that gmsh writes for `fixtures/<geo>`, with `more` options.
fn meshed(geo: &str, format: &str, binary: bool, more: &[&str]) -> Vec<u8> {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.msh");
    let geo = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/fixtures")
        .join(geo);
    let gmsh = std::env::var_os("BRINELL_GMSH").unwrap_or("gmsh".into());
    let mut command = Command::new(gmsh);
    command
        .args(["-3", "-v", "2", "-format", format])
        .args(more);
    if binary {
        command.arg("-bin");
    }
    let status = command.arg("-o").arg(&out).arg(geo).status();
    assert!(
        status
            .expect("gmsh must be installed for this test")
            .success()
    );
    std::fs::read(out).unwrap()
}

fn area(mesh: &Mesh, surface: &str) -> [f64; 3] {
    let faces = &mesh.surface(surface).unwrap().faces;
    faces
        .iter()
        .map(|f| f.area_vector(mesh))
        .fold([0.0; 3], |s, a| [0, 1, 2].map(|k| s[k] + a[k]))
}

#[test]
fn four_formats_give_the_same_mesh() {
    let meshes = FORMATS.map(|(format, binary)| {
        parse(
            &meshed("two-boxes.geo", format, binary, &[]),
            "two-boxes.msh",
        )
        .unwrap_or_else(|error| panic!("{format} {binary}: {error}"))
    });
    let [mesh, others @ ..] = &meshes;
    for (k, other) in others.iter().enumerate() {
        // Text carries 16 digits, one short of all that a number can need.
        assert_eq!(
            (&mesh.hexes, &mesh.bodies),
            (&other.hexes, &other.bodies),
            "{:?}",
            FORMATS[k + 1]
        );
        assert_eq!(mesh.surfaces, other.surfaces, "{:?}", FORMATS[k + 1]);
        assert_eq!(mesh.points.len(), other.points.len());
        for (p, q) in mesh
            .points
            .iter()
            .flatten()
            .zip(other.points.iter().flatten())
        {
            assert!((p - q).abs() <= 1e-15, "{:?}: {p:?} {q:?}", FORMATS[k + 1]);
        }
    }
    assert_eq!(meshes[0], meshes[2]);
    assert_eq!(meshes[1], meshes[3]);
}

#[test]
fn bodies_and_surfaces_are_those_of_the_geometry() {
    let mesh = parse(
        &meshed("two-boxes.geo", "msh41", true, &[]),
        "two-boxes.msh",
    )
    .unwrap();
    assert_eq!((mesh.points.len(), mesh.hexes.len()), (63, 20));
    let bodies: Vec<_> = mesh
        .bodies
        .iter()
        .map(|b| (b.name.as_str(), b.elements.clone()))
        .collect();
    assert_eq!(bodies, [("upper box", 0..8), ("lower", 8..20)]);
    let surfaces: Vec<_> = mesh
        .surfaces
        .iter()
        .map(|s| (s.name.as_str(), s.faces.len()))
        .collect();
    assert_eq!(surfaces, [("all sides", 16), ("top", 4), ("surface_30", 8)]);

    // The top of the unit cube faces up; its four other sides in the group give -y, +x, -z, +z.
    let expected = [
        ("top", [0.0, 0.0, 1.0]),
        ("all sides", [1.0, -1.0, 0.0]),
        ("surface_30", [0.0; 3]),
    ];
    for (name, exact) in expected {
        let found = area(&mesh, name);
        assert!(
            (0..3).all(|k| (found[k] - exact[k]).abs() < 1e-12),
            "{name}: {found:?}"
        );
    }
    let quality = mesh.quality();
    assert!((quality[0].volume - 1.0).abs() < 1e-12 && (quality[1].volume - 1.0).abs() < 1e-12);
    for surface in &mesh.surfaces {
        for face in &surface.faces {
            let hex = mesh.hexes[face.element as usize];
            assert!(face.nodes.iter().all(|n| hex.contains(n)));
        }
    }
}

#[test]
fn gzip_is_recognised_by_content() {
    let plain = meshed("two-boxes.geo", "msh41", true, &[]);
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    encoder.write_all(&plain).unwrap();
    let packed = encoder.finish().unwrap();
    assert_eq!(parse(&packed, "a").unwrap(), parse(&plain, "a").unwrap());

    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("packed.msh");
    std::fs::write(&path, &packed).unwrap();
    assert_eq!(read(&path).unwrap().source, path.display().to_string());
    let cut = parse(&packed[..packed.len() / 2], "cut.msh.gz")
        .unwrap_err()
        .to_string();
    assert!(cut.contains("cut.msh.gz") && cut.contains("gzip"), "{cut}");
}

#[test]
fn comments_carry_the_fingerprint_and_unknown_sections_are_passed() {
    let plain = meshed("two-boxes.geo", "msh41", true, &[]);
    let mut bytes = b"$Comments\nbrinell-fingerprint: 12ab 34\n$EndComments\n".to_vec();
    bytes.extend(&plain);
    bytes.extend(
        b"$NodeData\n1\n\"$EndOfAll\"\n$EndNodeData\n$Comments\nmade by hand\n$EndComments",
    );
    let mesh = parse(&bytes, "a").unwrap();
    assert_eq!(mesh.fingerprint.as_deref(), Some("12ab 34"));
    assert_eq!(mesh.hexes, parse(&plain, "a").unwrap().hexes);
}

/// gmsh writes the centres of arcs (one at each end) as nodes of point elements when it is asked
/// to save all.
#[test]
fn nodes_of_ungrouped_points_are_left_out_with_a_note() {
    // In MSH 2.2 gmsh then forgets the physical groups.
    for (format, binary) in [("msh41", false), ("msh41", true)] {
        let bytes = meshed("quarter-tube.geo", format, binary, &["-save_all"]);
        let reading = parse_with_notes(&bytes, "tube.msh").unwrap();
        assert_eq!(
            (reading.mesh.points.len(), reading.mesh.hexes.len()),
            (30, 8),
            "{format}"
        );
        let [note] = &reading.notes[..] else {
            panic!("{:?}", reading.notes)
        };
        assert!(note.contains("tube.msh: 2 nodes"), "{note}");
        let only_groups = parse(&meshed("quarter-tube.geo", format, binary, &[]), "tube.msh");
        assert_eq!(only_groups.unwrap().hexes.len(), 8);
    }
}

/// The same numbers with the bytes of each turned round, as a big-endian machine writes them.
#[test]
fn big_endian_binary_is_read() {
    let mut out = b"$MeshFormat\n2.2 1 8\n".to_vec();
    let int = |out: &mut Vec<u8>, values: &[i32]| {
        values.iter().for_each(|v| out.extend(v.to_be_bytes()));
    };
    int(&mut out, &[1]);
    out.extend(b"\n$EndMeshFormat\n$Nodes\n8\n");
    for (tag, corner) in (10..).zip(CORNERS) {
        int(&mut out, &[tag]);
        corner.iter().for_each(|c| out.extend(c.to_be_bytes()));
    }
    out.extend(b"\n$EndNodes\n$Elements\n1\n");
    int(
        &mut out,
        &[5, 1, 2, 1, 4, 1, 10, 11, 12, 13, 14, 15, 16, 17],
    );
    out.extend(b"\n$EndElements\n");
    let mesh = parse(&out, "big.msh").unwrap();
    assert_eq!(mesh.bodies[0].name, "volume_4");
    assert_eq!(mesh.points, CORNERS);
    assert_eq!(mesh.hexes, [[0, 1, 2, 3, 4, 5, 6, 7]]);
}

#[test]
fn a_body_numbered_for_its_mirror_image_is_renumbered_and_noted() {
    let list = || uniform(0.0, 1.0, 2);
    let block = Block::new("block", list(), list(), list());
    let good = block.build().unwrap();
    let mut turned = good.clone();
    for hex in &mut turned.hexes {
        *hex = mirrored(*hex);
    }
    let reading = parse_with_notes(write::msh41(&turned).as_bytes(), &good.source).unwrap();
    assert_eq!(reading.mesh.hexes, good.hexes);
    assert_eq!(reading.mesh.surfaces, good.surfaces);
    assert!(reading.notes[0].contains("`block`") && reading.notes[0].contains("mirror"));
}

#[test]
fn windows_line_ends_are_read() {
    let list = || uniform(0.0, 1.0, 1);
    let mesh = Block::new("b", list(), list(), list()).build().unwrap();
    let text = write::msh22(&mesh).replace('\n', "\r\n");
    assert_eq!(parse(text.as_bytes(), &mesh.source).unwrap(), mesh);
}

#[test]
fn sparse_node_tags_are_read_in_the_order_of_the_file() {
    let tags = [900_000_000_000u64, 3, 77, 12, 5, 6, u64::MAX, 1];
    let mut text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n\
        9 0 0 0 1 1 1 1 4 0\n$EndEntities\n$Nodes\n1 8 1 900000000000\n3 9 0 8\n"
        .to_owned();
    tags.iter().for_each(|tag| text += &format!("{tag}\n"));
    CORNERS
        .iter()
        .for_each(|[x, y, z]| text += &format!("{x} {y} {z}\n"));
    text += "$EndNodes\n$Elements\n1 1 5 5\n3 9 5 1\n5";
    tags.iter().for_each(|tag| text += &format!(" {tag}"));
    text += "\n$EndElements";
    let mesh = parse(text.as_bytes(), "sparse.msh").unwrap();
    assert_eq!(mesh.points, CORNERS);
    assert_eq!(mesh.hexes, [[0, 1, 2, 3, 4, 5, 6, 7]]);
    assert_eq!(mesh.bodies[0].name, "volume_4");
}
