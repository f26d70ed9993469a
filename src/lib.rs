//! Brinell: contact stresses of roller bearings by finite elements.
//!
//! A case file and a mesh go in; contact pressures and stresses come out, each with an estimate of its error. The
//! program `brinell` does that from the command line. This library does it from code.
//!
//! # A scene in thirty lines
//!
//! A steel roller on a steel block, beside Hertz. Units are whatever is consistent: here mm, N, MPa.
//!
//! ```
//! use brinell::prelude::*;
//!
//! let (radius, load) = (10.0, 1000.0); // mm, N/mm
//! let elastic = Elastic::new(210e3, 0.3)?;
//! let hertz = LineContact::new(load, radius, contact_compliance(elastic, elastic)?)?;
//! let a = hertz.half_width;
//!
//! let steel = Steel::elastic(210e3, 0.3);
//! let grown = Grading::new(a / 4.0, 1.5 * a, radius, 1.4).nodes(1);
//! let deep = grown.iter().rev().map(|y| -y).collect();
//! let scene = SceneBuilder::new("roller on block")
//!     .body(Cylinder::quarter("roller", radius, a).fine(a / 4.0, 1.5 * a).growth(1.4), steel)
//!     .body(Block::new("block", grown, deep, uniform(0.0, a, 1)), steel)
//!     .contact(Contact::between("roller_contact", "block_y_max").named("contact"))
//!     .fix("block_y_min")
//!     .load(Load::pressure("roller_top", load / (2.0 * radius)))
//!     .mirror(Axis::X)
//!     .plane_strain(Axis::Z)
//!     .build()?;
//! let answer = Solved::of(scene)?;
//!
//! let pressure = answer.figure(Quantity::PeakPressure, "contact").ok_or("no contact")?;
//! assert!((pressure.value / hertz.peak_pressure - 1.0).abs() < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Ten programs like this one are in `examples/`, from friction to a mesh file of your own.
//!
//! # The rooms
//!
//! Each room imports only from those below it. Most users need [`prelude`] alone.
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
//!
//! | you want to | look at |
//! |---|---|
//! | say a scene in code | [`model::builder`] |
//! | read a mesh of gmsh, or make one | [`model::mesh`] |
//! | solve it, watch it, stop it | [`solver::solve`] |
//! | read the answer | [`answer::Solved`], [`model::state`] |
//! | set a closed form beside it | [`analytic`] |
//! | read a case file, or describe a bearing | [`case`] |
//! | run a case as the program does | [`product::job`] |
//!
//! Rooms that are not listed in these pages are open to the tests and benches of the project, and may change.

#![deny(
    missing_docs,
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
#[doc(hidden)]
pub mod cli;
#[doc(hidden)]
pub mod ground;
pub mod model;
pub mod prelude;
pub mod product;
#[doc(hidden)]
pub mod proof;
#[doc(hidden)]
pub mod render;
pub mod solver;
