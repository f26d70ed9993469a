//! The page `docs/stability.md`, whose sections are written one by one.

use crate::ground::file::FileError;
use crate::ground::file::write_text;
use std::io;
use std::path::Path;

/// A section of the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StabilitySection {
    Extreme,
    Random,
}

const TITLE: &str = "# Stability\n";

impl StabilitySection {
    const ALL: [Self; 2] = [Self::Extreme, Self::Random];

    fn heading(self) -> &'static str {
        match self {
            Self::Extreme => "\n## Extreme cases\n\n",
            Self::Random => "\n## Random cases\n\n",
        }
    }
}

/// Puts `text` in the place of one section of the page, and leaves the others as they are.
///
/// # Errors
/// Where the page cannot be read or written.
pub fn write(path: &Path, part: StabilitySection, text: &str) -> Result<(), FileError> {
    let old = match std::fs::read_to_string(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(String::new()),
        read => read,
    };
    let old = old.map_err(|source| FileError::Write {
        path: path.to_owned(),
        source,
    })?;
    write_text(path, &renewed(&old, part, text))
}

fn renewed(old: &str, part: StabilitySection, text: &str) -> String {
    let kept = |of: StabilitySection| {
        let (_, section) = old.split_once(of.heading())?;
        let next = section.find("\n## ").unwrap_or(section.len());
        Some(section[..next].to_owned())
    };
    let mut page = TITLE.to_owned();
    for of in StabilitySection::ALL {
        let section = if of == part {
            Some(text.to_owned())
        } else {
            kept(of)
        };
        if let Some(section) = section {
            page.push_str(of.heading());
            page.push_str(&section);
        }
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_section_is_renewed_and_the_other_stays() {
        let first = renewed("", StabilitySection::Random, "none\n");
        let both = renewed(&first, StabilitySection::Extreme, "a\n");
        assert!(both.find("## Extreme") < both.find("## Random"));
        let again = renewed(&both, StabilitySection::Extreme, "b\n");
        assert_eq!(again, both.replace("a\n\n## R", "b\n\n## R"));
    }
}
