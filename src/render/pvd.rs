//! The `.pvd` collection that ties the files of a run to their times.

use std::fs;
use std::path::{Path, PathBuf};

use super::text::{escape, unescape};
use crate::ground::file::{FileError, write_atomically};
use crate::render::OutputError;

/// A file of a collection.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Steps done so far, counted in steps.
    pub time: f64,
    /// Which of the data sets of one time: 0 the bodies, 1 the contact surfaces.
    pub part: usize,
    /// What a viewer calls the part.
    pub name: String,
    /// The file's path relative to the collection.
    pub file: String,
}

/// A `.pvd` file, rewritten as a whole whenever something is added.
#[derive(Debug, Clone, PartialEq)]
pub struct Collection {
    path: PathBuf,
    entries: Vec<Entry>,
}

impl Collection {
    /// An empty collection to be written to `path`.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self {
            path: path.into(),
            entries: Vec::new(),
        }
    }

    /// The collection that an earlier run wrote to `path`.
    ///
    /// # Errors
    /// [`FileError::Read`], or [`OutputError::NotACollection`] for a file of other make.
    pub fn open(path: impl Into<PathBuf>) -> Result<Self, OutputError> {
        let path = path.into();
        let text = fs::read_to_string(&path).map_err(|source| FileError::Read {
            path: path.clone(),
            source,
        })?;
        let mut entries = Vec::new();
        for (number, line) in text
            .lines()
            .enumerate()
            .filter(|(_, l)| l.contains("<DataSet "))
        {
            let entry = parse(line).ok_or_else(|| OutputError::NotACollection {
                path: path.clone(),
                line: number + 1,
            })?;
            entries.push(entry);
        }
        Ok(Self { path, entries })
    }

    /// The files, in the order of time and part.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Where the collection is written.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds an entry in its place; one of the same time and part gives way.
    pub fn add(&mut self, entry: Entry) {
        self.entries
            .retain(|e| (e.time, e.part) != (entry.time, entry.part));
        let place = self
            .entries
            .partition_point(|e| (e.time, e.part) < (entry.time, entry.part));
        self.entries.insert(place, entry);
    }

    /// Drops the entries later than `time`, from where a run resumes.
    pub fn drop_after(&mut self, time: f64) {
        self.entries.retain(|e| e.time <= time);
    }

    /// Writes the collection, atomically.
    ///
    /// # Errors
    /// [`FileError::Write`] names the path.
    pub fn write(&self) -> Result<(), FileError> {
        write_atomically(&self.path, |out| {
            writeln!(out, "<?xml version=\"1.0\"?>")?;
            write!(out, "<VTKFile type=\"Collection\" version=\"0.1\"")?;
            writeln!(out, " byte_order=\"LittleEndian\">\n<Collection>")?;
            for Entry {
                time,
                part,
                name,
                file,
            } in &self.entries
            {
                let (name, file) = (escape(name), escape(file));
                write!(
                    out,
                    "<DataSet timestep=\"{time}\" group=\"\" part=\"{part}\""
                )?;
                writeln!(out, " name=\"{name}\" file=\"{file}\"/>")?;
            }
            writeln!(out, "</Collection>\n</VTKFile>")
        })
    }
}

fn parse(line: &str) -> Option<Entry> {
    let attribute = |name: &str| {
        let (_, rest) = line.split_once(&format!(" {name}=\""))?;
        rest.split_once('"').map(|(value, _)| unescape(value))
    };
    Some(Entry {
        time: attribute("timestep")?.parse().ok()?,
        part: attribute("part")?.parse().ok()?,
        name: attribute("name")?,
        file: attribute("file")?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(time: f64, part: usize, file: &str) -> Entry {
        Entry {
            time,
            part,
            name: "bodies".to_string(),
            file: file.to_string(),
        }
    }

    #[test]
    fn a_collection_is_read_back_and_replaces_what_it_holds() -> Result<(), OutputError> {
        let folder = std::env::temp_dir().join(format!("brinell-pvd-{}", std::process::id()));
        let mut collection = Collection::new(folder.join("a.pvd"));
        collection.add(entry(1.0, 0, "b.vtu"));
        collection.add(entry(0.1 + 0.2, 1, "a \"&\" b.vtu"));
        collection.add(entry(1.0, 0, "c.vtu"));
        collection.add(entry(1.5, 0, "d.vtu"));
        collection.drop_after(1.0);
        collection.write()?;
        let read = Collection::open(collection.path());
        let _ = fs::remove_dir_all(folder);
        assert_eq!(read?, collection);
        let files: Vec<&str> = collection
            .entries()
            .iter()
            .map(|e| e.file.as_str())
            .collect();
        assert_eq!(files, ["a \"&\" b.vtu", "c.vtu"]);
        Ok(())
    }
}
