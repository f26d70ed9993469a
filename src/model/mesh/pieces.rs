//! Pieces of a body that share no nodes.

use super::Mesh;
use std::ops::Range;

impl Mesh {
    /// How many pieces the elements make that hang together by common nodes. More than one where a
    /// body has several parts, or where its nodes were doubled.
    pub fn pieces(&self, elements: Range<usize>) -> usize {
        let hexes = &self.hexes[elements];
        let mut parent: Vec<u32> = (0..hexes.len() as u32).collect();
        let mut owner = vec![u32::MAX; self.points.len()];
        let mut pieces = hexes.len();
        for (element, hex) in (0..).zip(hexes) {
            for node in hex {
                let first = &mut owner[*node as usize];
                if *first == u32::MAX {
                    *first = element;
                    continue;
                }
                let (a, b) = (root(&mut parent, *first), root(&mut parent, element));
                if a != b {
                    parent[b as usize] = a;
                    pieces -= 1;
                }
            }
        }
        pieces
    }
}

/// Representative of an element's piece; halves the way there.
fn root(parent: &mut [u32], mut element: u32) -> u32 {
    while parent[element as usize] != element {
        let above = parent[parent[element as usize] as usize];
        parent[element as usize] = above;
        element = above;
    }
    element
}

#[cfg(test)]
mod tests {
    use super::super::block::{Block, uniform};
    use super::*;

    #[test]
    fn two_blocks_are_two_pieces() {
        let block = |name: &str| {
            let side = || uniform(0.0, 1.0, 2);
            let block = Block::new("block", side(), side(), side()).build().unwrap();
            block.prefixed(name)
        };
        let mesh = Mesh::join([block("a_"), block("b_")]).unwrap();
        assert_eq!(mesh.pieces(0..8), 1);
        assert_eq!(mesh.pieces(0..16), 2);
    }
}
