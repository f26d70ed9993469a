//! Nodes that no hexahedron uses.

use super::error::MeshError;
use super::file::File;
use super::groups::Groups;
use super::names::ENTITIES;
use super::names::name_of;
use crate::model::mesh::Mesh;

impl File<'_> {
    /// Which nodes the hexahedra use. Other nodes must be used by points, curves or surfaces that
    /// belong to no physical group, as gmsh writes them when asked to save all: such a node is
    /// the centre of an arc, for example.
    pub fn check_use(
        &self,
        mesh: &Mesh,
        groups: &Groups<'_>,
        nodes: &[u32],
    ) -> Result<Vec<bool>, MeshError> {
        let mut used = vec![false; mesh.points.len()];
        for &node in mesh.hexes.iter().flatten() {
            used[node as usize] = true;
        }
        for ((dimension, tag), block) in &groups.lower {
            let range = block.first_node..block.first_node + block.count * block.kind.nodes;
            let lone = nodes
                .get(range)
                .unwrap_or_default()
                .iter()
                .find(|n| !used[**n as usize]);
            if let Some(&node) = lone {
                let kind = ENTITIES[usize::from(*dimension)];
                let name = name_of(self.raw, (*dimension, *tag));
                let use_of_it = format!("belongs to physical {kind} `{name}` but to no hexahedron");
                return Err(self.unused(node, use_of_it));
            }
        }
        let mut touched = used.clone();
        for &node in nodes {
            touched[node as usize] = true;
        }
        match (0u32..).zip(&touched).find(|(_, touched)| !**touched) {
            Some((node, _)) => Err(self.unused(node, "belongs to no element".to_owned())),
            None => Ok(used),
        }
    }

    fn unused(&self, node: u32, use_of_it: String) -> MeshError {
        let nodes = &self.raw.nodes;
        let mark = nodes.marks.get(node as usize).copied().unwrap_or_default();
        let block = nodes
            .blocks
            .partition_point(|(first, _)| *first <= node as usize);
        let owner = match block.checked_sub(1).and_then(|k| nodes.blocks.get(k)) {
            Some((_, key)) => format!(" of {} {}", ENTITIES[usize::from(key.0.min(3))], key.1),
            None => String::new(),
        };
        let place = self.places.place("Nodes", mark);
        MeshError::UnusedNode {
            place,
            node: self.node_tag(node),
            owner,
            use_of_it,
        }
    }
}
