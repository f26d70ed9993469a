//! The file in which the true values of a set are stored.

use super::bearing::Bearing;
use super::pair::MeshPair;
use super::quantile::quantile;
use super::set::Set;
use crate::ground::file::FileError;
use crate::ground::file::write_atomically;
use crate::ground::hash::Fnv;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

/// Where the files are, from the folder of the project.
const FOLDER: &str = "cases/coverage";

/// What is stored of a bearing.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Stored {
    pub bearing: String,
    /// Hash of the text of its case: another one of the same name is another bearing.
    pub case: String,
    /// All steel elastic.
    pub elastic: Option<MeshPair>,
    /// As drawn, where that is not elastic.
    pub own: Option<MeshPair>,
}

impl Stored {
    /// Is that pair there?
    pub fn has(&self, elastic: bool) -> bool {
        match elastic {
            true => self.elastic.is_some(),
            false => self.own.is_some(),
        }
    }
}

/// The references of a set.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct References(Vec<Stored>);

pub fn path(set: Set) -> PathBuf {
    Path::new(FOLDER).join(format!("{set}.json"))
}

impl References {
    /// Those of `set`; none where there is no file, or it is of another format.
    ///
    /// # Errors
    /// [`FileError::Read`] where there is not even their folder.
    pub fn read(set: Set) -> Result<Self, FileError> {
        if !Path::new(FOLDER).is_dir() {
            let why = "true values of bearings are there: run this in the folder of the project";
            return Err(FileError::Read {
                path: std::path::absolute(FOLDER).unwrap_or_else(|_| FOLDER.into()),
                source: io::Error::new(io::ErrorKind::NotFound, why),
            });
        }
        let text = std::fs::read_to_string(path(set)).unwrap_or_default();
        Ok(Self(serde_json::from_str(&text).unwrap_or_default()))
    }

    /// How many bearings are stored.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// One bearing a line.
    ///
    /// # Errors
    /// [`FileError::Write`].
    pub fn write(&self, set: Set) -> Result<(), FileError> {
        write_atomically(&path(set), |out| {
            for (number, stored) in self.0.iter().enumerate() {
                write!(out, "{}", if number == 0 { "[\n" } else { ",\n" })?;
                serde_json::to_writer(&mut *out, stored)?;
            }
            writeln!(out, "\n]")
        })
    }

    /// What is stored of `bearing`.
    pub fn of(&self, bearing: &Bearing) -> Option<&Stored> {
        let same = |s: &&Stored| s.bearing == bearing.name && s.case == Fnv::hex(&bearing.text);
        self.0.iter().find(same)
    }

    /// The entry of `bearing`, empty where there was none or one of another bearing.
    fn entry(&mut self, bearing: &Bearing) -> &mut Stored {
        let fresh = || Stored {
            bearing: bearing.name.clone(),
            case: Fnv::hex(&bearing.text),
            ..Stored::default()
        };
        match self.0.iter().position(|s| s.bearing == bearing.name) {
            Some(at) => {
                if self.0[at].case != Fnv::hex(&bearing.text) {
                    self.0[at] = fresh();
                }
                &mut self.0[at]
            }
            None => {
                self.0.push(fresh());
                let last = self.0.len() - 1;
                &mut self.0[last]
            }
        }
    }

    /// Keeps a pair.
    pub fn keep(&mut self, bearing: &Bearing, elastic: bool, pair: MeshPair) {
        let stored = self.entry(bearing);
        match elastic {
            true => stored.elastic = Some(pair),
            false => stored.own = Some(pair),
        }
    }

    /// By how much the two meshes differ, relative to the value, in the middle of all bearings, by
    /// figure.
    pub fn scatter(&self) -> BTreeMap<String, f64> {
        let pairs = (self.0.iter()).flat_map(|s| s.elastic.iter().chain(&s.own));
        let mut all: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for (what, places) in pairs.flat_map(|pair| &pair.figures) {
            let differences = places.values().filter_map(|two| match two {
                [Some(coarse), Some(fine)] if *fine != 0.0 => Some((coarse / fine - 1.0).abs()),
                _ => None,
            });
            all.entry(what.clone()).or_default().extend(differences);
        }
        let middle = |list: Vec<f64>| quantile(list, 0.5).unwrap_or(0.0);
        all.into_iter()
            .map(|(what, list)| (what, middle(list)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair() -> MeshPair {
        MeshPair {
            version: String::new(),
            unknowns: [0; 2],
            cpu_s: [0.0; 2],
            figures: BTreeMap::new(),
        }
    }

    #[test]
    fn what_is_stored_of_a_bearing_is_not_taken_for_another_one() {
        let mut bearing = Set::Named.bearings().remove(0);
        let mut known = References::default();
        known.keep(&bearing, true, pair());
        known.keep(&bearing, false, pair());
        assert!(
            known
                .of(&bearing)
                .is_some_and(|s| s.has(true) && s.has(false))
        );
        bearing.text.push('\n');
        assert!(known.of(&bearing).is_none());
        known.keep(&bearing, true, pair());
        assert!(known.of(&bearing).is_some_and(|s| !s.has(false)));
        assert_eq!(known.0.len(), 1);
    }
}
