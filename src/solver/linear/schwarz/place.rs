//! Where in space an equation is.

use crate::ground::geometry::Vec3;

/// Point and axis (0, 1, 2) of the displacement component that an equation stands for; `None` for a motion
/// that many nodes share, as that of a rigid plane.
pub type Place = Option<(Vec3, usize)>;
