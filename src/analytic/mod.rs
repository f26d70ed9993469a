//! Closed-form solutions that tables, the certificate and sizing share.
//!
//! Each file is one idea; each function names its source. Numbers are taken in any one consistent
//! unit system (in, kip, ksi; mm, N, MPa; m, N, Pa). Stresses are tension positive, pressures
//! and loads compression positive, displacements along the coordinate they are named after.
//! A bad argument gives a [`DomainError`] that names it, never a panic and never a NaN.
//!
//! | question | where |
//! |---|---|
//! | width and pressure of a line, point or elliptic contact | [`hertz`] |
//! | stress below the surface, first yield | [`subsurface`] |
//! | equations (2-45) to (2-51) of the reference study | [`sizing`] |
//! | what design rules allow: EN 1337-4, AASHTO, EN 13001-3-3, ISO 76, yield | [`rules`] |
//! | rolling without sliding, equations (2-3), (2-28), (2-39) | [`rolling`] |
//! | roller in a V groove, roller off the centre | [`vgroove`], [`displaced`] |
//! | hollow roller squeezed between plates | [`ring`], [`curved_beam`] |
//! | all of it for one roller | [`handbook`] |
//!
//! Closed forms that only prove the program are in [`closed_forms`](crate::proof::closed_forms).
//!
//! Johnson stands for K. L. Johnson, *Contact Mechanics*, Cambridge University Press, 1985. The
//! reference study is Lee, Ou, Liang, Niu and Song, *Principles and Performance of Roller Seismic
//! Isolation Bearings for Highway Bridges*, MCEER.

pub mod curved_beam;
pub mod displaced;
pub mod elastic;
mod elliptic_integrals;
pub mod error;
pub mod handbook;
pub mod hertz;
pub mod ring;
pub mod rolling;
pub mod rules;
pub mod sizing;
pub mod stress;
pub mod subsurface;
pub mod vgroove;

pub(crate) mod search;

pub use elastic::{Elastic, contact_compliance};
pub use error::DomainError;
pub use stress::Stress;
