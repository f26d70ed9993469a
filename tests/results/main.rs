//! Recovered fields and scalars, the summary and the table, on states with known answers.

mod block;
mod bore;
mod deck;
mod dent;
mod interface;
mod recovery;
mod summary;
mod vtk_readback;
