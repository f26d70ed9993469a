//! The gmsh templates of bearings, carried in the program.

use std::io;
use std::path::{Path, PathBuf};

/// A gmsh template.
#[derive(Debug, PartialEq, Eq)]
pub struct Template {
    /// As fingerprints have it.
    pub name: &'static str,
    /// Raised whenever the template makes other meshes from the same numbers, so that meshes made
    /// before are not taken for current ones.
    pub version: u32,
    /// Name and text of its files, which include each other by name. The first one is for gmsh.
    pub files: &'static [(&'static str, &'static str)],
}

const SPACING: (&str, &str) = ("spacing.geo", include_str!("../../../meshes/spacing.geo"));
const ROLLER: (&str, &str) = ("roller.geo", include_str!("../../../meshes/roller.geo"));
const SLAB: (&str, &str) = ("slab.geo", include_str!("../../../meshes/slab.geo"));

/// Two crossed rollers between three plates.
pub const CROSSED: Template = Template {
    name: "bearing",
    version: 1,
    files: &[
        ("bearing.geo", include_str!("../../../meshes/bearing.geo")),
        SPACING,
        ROLLER,
        SLAB,
    ],
};

/// Parallel rollers between two plates.
pub const LINE: Template = Template {
    name: "line bearing",
    version: 1,
    files: &[
        (
            "line-bearing.geo",
            include_str!("../../../meshes/line-bearing.geo"),
        ),
        SPACING,
        ROLLER,
        SLAB,
    ],
};

impl Template {
    /// Writes the template into `directory`; returns the path of the file to give to gmsh.
    ///
    /// # Errors
    /// Where a file cannot be written.
    pub fn write(&self, directory: &Path) -> io::Result<PathBuf> {
        for (name, text) in self.files {
            std::fs::write(directory.join(name), text)?;
        }
        let main = self.files.first().map_or("", |(name, _)| *name);
        Ok(directory.join(main))
    }
}
