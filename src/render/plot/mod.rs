//! Plots: what is drawn as data, and two backends, files and the page. What is drawn is made elsewhere.

pub mod axis;
mod data;
mod file;
pub mod frame;
mod page;

pub use data::{Line, Panel, PlotFigure, Scale};
pub use page::charts;

use crate::ground::file::write_text;
use crate::render::OutputError;
use std::path::Path;

/// Draws the figure and writes it, whole or not at all.
///
/// # Errors
/// [`OutputError`] with the path, where it cannot be drawn or written.
pub fn write(figure: &PlotFigure, path: &Path) -> Result<(), OutputError> {
    let text = svg(figure).map_err(|why| OutputError::Plot {
        path: path.to_path_buf(),
        why,
    })?;
    Ok(write_text(path, &text)?)
}

/// The figure as the text of an SVG file.
///
/// # Errors
/// What the drawing library says where it refuses.
pub fn svg(figure: &PlotFigure) -> Result<String, String> {
    let mut text = String::new();
    file::draw(figure, &mut text).map_err(|error| error.to_string())?;
    Ok(text)
}
