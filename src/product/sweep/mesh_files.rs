//! The mesh files that the cases of rows name.

use crate::case::variant;
use crate::ground::hash::Fnv;
use crate::ground::input;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// Mesh files that rows name.
pub struct MeshFiles {
    /// Folder of the case that is varied.
    folder: PathBuf,
    /// Hashes of their content.
    known: BTreeMap<PathBuf, u64>,
}

impl MeshFiles {
    pub fn new(case: &Path) -> Self {
        // An empty path has no absolute one.
        let folder = case.parent().filter(|folder| *folder != Path::new(""));
        let folder = folder.unwrap_or(Path::new("."));
        Self {
            folder: std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned()),
            known: BTreeMap::new(),
        }
    }

    /// `text` with the absolute path of its mesh file: the case of a row stands in another folder.
    pub fn absolute(&self, text: String) -> String {
        let Some(file) = mesh_file(&text).filter(|file| file.is_relative()) else {
            return text;
        };
        let path = self.folder.join(file).to_string_lossy().into_owned();
        let set = BTreeMap::from([("mesh.file".to_owned(), Value::String(path))]);
        variant::changed(&text, &set)
    }

    /// A hash of the mesh file's content; zero where there is none.
    pub fn content(&mut self, text: &str) -> u64 {
        let Some(file) = mesh_file(text) else {
            return 0;
        };
        let hash = |path: &PathBuf| input::bytes(path).map_or(0, |bytes| Fnv::of(&bytes));
        *self.known.entry(file).or_insert_with_key(hash)
    }
}

fn mesh_file(text: &str) -> Option<PathBuf> {
    let case = text.parse::<Table>().ok()?;
    let file = case.get("mesh")?.get("file")?.as_str()?;
    Some(PathBuf::from(file))
}
