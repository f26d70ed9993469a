//! One eight-node hexahedron: its numbering, its shape functions, and whether it is sound.
//!
//! Everything else that knows a hexahedron takes this from here: the solver's elements, the
//! refinement of meshes, the results.

mod numbering;
mod orientation;
mod trilinear;

pub use numbering::{CORNERS, EDGES, FACES, NEIGHBOURS, faces_of, mirrored, side_of};
pub(super) use orientation::{Orientation, edge_lengths, orientation, scaled_jacobians};
pub use trilinear::{GAUSS, gauss_volumes, jacobian_matrix, shape, shape_derivatives, volume};
