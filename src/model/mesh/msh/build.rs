//! From the contents of a file to a mesh, checking that everything fits.

use super::error::MeshError;
use super::file::File;
use super::groups::Groups;
use super::names::name_of;
use super::raw::{Block, Places, Raw};
use super::reading::Reading;
use crate::model::mesh::surface::FaceFinder;
use crate::model::mesh::{Body, Mesh, Surface};

/// Builds the mesh of the file whose contents are `raw`.
pub(super) fn build(raw: Raw, places: &Places<'_>) -> Result<Reading, MeshError> {
    let file = File { raw: &raw, places };
    let indices = file.node_indices()?;
    file.check_element_tags()?;
    let groups = Groups::new(&raw, places)?;
    groups.check_complete(&raw, places)?;
    groups.check_names(&raw, places)?;
    let nodes = file.element_nodes(&indices)?;

    let mut mesh = Mesh {
        source: places.source.to_owned(),
        ..Mesh::default()
    };
    // Which element of the file each hexahedron is.
    let mut origin: Vec<usize> = Vec::new();
    for (tag, blocks) in &groups.volumes {
        let start = mesh.hexes.len();
        for block in blocks {
            for (element, hex) in (block.first..).zip(block_nodes::<8>(&nodes, block)) {
                mesh.hexes.push(*hex);
                origin.push(element);
            }
        }
        mesh.bodies.push(Body {
            name: name_of(&raw, (3, *tag)),
            elements: start..mesh.hexes.len(),
        });
    }
    mesh.points.clone_from(&raw.nodes.points);
    file.check_repeated(&mesh, &origin)?;
    let mut notes = file.orient(&mut mesh, &origin)?;

    let used = file.check_use(&mesh, &groups, &nodes)?;
    let finder = FaceFinder::new(&mesh.hexes, mesh.points.len());
    for (tag, blocks) in &groups.surfaces {
        let surface = Surface {
            name: name_of(&raw, (2, *tag)),
            faces: Vec::new(),
        };
        let quads = blocks
            .iter()
            .flat_map(|block| (block.first..).zip(block_nodes::<4>(&nodes, block).iter().copied()));
        mesh.surfaces
            .push(file.match_faces(&mesh, &finder, surface, quads)?);
    }
    let left_out = compact(&mut mesh, &used);
    if left_out > 0 {
        notes.push(format!(
            "{}: {left_out} nodes that belong to no hexahedron were left out",
            places.source
        ));
    }
    mesh.fingerprint = raw.fingerprint;
    Ok(Reading { mesh, notes })
}

/// The nodes of the elements of a run, by index.
fn block_nodes<'a, const N: usize>(nodes: &'a [u32], block: &Block) -> &'a [[u32; N]] {
    let all = nodes.get(block.first_node..block.first_node + N * block.count);
    all.unwrap_or_default().as_chunks().0
}

/// Leaves out the nodes that are not `used` and returns how many they were.
fn compact(mesh: &mut Mesh, used: &[bool]) -> usize {
    let mut next = 0u32;
    let fresh: Vec<u32> = used
        .iter()
        .map(|used| {
            let index = next;
            next += u32::from(*used);
            index
        })
        .collect();
    let left_out = used.len() - next as usize;
    if left_out > 0 {
        let renumber = |node: &mut u32| *node = fresh[*node as usize];
        mesh.hexes.iter_mut().flatten().for_each(renumber);
        let faces = mesh.surfaces.iter_mut().flat_map(|s| &mut s.faces);
        faces.flat_map(|face| &mut face.nodes).for_each(renumber);
        let mut keep = used.iter();
        mesh.points
            .retain(|_| keep.next().is_some_and(|used| *used));
    }
    left_out
}
