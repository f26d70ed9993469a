//! Writes the small meshes of the extreme cases.
//!
//!     cargo run --release --example extreme-meshes -- cases/extreme
//!
//! Two blocks of side 1 stand on each other, the upper one finer, so that no node of one faces a
//! node of the other; each file spoils them in another way.

use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, BlockError, uniform};
use brinell::model::mesh::msh::write::msh41;
use std::error::Error;
use std::path::Path;

type Point = [f64; 3];

/// A block of so many elements along x and y and along z, its lower face at the height `base`.
fn block(across: usize, up: usize, base: f64, map: fn(Point) -> Point) -> Result<Mesh, BlockError> {
    let side = || uniform(0.0, 1.0, across);
    let height = uniform(base, base + 1.0, up);
    Block::new("block", side(), side(), height)
        .mapped(map)
        .build()
}

/// A coarser block and, `gap` above it, a finer one.
fn stack(gap: f64, map: fn(Point) -> Point) -> Result<Mesh, Box<dyn Error>> {
    let lower = block(2, 2, 0.0, map)?.prefixed("lower_");
    let upper = block(3, 2, 1.0 + gap, map)?.prefixed("upper_");
    Ok(Mesh::join([lower, upper])?)
}

/// Ten blocks on each other, alternately coarser and finer.
fn column() -> Result<Mesh, Box<dyn Error>> {
    let floors = (0..10).map(|floor| {
        let part = block(2 + floor % 2, 1, floor as f64, |p| p)?;
        Ok(part.prefixed(&format!("floor_{floor}_")))
    });
    let floors: Result<Vec<Mesh>, BlockError> = floors.collect();
    Ok(Mesh::join(floors?)?)
}

/// A block between two others, side by side along x.
fn squeezed() -> Result<Mesh, Box<dyn Error>> {
    let part = |name: &str, across, from: f64| -> Result<Mesh, BlockError> {
        let side = || uniform(0.0, 1.0, across);
        let along = uniform(from, from + 1.0, across);
        Ok(Block::new("block", along, side(), side())
            .build()?
            .prefixed(name))
    };
    let parts = [
        part("left_", 2, -1.0)?,
        part("middle_", 3, 0.0)?,
        part("right_", 2, 1.0)?,
    ];
    Ok(Mesh::join(parts)?)
}

/// A brick with every other element turned about its own axes: the same hexahedra, their corners
/// counted from elsewhere.
fn turned(mut mesh: Mesh) -> Mesh {
    const TURN: [usize; 8] = [1, 2, 3, 0, 5, 6, 7, 4];
    for hex in mesh.hexes.iter_mut().step_by(2) {
        *hex = TURN.map(|corner| hex[corner]);
    }
    mesh
}

/// Faces of the contact surfaces written clockwise.
fn reversed(mut mesh: Mesh) -> Mesh {
    for surface in &mut mesh.surfaces {
        surface
            .faces
            .iter_mut()
            .for_each(|face| face.nodes.reverse());
    }
    mesh
}

/// Every element of the upper block with eight nodes of its own: nothing holds it together.
fn apart(mut mesh: Mesh) -> Mesh {
    let upper = mesh.bodies[1].elements.clone();
    for element in upper {
        let first = mesh.points.len() as u32;
        let corners = mesh.hexes[element].map(|n| mesh.points[n as usize]);
        let old = mesh.hexes[element];
        mesh.points.extend(corners);
        mesh.hexes[element] = std::array::from_fn(|k| first + k as u32);
        for surface in &mut mesh.surfaces {
            for face in surface
                .faces
                .iter_mut()
                .filter(|f| f.element == element as u32)
            {
                face.nodes = face.nodes.map(|n| {
                    let corner = old.iter().position(|o| *o == n).unwrap_or(0);
                    first + corner as u32
                });
            }
        }
    }
    compact(mesh)
}

/// Without the nodes that no element has.
fn compact(mut mesh: Mesh) -> Mesh {
    let mut used: Vec<u32> = mesh.hexes.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let new = |node: u32| used.binary_search(&node).unwrap_or(0) as u32;
    mesh.hexes.iter_mut().for_each(|hex| *hex = hex.map(new));
    for face in mesh.surfaces.iter_mut().flat_map(|s| &mut s.faces) {
        face.nodes = face.nodes.map(new);
    }
    mesh.points = used
        .iter()
        .map(|node| mesh.points[*node as usize])
        .collect();
    mesh
}

/// One element a block.
fn single() -> Result<Mesh, Box<dyn Error>> {
    let lower = block(1, 1, 0.0, |p| p)?.prefixed("lower_");
    let upper = block(1, 1, 1.0, |p| p)?.prefixed("upper_");
    Ok(Mesh::join([lower, upper])?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| ".".to_owned());
    let same = |p| p;
    // Angles of ten degrees in plan; plates of a thousandth of their width.
    let skew = |[x, y, z]: Point| [x + y / 10f64.to_radians().tan(), y, z];
    let thin = |[x, y, z]: Point| [x, y, z / 500.0];
    let meshes = [
        ("stack", stack(0.0, same)?),
        ("gap", stack(1.0, same)?),
        ("overlap", stack(-1e-3, same)?),
        ("skew", stack(0.0, skew)?),
        ("thin", stack(0.0, thin)?),
        ("single", single()?),
        ("turned", turned(stack(0.0, same)?)),
        ("reversed", reversed(stack(0.0, same)?)),
        ("apart", apart(stack(0.0, same)?)),
        ("bar", block(2, 2, 0.0, same)?),
        ("column", column()?),
        ("squeezed", squeezed()?),
    ];
    for (name, mesh) in meshes {
        let path = Path::new(&folder).join(format!("{name}.msh"));
        std::fs::write(path, msh41(&mesh))?;
    }
    Ok(())
}
