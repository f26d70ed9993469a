//! The hexahedra against published element tests and closed forms, driven through the solver.

mod kit;
mod patch;
mod uniaxial;
