//! `report.html`: a run on one page that needs nothing else, on the screen and in print.
//!
//! The page takes what has been solved and summarised; nothing is solved here. Whatever comes from
//! the user's file passes through [`maud`], which escapes it, and the page forbids itself every
//! access to the network.

pub mod calculation;
mod drawing;
pub mod history;
mod html;
mod inputs;
mod model;
mod page;
mod sections;

pub use inputs::{FILE, Inputs};
pub(super) use page::html_head;

use crate::ground::file::write_text;
use crate::render::OutputError;
use std::path::Path;

/// The page.
///
/// # Errors
/// [`OutputError`] where a picture cannot be encoded.
pub fn render(inputs: &Inputs) -> Result<String, OutputError> {
    page::page(inputs).map(maud::PreEscaped::into_string)
}

/// Writes the page to `path`, whole or not at all, and returns its size in bytes.
///
/// # Errors
/// [`OutputError`] where a picture cannot be encoded, or with the path that cannot be written.
pub fn write(inputs: &Inputs, path: &Path) -> Result<usize, OutputError> {
    let text = render(inputs)?;
    write_text(path, &text)?;
    Ok(text.len())
}
