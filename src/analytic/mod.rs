//! Closed-form solutions that tests, tables, the certificate and sizing share.
//!
//! Each file is one idea; each function names its source. Numbers are taken in any one consistent
//! unit system (in, kip, ksi; mm, N, MPa; m, N, Pa). Stresses are tension positive, pressures
//! and loads compression positive, displacements along the coordinate they are named after.
//! A bad argument gives a [`DomainError`] that names it, never a panic and never a NaN.
//!
//! | question | where |
//! |---|---|
//! | width, pressure and approach of a contact | [`hertz`], [`approach`] |
//! | stress below the surface, first yield | [`subsurface`] |
//! | stick and slip | [`friction`] |
//! | equations (2-45) to (2-51) of the reference study | [`sizing`] |
//! | rolling without sliding, equations (2-3), (2-28), (2-39) | [`rolling`] |
//! | roller in a V groove, roller off the centre | [`vgroove`], [`displaced`] |
//! | hollow roller squeezed between plates | [`ring`], [`curved_beam`] |
//! | steel curve, yielding tube, limit load | [`steel`], [`tube`], [`tube_mises`], [`limit`] |
//! | sphere pressed beyond yield | [`flattening`] |
//! | crown of a roller, edge of a punch | [`crown`], [`rounded_punch`] |
//! | patch tests, cantilever, Cook's membrane | [`patch`] |
//! | all of it for one roller | [`handbook`] |
//!
//! Johnson stands for K. L. Johnson, *Contact Mechanics*, Cambridge University Press, 1985. The
//! reference study is Lee, Ou, Liang, Niu and Song, *Principles and Performance of Roller Seismic
//! Isolation Bearings for Highway Bridges*, MCEER.

pub mod approach;
pub mod crown;
pub mod curved_beam;
pub mod displaced;
pub mod elastic;
pub mod elliptic;
pub mod error;
pub mod flattening;
pub mod friction;
pub mod handbook;
pub mod hertz;
pub mod limit;
pub mod patch;
pub mod ring;
pub mod rolling;
pub mod rounded_punch;
pub mod sizing;
pub mod steel;
pub mod stress;
pub mod subsurface;
pub mod tube;
pub mod tube_mises;
pub mod vgroove;

mod search;

pub use elastic::{Elastic, contact_compliance};
pub use error::DomainError;
pub use stress::Stress;
