//! Whatever the bytes are, reading a mesh returns: a mesh that holds together, or an error.
//!
//! Source: valid files as gmsh writes them (`fixtures/two-boxes.geo`), mutilated at random.

use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

use brinell::model::mesh::msh::parse;
use proptest::prelude::*;

/// The fixture in all four formats.
fn valid() -> &'static [Vec<u8>; 4] {
    static FILES: OnceLock<[Vec<u8>; 4]> = OnceLock::new();
    FILES.get_or_init(|| {
        [
            ("msh41", "0"),
            ("msh41", "1"),
            ("msh22", "0"),
            ("msh22", "1"),
        ]
        .map(|(format, binary)| {
            let dir = tempfile::tempdir().unwrap();
            let out = dir.path().join("out.msh");
            let geo = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/two-boxes.geo");
            let status = Command::new(std::env::var_os("BRINELL_GMSH").unwrap_or("gmsh".into()))
                .args([
                    "-3",
                    "-v",
                    "2",
                    "-format",
                    format,
                    "-setnumber",
                    "Mesh.Binary",
                    binary,
                    "-o",
                ])
                .arg(&out)
                .arg(geo)
                .status();
            assert!(
                status
                    .expect("gmsh must be installed for this test")
                    .success()
            );
            let bytes = std::fs::read(out).unwrap();
            assert!(bytes[16..].starts_with(format!("{binary} 8").as_bytes()));
            bytes
        })
    })
}

#[derive(Debug, Clone)]
enum Damage {
    Byte(usize, u8),
    Number(usize, [u8; 8]),
    Cut(usize),
    Remove(usize, usize),
    Repeat(usize, usize),
    Word(usize, &'static str),
}

const WORDS: [&str; 12] = [
    "-1",
    "0",
    "99999999999999999999",
    "18446744073709551615",
    "nan",
    "1e999",
    "$",
    "\n",
    "$Nodes\n",
    "$EndNodes\n",
    "\"",
    "2147483648",
];

fn damage() -> impl Strategy<Value = Damage> {
    let at = any::<usize>;
    prop_oneof![
        (at(), any::<u8>()).prop_map(|(k, byte)| Damage::Byte(k, byte)),
        (
            at(),
            prop_oneof![
                Just(u64::MAX),
                Just(1 << 63),
                Just(1 << 40),
                Just(0),
                any::<u64>()
            ]
        )
            .prop_map(|(k, number)| Damage::Number(k, number.to_le_bytes())),
        at().prop_map(Damage::Cut),
        (at(), 1..40usize).prop_map(|(k, n)| Damage::Remove(k, n)),
        (at(), 1..40usize).prop_map(|(k, n)| Damage::Repeat(k, n)),
        (at(), 0..WORDS.len()).prop_map(|(k, word)| Damage::Word(k, WORDS[word])),
    ]
}

fn inflict(bytes: &mut Vec<u8>, damage: &Damage) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    match *damage {
        Damage::Byte(k, byte) => bytes[k % length] = byte,
        Damage::Number(k, number) => {
            for (slot, byte) in bytes[k % length..].iter_mut().zip(number) {
                *slot = byte;
            }
        }
        Damage::Cut(k) => bytes.truncate(k % length),
        Damage::Remove(k, n) => {
            let from = k % length;
            bytes.drain(from..(from + n).min(length));
        }
        Damage::Repeat(k, n) => {
            let from = k % length;
            let copy = bytes[from..(from + n).min(length)].to_vec();
            bytes.splice(from..from, copy);
        }
        Damage::Word(k, word) => {
            // In place of the number that stands there.
            let from = k % length;
            let end = bytes[from..].iter().position(|b| b.is_ascii_whitespace());
            bytes.splice(from..end.map_or(length, |n| from + n), word.bytes());
        }
    }
}

/// Every index of a mesh that was accepted is in range.
fn holds_together(bytes: &[u8]) {
    let Ok(mesh) = parse(bytes, "damaged.msh") else {
        return;
    };
    let nodes = mesh.points.len() as u32;
    assert!(mesh.hexes.iter().flatten().all(|n| *n < nodes));
    assert!(mesh.points.iter().flatten().all(|c| c.is_finite()));
    assert_eq!(
        mesh.bodies.last().map(|b| b.elements.end),
        Some(mesh.hexes.len())
    );
    for face in mesh.surfaces.iter().flat_map(|s| &s.faces) {
        let hex = mesh.hexes[face.element as usize];
        assert!(face.nodes.iter().all(|n| hex.contains(n)));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..Default::default() })]

    #[test]
    fn damaged_files_never_panic(
        format in 0..4usize,
        damages in prop::collection::vec(damage(), 1..4),
    ) {
        let mut bytes = valid()[format].clone();
        damages.iter().for_each(|damage| inflict(&mut bytes, damage));
        holds_together(&bytes);
    }

    #[test]
    fn arbitrary_bytes_never_panic(
        start in 0..4usize,
        bytes in prop::collection::vec(any::<u8>(), 0..400),
    ) {
        let starts = [
            &b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Elements\n"[..],
            b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Elements\n5\n",
            b"\x1f\x8b\x08\0",
            b"$",
        ];
        holds_together(&[starts[start], &bytes].concat());
        holds_together(&bytes);
    }
}

#[test]
fn every_truncation_is_refused_or_complete() {
    for file in valid() {
        for end in (0..file.len()).step_by(7) {
            holds_together(&file[..end]);
        }
    }
}
