//! Title, headings, rows and notes.

use super::Cell;

/// The head of a column.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Heading {
    pub name: String,
    /// Of the figures below; empty where they have none, or each its own.
    pub unit: String,
    /// Does the column hold words, which stand flush left, and not figures?
    pub words: bool,
    /// Is the column only for where there is room, as on a page, and not on the terminal?
    pub wide: bool,
}

/// Rows under headings. The first column names the rows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// May be empty: then the first heading says what the table is about.
    pub title: String,
    pub headings: Vec<Heading>,
    /// A row may be shorter than the headings.
    pub rows: Vec<Vec<Cell>>,
    /// What must be known of the figures, below them.
    pub notes: Vec<String>,
    /// What the figures are, for readers of a page; the terminal leaves it to the manual.
    pub about: &'static str,
}

impl Table {
    /// A table without columns and rows.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            ..Self::default()
        }
    }

    /// With columns of figures without units, by their names.
    pub fn figures<S: Into<String>>(mut self, names: impl IntoIterator<Item = S>) -> Self {
        self.headings.extend(names.into_iter().map(|name| Heading {
            name: name.into(),
            ..Heading::default()
        }));
        self
    }

    /// With a column of figures in `unit`.
    pub fn figure(mut self, name: &str, unit: impl Into<String>) -> Self {
        self.headings.push(Heading {
            name: name.to_string(),
            unit: unit.into(),
            ..Heading::default()
        });
        self
    }

    /// With a column of words.
    pub fn words(mut self, name: &str) -> Self {
        self.headings.push(Heading {
            name: name.to_string(),
            words: true,
            ..Heading::default()
        });
        self
    }

    /// The last column is only for where there is room.
    pub fn wide(mut self) -> Self {
        if let Some(heading) = self.headings.last_mut() {
            heading.wide = true;
        }
        self
    }

    /// With an explanation for readers of a page.
    pub fn about(mut self, about: &'static str) -> Self {
        self.about = about;
        self
    }

    /// Adds a row.
    pub fn row(&mut self, cells: impl IntoIterator<Item = Cell>) {
        self.rows.push(cells.into_iter().collect());
    }

    /// Adds a note.
    pub fn note(&mut self, note: impl Into<String>) {
        self.notes.push(note.into());
    }
}
