//! Brinell: contact stresses of roller bearings by finite elements.
//!
//! A case file and a mesh go in; a contact-stress answer with its errors comes out. The rooms have ranks, and each
//! imports only from those below it:
//!
//! ```text
//!  cli        arguments, progress, exit status
//!  proof      what shows that answers are right: claims with sources, the published study
//!  product    what users ask for: one case, a sweep, a size, a goal, a series of meshes
//!  case       what users write: TOML, bearings, meshes by gmsh
//!  render     what people and programs read: tables, JSON, a page, VTK files
//!  answer     what a solved scene says: fields, measures of contact, and their errors
//!  solver     sparse algebra, finite elements, contact, and the strategy that joins them
//!  model      mesh, steels, scene, and the state that solves it
//!  analytic   closed forms with their sources
//!  ground     vectors, units, files, memory
//! ```

#![deny(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::todo,
    clippy::unimplemented
)]

pub mod analytic;
pub mod answer;
pub mod case;
#[cfg(feature = "cli")]
pub mod cli;
pub mod ground;
pub mod model;
pub mod product;
pub mod proof;
pub mod render;
pub mod solver;
