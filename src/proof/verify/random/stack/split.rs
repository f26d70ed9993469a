//! The same stack on a mesh that is split in places, with nodes that hang.

use super::draw::Stack;
use crate::model::mesh::Mesh;
use crate::model::mesh::split::{Directions, SplitError};
use crate::proof::verify::stream::Stream;

/// How often some of the elements are split, and one in how many along each of its directions.
const TIMES: usize = 2;
const ONE_IN: usize = 10;

/// Numbers of streams that nothing else of the suite draws from.
const STREAMS: usize = 1_000_000;

/// The stack with elements split anywhere, in any directions.
///
/// # Errors
/// As [`Mesh::split_some`].
pub fn split(stack: &Stack, seed: u64, number: usize) -> Result<Stack, SplitError> {
    let mut stream = Stream::new(seed, STREAMS + number);
    let mut split = stack.clone();
    for _ in 0..TIMES {
        let mesh: &mut Mesh = &mut split.scene.mesh;
        let mut mark = |_| [(); 3].map(|()| stream.share() * (ONE_IN as f64) < 1.0);
        let marks: Vec<Directions> = (0..mesh.hexes.len()).map(&mut mark).collect();
        *mesh = mesh.split_some(|element| marks[element])?.mesh;
    }
    Ok(split)
}
