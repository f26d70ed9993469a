//! Every key of a case file: what the readers accept, what it means, and the page of the book about
//! them.
//!
//! The readers take the keys that they know from here, so a key that is not described is not accepted.

mod bearing;
mod common;
mod line_bearing;
mod pairs;
mod scene;
pub mod schema;
mod template_loads;
mod templates;

use crate::ground::markdown::table;

pub use bearing::{BEARING, BEARING_MESH, PLATE_THICKNESS, ROLLER_END};
pub use common::{ACTION, COMBINATION, COMPARISON, CONTROLS, HARDENING, ROOT, STEEL, TITLE_BLOCK};
pub use line_bearing::{
    LINE_BEARING, LINE_BEARING_MESH, LINE_PLATE_CURVE, LINE_PLATE_SIZE, LINE_PLATE_THICKNESS,
};
pub use pairs::{CONTACT, PARTNER, PLANE, TIE};
pub use scene::{
    AXES, BODY, FAMILY_MESH, FILE_MESH, LOAD, RIGID_PLANE, SCENE, STEP, SUPPORT, TEMPERATURE,
};
pub use template_loads::TILTED_TOP;

/// A key of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Key {
    pub name: &'static str,
    /// What it takes: a quantity, a word, a table.
    pub takes: &'static str,
    /// What is taken where it is missing; `required` where it may not be.
    pub default: &'static str,
    pub meaning: &'static str,
}

/// A table of a case file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Keys {
    /// As it is headed in the file.
    pub heading: &'static str,
    pub about: &'static str,
    pub keys: &'static [Key],
}

const fn key(
    name: &'static str,
    takes: &'static str,
    default: &'static str,
    meaning: &'static str,
) -> Key {
    Key {
        name,
        takes,
        default,
        meaning,
    }
}

impl Keys {
    /// The names of the keys.
    pub fn names(&self) -> Vec<&'static str> {
        self.keys.iter().map(|key| key.name).collect()
    }

    fn section(&self) -> String {
        let rows = self.keys.iter().map(|key| {
            let name = format!("`{}`", key.name);
            [&name, key.takes, key.default, key.meaning].map(str::to_owned)
        });
        format!(
            "\n### {}\n\n{}\n\n{}",
            self.heading,
            self.about,
            table(["key", "takes", "default", "meaning"], rows)
        )
    }
}

/// Chapters of the page.
const CHAPTERS: [(&str, &[&Keys]); 4] = [
    (
        "Every case",
        &[
            &ROOT,
            &TITLE_BLOCK,
            &ACTION,
            &COMBINATION,
            &STEEL,
            &HARDENING,
            &CONTROLS,
            &COMPARISON,
        ],
    ),
    (
        "A bearing",
        &[
            &BEARING,
            &TILTED_TOP,
            &PLATE_THICKNESS,
            &ROLLER_END,
            &BEARING_MESH,
        ],
    ),
    (
        "A line bearing",
        &[
            &LINE_BEARING,
            &LINE_PLATE_THICKNESS,
            &LINE_PLATE_SIZE,
            &LINE_PLATE_CURVE,
            &LINE_BEARING_MESH,
        ],
    ),
    (
        "A general scene",
        &[
            &SCENE,
            &FILE_MESH,
            &FAMILY_MESH,
            &BODY,
            &TIE,
            &CONTACT,
            &PARTNER,
            &PLANE,
            &SUPPORT,
            &TEMPERATURE,
            &RIGID_PLANE,
            &LOAD,
            &AXES,
            &STEP,
        ],
    ),
];

/// What the dotted key of a case file means, entries of lists by number or name; `None` of what is no key here.
pub fn meaning(path: &str) -> Option<&'static str> {
    let parts: Vec<&str> = path.split('.').collect();
    let (name, tables) = parts.split_last()?;
    let all = || CHAPTERS.iter().flat_map(|(_, tables)| tables.iter());
    let of = |keys: &Keys| {
        keys.keys
            .iter()
            .find(|key| key.name == *name)
            .map(|key| key.meaning)
    };
    if tables.is_empty() {
        return of(&ROOT).or_else(|| of(&SCENE));
    }
    // The innermost table that has such a key.
    tables.iter().rev().find_map(|table| {
        let words = |keys: &Keys| {
            keys.heading
                .split(['[', ']', '.', ' '])
                .any(|word| word == *table)
        };
        all().filter(|keys| words(keys)).find_map(|keys| of(keys))
    })
}

/// The page about the keys, in Markdown.
pub fn page() -> String {
    let mut text = String::from(
        "# Keys of a case file\n\nMade from the lists that the reader of case files itself goes by, by \
         `cargo run --release --example reference`; not edited by hand.\n\nA case is a \
         [TOML](https://toml.io) file. A *quantity* is a string with its unit (`\"65 kip\"`, `\"1 in\"`, \
         `\"29500 ksi\"`, `\"4 deg\"`) or a bare number in the units of the case, angles in degrees; a \
         *share* is a bare number or a string in per cent (`\"15 %\"`). A key that is not listed here \
         is an error.\n",
    );
    for (chapter, tables) in CHAPTERS {
        text.push_str(&format!("\n## {chapter}\n"));
        tables
            .iter()
            .for_each(|keys| text.push_str(&keys.section()));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_described_once() {
        for keys in CHAPTERS.iter().flat_map(|(_, tables)| tables.iter()) {
            let mut names = keys.names();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), keys.keys.len(), "{}", keys.heading);
            for key in keys.keys {
                for text in [key.takes, key.default, key.meaning] {
                    assert!(!text.is_empty() && !text.contains('|'), "{}", key.name);
                }
            }
        }
    }
}
