//! Brinell: contact stresses of roller bearings by finite elements.
//!
//! A case file and a gmsh mesh go in; a certified contact-stress answer comes out. Data flows
//! one way, and each floor of the library imports only from the floors below it:
//!
//! ```text
//!  case.toml --case--> Scene <--mesh-- part.msh <-- gmsh <-- meshes/*.geo
//!                        |
//!                      solve      increments > Newton > linear solve
//!                        |
//!                     Results --certify--> error bars, balance, complementarity
//!                        |
//!                      output --> table, summary.json, .vtu/.pvd
//! ```

#![deny(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::todo,
    clippy::unimplemented
)]

pub mod analytic;
pub mod case;
pub mod certify;
pub mod cli;
pub mod contact;
pub mod converge;
pub mod fem;
pub mod geometry;
mod hash;
mod input;
pub mod job;
pub mod linear;
pub mod material;
pub mod mesh;
pub mod output;
pub mod results;
pub mod scene;
pub mod size;
pub mod solve;
pub mod study;
pub mod sweep;
pub mod target;
pub mod units;
pub mod verify;
