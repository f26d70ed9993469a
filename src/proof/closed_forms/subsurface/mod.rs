//! First yield below a point contact; the stresses are in [`subsurface`](crate::analytic::subsurface).

pub mod onset;
