//! Drawings of the page: axes, curves, painted fields. They stand in print as on the screen.

pub mod axes;
pub mod chart;
pub mod colours;
pub mod painting;
pub mod raster;
