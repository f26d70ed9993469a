//! The same stack on a mesh that is split in places, with nodes that hang.

use super::draw::Stack;
use crate::model::mesh::split::SplitError;
use crate::proof::verify::kit;
use crate::proof::verify::stream::Stream;

/// How often some of the elements are split, and one in how many along each of its directions.
const TIMES: usize = 2;
const ONE_IN: f64 = 10.0;

/// Numbers of streams that nothing else of the suite draws from.
const STREAMS: usize = 1_000_000;

/// The stack with elements split anywhere, in any directions.
///
/// # Errors
/// As [`kit::split_anywhere`].
pub fn split(stack: &Stack, seed: u64, number: usize) -> Result<Stack, SplitError> {
    let mut stream = Stream::new(seed, STREAMS + number);
    let mut split = stack.clone();
    split.scene.mesh = kit::split_anywhere(split.scene.mesh, TIMES, ONE_IN, &mut stream)?;
    Ok(split)
}
