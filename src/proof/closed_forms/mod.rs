//! Closed forms and published fits that only the proof needs: what the program is held against.
//!
//! Conventions and errors as in [`analytic`](crate::analytic), which has what users are shown.
//!
//! | question | where |
//! |---|---|
//! | approach of bodies in line contact | [`approach`] |
//! | first yield below a point contact | [`subsurface`] |
//! | stick and slip | [`friction`] |
//! | steel curve, yielding tube, limit load | [`steel`], [`tube`], [`tube_mises`], [`limit`] |
//! | sphere pressed beyond yield | [`flattening`] |
//! | edge of a punch | [`rounded_punch`] |
//! | patch tests, cantilever, Cook's membrane | [`patch`] |

pub mod approach;
pub mod flattening;
pub mod friction;
pub mod limit;
pub mod patch;
pub mod rounded_punch;
pub mod steel;
pub mod subsurface;
pub mod tube;
pub mod tube_mises;
