//! Contact rows: the mortar operator of each contact pair, one row a carrier node, with its law.

pub mod contact_row;
pub mod contact_rows;
pub mod held_planes;
pub mod least_gaps;
