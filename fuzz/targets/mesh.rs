//! Whatever the bytes of a mesh file are: a mesh that holds together, or an error.
#![no_main]

use brinell::model::mesh::msh;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(mesh) = msh::parse(bytes, "fuzz.msh") {
        let nodes = mesh.points.len() as u32;
        assert!(mesh.hexes.iter().flatten().all(|n| *n < nodes));
        assert!(mesh.surfaces.iter().flat_map(|s| s.nodes()).all(|n| n < nodes));
        assert!(mesh.points.iter().flatten().all(|c| c.is_finite()));
    }
});
