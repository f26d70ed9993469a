//! Discretisation of the bodies: the hexahedron, its strains, and what is assembled from it.

pub mod bbar;
pub mod dofs;
pub mod element;
pub mod enhanced;
pub mod hex8;
pub mod loads;
pub mod tied;
