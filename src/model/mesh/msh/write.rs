//! Writing a mesh as MSH text, for gmsh to look at and for tests to read again.
//!
//! Node and element tags are indices plus one; body `k` is volume and physical volume `k + 1`,
//! surface `k` is surface and physical surface `k + 1`.

use std::fmt::Write;

use crate::model::mesh::Mesh;

/// The mesh in MSH 4.1, as text.
pub fn msh41(mesh: &Mesh) -> String {
    let mut out = head(mesh, "4.1");
    let (bodies, surfaces) = (mesh.bodies.len(), mesh.surfaces.len());
    let quads: usize = mesh.surfaces.iter().map(|s| s.faces.len()).sum();
    line(&mut out, format_args!("$Entities\n0 0 {surfaces} {bodies}"));
    for tag in (1..=surfaces).chain(1..=bodies) {
        line(&mut out, format_args!("{tag} 0 0 0 0 0 0 1 {tag} 0"));
    }
    let nodes = mesh.points.len();
    line(
        &mut out,
        format_args!("$EndEntities\n$Nodes\n1 {nodes} 1 {nodes}\n3 1 0 {nodes}"),
    );
    for tag in 1..=nodes {
        line(&mut out, format_args!("{tag}"));
    }
    for [x, y, z] in &mesh.points {
        line(&mut out, format_args!("{x:?} {y:?} {z:?}"));
    }
    let count = quads + mesh.hexes.len();
    let blocks = bodies + surfaces;
    line(
        &mut out,
        format_args!("$EndNodes\n$Elements\n{blocks} {count} 1 {count}"),
    );
    let mut tag = 0;
    for (k, surface) in (1..).zip(&mesh.surfaces) {
        line(&mut out, format_args!("2 {k} 3 {}", surface.faces.len()));
        for face in &surface.faces {
            tag += 1;
            line(&mut out, format_args!("{tag}{}", tags(&face.nodes)));
        }
    }
    for (k, body) in (1..).zip(&mesh.bodies) {
        line(&mut out, format_args!("3 {k} 5 {}", body.elements.len()));
        for hex in mesh.hexes.get(body.elements.clone()).unwrap_or_default() {
            tag += 1;
            line(&mut out, format_args!("{tag}{}", tags(hex)));
        }
    }
    out.push_str("$EndElements\n");
    out
}

/// The mesh in MSH 2.2, as text.
pub fn msh22(mesh: &Mesh) -> String {
    let mut out = head(mesh, "2.2");
    line(&mut out, format_args!("$Nodes\n{}", mesh.points.len()));
    for (tag, [x, y, z]) in (1..).zip(&mesh.points) {
        line(&mut out, format_args!("{tag} {x:?} {y:?} {z:?}"));
    }
    let quads: usize = mesh.surfaces.iter().map(|s| s.faces.len()).sum();
    line(
        &mut out,
        format_args!("$EndNodes\n$Elements\n{}", quads + mesh.hexes.len()),
    );
    let mut tag = 0;
    for (k, surface) in (1..).zip(&mesh.surfaces) {
        for face in &surface.faces {
            tag += 1;
            line(
                &mut out,
                format_args!("{tag} 3 2 {k} {k}{}", tags(&face.nodes)),
            );
        }
    }
    for (k, body) in (1..).zip(&mesh.bodies) {
        for hex in mesh.hexes.get(body.elements.clone()).unwrap_or_default() {
            tag += 1;
            line(&mut out, format_args!("{tag} 5 2 {k} {k}{}", tags(hex)));
        }
    }
    out.push_str("$EndElements\n");
    out
}

/// The sections before the nodes, which both versions share.
fn head(mesh: &Mesh, version: &str) -> String {
    let mut out = format!("$MeshFormat\n{version} 0 8\n$EndMeshFormat\n");
    if let Some(fingerprint) = &mesh.fingerprint {
        line(
            &mut out,
            format_args!("$Comments\nbrinell-fingerprint: {fingerprint}\n$EndComments"),
        );
    }
    let count = mesh.surfaces.len() + mesh.bodies.len();
    line(&mut out, format_args!("$PhysicalNames\n{count}"));
    for (tag, surface) in (1..).zip(&mesh.surfaces) {
        line(&mut out, format_args!("2 {tag} \"{}\"", surface.name));
    }
    for (tag, body) in (1..).zip(&mesh.bodies) {
        line(&mut out, format_args!("3 {tag} \"{}\"", body.name));
    }
    out.push_str("$EndPhysicalNames\n");
    out
}

fn tags(nodes: &[u32]) -> String {
    let mut out = String::new();
    for node in nodes {
        // Writing to a string cannot fail.
        let _ = write!(out, " {}", u64::from(*node) + 1);
    }
    out
}

fn line(out: &mut String, text: std::fmt::Arguments<'_>) {
    let _ = out.write_fmt(text);
    out.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, uniform};
    use crate::model::mesh::msh::parse;

    #[test]
    fn a_written_mesh_is_read_as_it_was() {
        let list = |n| uniform(0.0, 0.3, n);
        let block = |name: &str| Block::new(name, list(2), list(1), list(3)).build().unwrap();
        let parts = [
            block("body").prefixed("lower "),
            block("body").prefixed("upper "),
        ];
        let mut mesh = Mesh::join(parts).unwrap();
        mesh.fingerprint = Some("12ab".into());
        for text in [msh41(&mesh), msh22(&mesh)] {
            let read = parse(text.as_bytes(), &mesh.source).unwrap();
            assert_eq!(read, mesh);
        }
    }
}
