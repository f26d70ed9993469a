//! First yield below a point or elliptic contact; the stresses are in [`subsurface`](crate::analytic::subsurface).

pub mod onset;
