//! The numbers of problem H, and the limits of its figures on fine meshes.

pub use crate::model::mesh::family::problem_h::HALF_WIDTH;

/// Load per length, kip/in.
pub const LOAD: f64 = 8.125;
/// Young's modulus, ksi.
pub const YOUNG: f64 = 29500.0;
/// Poisson's ratio.
pub const POISSON: f64 = 0.3;

/// Largest pressure on fine meshes, ksi, which is Hertz's.
pub const PRESSURE: f64 = 167.17;

/// Where the limits of the Mises stress are from: another program, of which neither a version nor a deck was published.
pub const MISES_SOURCE: &str = "8-node plane-strain elements with a linear complementarity solver, \
     h/a to 1/32, gap vertical (own program, no version, no deck)";

/// Largest Mises stress in the block on fine meshes, ksi: 1.8 % above Hertz's 93.20 ksi, because the bodies are finite.
///
/// The limits of both bodies depend on which way the pressure leans, by up to x/R. Those of an independent
/// solver are 94.98 and 92.69 for a vertical gap, 94.80 and 92.90 along the cylinder's normal.
/// Brinell takes the normal of the block, which is flat.
pub const MISES_BLOCK: f64 = 94.98;
/// Largest Mises stress in the cylinder on fine meshes, ksi: 0.4 % below Hertz's.
pub const MISES_CYLINDER: f64 = 92.69;
