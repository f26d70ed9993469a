//! All grades that a case can name.

use super::grade::{Grade, GradeError};
use super::read::grades;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::nearest::{list, ranked};
use crate::case::source::Source;
use std::path::Path;

/// The file that comes with the program.
const SHIPPED: &str = include_str!("grades.toml");

/// Names that are offered for one that is not known.
const OFFERED: usize = 4;

/// Grades by name; those of one's own go before those that come with the program.
#[derive(Debug, Clone, PartialEq)]
pub struct Grades {
    all: Vec<Grade>,
}

impl Grades {
    /// Those that come with the program.
    ///
    /// # Errors
    /// None: a test reads the file.
    pub fn shipped() -> Result<Self, CaseError> {
        let all = grades(&Source::new("grades.toml", SHIPPED))?;
        Ok(Self { all })
    }

    /// With those of the file at `path`, which go before.
    ///
    /// # Errors
    /// Where the file cannot be read, or is no file of grades.
    pub fn with_file(self, path: &Path) -> Result<Self, CaseError> {
        let text = crate::ground::input::text(path).map_err(|error| {
            let message = format!("the grades {} cannot be read: {error}", path.display());
            CaseError::new(ErrorKind::Read, message)
        })?;
        let mut all = grades(&Source::new(&path.display().to_string(), &text))?;
        all.extend(self.all);
        Ok(Self { all })
    }

    /// The grade called `name`, blind to case, blanks and hyphens.
    ///
    /// # Errors
    /// [`GradeError::Unknown`] with the nearest names.
    pub fn find(&self, name: &str) -> Result<&Grade, GradeError> {
        let wanted = plain(name);
        let goes_by = |grade: &&Grade| names(grade).any(|known| plain(known) == wanted);
        self.all.iter().find(goes_by).ok_or_else(|| {
            let near = ranked(name, self.all.iter().flat_map(names));
            let near = near.into_iter().take(OFFERED);
            GradeError::Unknown {
                name: name.to_owned(),
                advice: format!(
                    "the nearest are: {}; all are in the reference, and a file of your own may have others",
                    list(near)
                ),
            }
        })
    }

    /// All of them.
    pub fn all(&self) -> &[Grade] {
        &self.all
    }
}

fn names(grade: &Grade) -> impl Iterator<Item = &str> {
    std::iter::once(grade.name.as_str()).chain(grade.also.iter().map(String::as_str))
}

/// Letters, digits and the plus sign alone, small.
fn plain(name: &str) -> String {
    let kept = name.chars().filter(|c| c.is_alphanumeric() || *c == '+');
    kept.flat_map(char::to_lowercase).collect()
}
