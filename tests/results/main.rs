//! Recovered fields and scalars, the summary and the table, on states with known answers.

mod balance;
mod block;
mod bore;
mod contact_lines;
mod deck;
mod dent;
mod even_pressure;
mod interface;
mod line_load;
mod paraview;
mod recovery;
mod singular_edges;
mod strip_profile;
mod summary;
mod verdict;
mod vtk_readback;
