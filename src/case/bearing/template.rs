//! The gmsh template of the bearing, carried in the program.

use std::io;
use std::path::{Path, PathBuf};

/// Raised whenever the template makes other meshes from the same numbers, so that meshes made
/// before are not taken for current ones.
pub const TEMPLATE_VERSION: u32 = 1;

/// The file to give to gmsh.
pub const TEMPLATE_MAIN: &str = "bearing.geo";

/// Name and text of the files of the template, which include each other by name.
pub const TEMPLATE_FILES: [(&str, &str); 4] = [
    (TEMPLATE_MAIN, include_str!("../../../meshes/bearing.geo")),
    ("spacing.geo", include_str!("../../../meshes/spacing.geo")),
    ("roller.geo", include_str!("../../../meshes/roller.geo")),
    ("slab.geo", include_str!("../../../meshes/slab.geo")),
];

/// Writes the template into `directory`; returns the path of the file to give to gmsh.
///
/// # Errors
/// Where a file cannot be written.
pub fn write_template(directory: &Path) -> io::Result<PathBuf> {
    for (name, text) in TEMPLATE_FILES {
        std::fs::write(directory.join(name), text)?;
    }
    Ok(directory.join(TEMPLATE_MAIN))
}
