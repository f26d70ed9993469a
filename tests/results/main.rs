//! Recovered fields and scalars, the summary and the table, on states with known answers.

mod block;
mod bore;
mod interface;
mod recovery;
mod summary;
