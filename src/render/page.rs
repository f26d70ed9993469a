//! Generated parts of pages of the documentation, between markers.

use crate::ground::file::{FileError, write_text};
use std::path::{Path, PathBuf};

/// Why a part of a page could not be put in or read.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    #[error(transparent)]
    File(#[from] FileError),
    #[error("{} has no pair of markers <!-- {name} --> and <!-- /{name} -->", path.display())]
    Markers { path: PathBuf, name: String },
}

/// The markers before and after a part.
fn markers(name: &str) -> [String; 2] {
    [format!("<!-- {name} -->"), format!("<!-- /{name} -->")]
}

/// The page, and where part `name` begins and ends in it; `None` where it has neither marker.
fn part(path: &Path, name: &str) -> Result<(String, Option<[usize; 2]>), PageError> {
    let text = std::fs::read_to_string(path).map_err(|source| FileError::Read {
        path: path.to_path_buf(),
        source,
    })?;
    let [begin, end] = markers(name);
    let place = match (text.find(&begin), text.find(&end)) {
        (Some(from), Some(to)) if from < to => Some([from + begin.len(), to]),
        (None, None) => None,
        _ => {
            return Err(PageError::Markers {
                path: path.to_path_buf(),
                name: name.to_owned(),
            });
        }
    };
    Ok((text, place))
}

/// What stands between the markers `name` of a page.
///
/// # Errors
/// Where the page cannot be read or has no such markers.
pub fn between(path: &Path, name: &str) -> Result<String, PageError> {
    let (text, place) = part(path, name)?;
    let [from, to] = place.ok_or_else(|| PageError::Markers {
        path: path.to_path_buf(),
        name: name.to_owned(),
    })?;
    Ok(text[from..to].to_owned())
}

/// Puts `new` between the markers `name` of a page, at its end where there are none.
///
/// # Errors
/// Where the page cannot be read or written, or has one marker without the other.
pub fn insert(path: &Path, name: &str, new: &str) -> Result<(), PageError> {
    let (text, place) = part(path, name)?;
    let new = new.trim_end();
    let whole = match place {
        Some([from, to]) => format!("{}\n{new}\n{}", &text[..from], &text[to..]),
        None => {
            let [begin, end] = markers(name);
            format!("{}\n\n{begin}\n{new}\n{end}\n", text.trim_end())
        }
    };
    Ok(write_text(path, &whole)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_put_in_and_found_again() {
        let folder = std::env::temp_dir().join(format!("brinell-page-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let page = folder.join("page.md");
        std::fs::write(&page, "# Page\n\n<!-- a -->\nold\n<!-- /a -->\nrest\n").unwrap();
        insert(&page, "a", "new\n").unwrap();
        insert(&page, "b", "more").unwrap();
        assert_eq!(between(&page, "a").unwrap().trim(), "new");
        assert_eq!(between(&page, "b").unwrap().trim(), "more");
        let text = std::fs::read_to_string(&page).unwrap();
        assert!(text.contains("rest") && text.ends_with("<!-- /b -->\n"));
        assert!(between(&page, "c").is_err());
        std::fs::write(&page, "<!-- a -->").unwrap();
        assert!(insert(&page, "a", "new").is_err());
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
