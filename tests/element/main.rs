//! The hexahedra against published element tests and closed forms, driven through the solver.

mod cantilever;
mod cook;
mod incompressible;
mod kit;
mod patch;
mod tangent;
mod tube;
mod uniaxial;
