//! The files that a case names: a mesh, and a list of steel grades. Rows of a sweep and combinations stand elsewhere, and
//! name the same.

use super::variant;
use crate::ground::hash::Fnv;
use crate::ground::input;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// Keys whose values are paths.
const KEYS: [&str; 2] = ["mesh.file", "grades"];

/// Files that cases name.
pub struct NamedFiles {
    /// Folder of the case that others are made of.
    folder: PathBuf,
    /// Hashes of their content.
    known: BTreeMap<PathBuf, u64>,
}

impl NamedFiles {
    /// Of cases that are made of the one at `case`.
    pub fn new(case: &Path) -> Self {
        // An empty path has no absolute one.
        let folder = case.parent().filter(|folder| *folder != Path::new(""));
        let folder = folder.unwrap_or(Path::new("."));
        Self {
            folder: std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned()),
            known: BTreeMap::new(),
        }
    }

    /// `text` with the absolute paths of its files, for a case that stands in another folder.
    pub fn absolute(&self, text: String) -> String {
        let files = KEYS
            .iter()
            .filter_map(|key| Some((*key, file(&text, key)?)));
        let relative = files.filter(|(_, file)| file.is_relative());
        let set: BTreeMap<String, Value> = relative
            .map(|(key, file)| {
                let path = self.folder.join(file).to_string_lossy().into_owned();
                (key.to_owned(), Value::String(path))
            })
            .collect();
        match set.is_empty() {
            true => text,
            false => variant::changed(&text, &set),
        }
    }

    /// Hashes of the content of the files; a mesh that is not there or not named is zero.
    pub fn content(&mut self, text: &str) -> String {
        let [mesh, grades] = KEYS.map(|key| file(text, key).map(|file| self.hash(file)));
        let grades = grades.map(|hash| format!("-{hash:x}")).unwrap_or_default();
        format!("{:x}{grades}", mesh.unwrap_or(0))
    }

    fn hash(&mut self, file: PathBuf) -> u64 {
        let hash = |path: &PathBuf| input::bytes(path).map_or(0, |bytes| Fnv::of(&bytes));
        *self.known.entry(file).or_insert_with_key(hash)
    }
}

/// The file that the case names under the dotted `key`.
fn file(text: &str, key: &str) -> Option<PathBuf> {
    let case = Value::Table(text.parse::<Table>().ok()?);
    let value = key.split('.').try_fold(&case, |table, key| table.get(key));
    Some(PathBuf::from(value?.as_str()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grades_are_sought_beside_the_case_and_count() {
        let folder = tempfile::tempdir().unwrap();
        let list = folder.path().join("shop.toml");
        let case = folder.path().join("case.toml");
        let text = "title = \"a\"\ngrades = \"shop.toml\"\n".to_owned();
        let hash = |content: &str| {
            std::fs::write(&list, content).unwrap();
            let mut files = NamedFiles::new(&case);
            let text = files.absolute(text.clone());
            assert!(text.contains(&*list.to_string_lossy()), "{text}");
            files.content(&text)
        };
        assert_ne!(hash("a"), hash("b"));
        let none = "title = \"a\"\n".to_owned();
        assert_eq!(NamedFiles::new(&case).absolute(none.clone()), none);
        assert_eq!(NamedFiles::new(&case).content(&none), "0");
    }
}
