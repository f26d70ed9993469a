//! Plots as SVG: panels in two columns with one legend. What is drawn is made elsewhere.

pub mod axis;
mod draw;

use crate::ground::file::write_atomically;
use crate::render::OutputError;
use std::path::Path;

/// A line in a panel: its place in the legend, and its points.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    pub style: usize,
    pub points: Vec<(f64, f64)>,
}

/// How the axes of a panel are divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Both are logarithmic, over whole decades.
    Decades,
    /// Both are linear, and the upright one starts at zero where nothing is negative.
    Linear,
}

/// One diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub title: String,
    /// What is drawn along and upwards, with units; an empty one has no label.
    pub axes: [String; 2],
    pub scale: Scale,
    pub lines: Vec<Line>,
    /// Dashed levels across the panel.
    pub dashed: Vec<f64>,
}

/// Diagrams in two columns, with one legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    pub panels: Vec<Panel>,
    /// The names of the styles.
    pub legend: Vec<String>,
    /// What dashed levels are.
    pub dashed: String,
}

/// Draws the figure and writes it, whole or not at all.
///
/// # Errors
/// [`OutputError`] with the path, where it cannot be drawn or written.
pub fn write(figure: &Figure, path: &Path) -> Result<(), OutputError> {
    let text = svg(figure).map_err(|why| OutputError::Plot {
        path: path.to_path_buf(),
        why,
    })?;
    Ok(write_atomically(path, |out| {
        out.write_all(text.as_bytes())
    })?)
}

/// The figure as the text of an SVG file.
///
/// # Errors
/// What the drawing library says where it refuses.
pub fn svg(figure: &Figure) -> Result<String, String> {
    let mut text = String::new();
    draw::draw(figure, &mut text).map_err(|error| error.to_string())?;
    Ok(text)
}
