//! `report.html`: a run on one page that needs nothing else, on the screen and in print.
//!
//! The page takes what has been solved and summarised; nothing is solved here. Whatever comes from
//! the user's file passes through [`maud`], which escapes it, and the page forbids itself every
//! access to the network.

mod drawing;
mod figures;
pub mod history;
mod html;
mod model;
mod page;
mod sections;

use super::summary::Summary;
use crate::answer::results::recovery::Recovered;
use crate::ground::file::write_atomically;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::OutputError;
use history::Iterate;
use std::path::Path;

/// Name of the page in the folder of a run.
pub const FILE: &str = "report.html";

/// What the page is made from.
#[derive(Debug, Clone, Copy)]
pub struct Inputs<'a> {
    pub summary: &'a Summary,
    pub scene: &'a Scene,
    /// The state that the summary describes, and the fields recovered from it.
    pub state: &'a State,
    pub recovered: &'a Recovered,
    /// The iterations of this run, in their order.
    pub history: &'a [Iterate],
    /// Limits of the checks that the answer misses, in words.
    pub missed: &'a [String],
    /// Path and text of the case file.
    pub case: (&'a str, &'a str),
    /// What else a reader needs to repeat the run: name and value.
    pub setting: &'a [(String, String)],
}

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
    write_atomically(path, |out| out.write_all(text.as_bytes()))?;
    Ok(text.len())
}
