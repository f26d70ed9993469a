//! An accepted solution in the terms of the scene: stresses, contact fields, forces, energies.

pub mod consistent;
pub mod contact_fields;
pub mod energy;
pub mod gaps;
pub mod left_over;
pub mod memory;
pub mod plane_fields;
pub mod reaction;
pub mod state;
pub mod stresses;
pub mod tie_fields;
