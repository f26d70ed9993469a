//! A mesh that is split in places that nobody has chosen.

use crate::model::mesh::Mesh;
use crate::model::mesh::split::{Directions, SplitError};
use crate::proof::verify::stream::Stream;

/// The mesh split so many times over, one in `one_in` of all directions of elements.
///
/// # Errors
/// As [`Mesh::split_some`].
pub fn split_anywhere(
    mut mesh: Mesh,
    times: usize,
    one_in: f64,
    stream: &mut Stream,
) -> Result<Mesh, SplitError> {
    for _ in 0..times {
        let mut mark = |_| [(); 3].map(|()| stream.share() * one_in < 1.0);
        let marks: Vec<Directions> = (0..mesh.hexes.len()).map(&mut mark).collect();
        mesh = mesh.split_some(|element| marks[element])?.mesh;
    }
    Ok(mesh)
}
