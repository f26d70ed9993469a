//! Fields painted over two axes, on the page. They stand in print as on the screen.

pub mod colours;
pub mod painting;
pub mod raster;
