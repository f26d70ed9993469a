//! Where in a case file a value stands, and values that remember it.

use std::ops::Range;

use super::error::{CaseError, ErrorKind};
use super::nearest::advice;
use super::source::Source;

/// A key of the case file and the bytes of its value.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyPlace {
    /// The file.
    pub source: Source,
    /// Dotted path, for example `bearing.roller_wall`; `contact#2.upper` in the second
    /// `[[contact]]`.
    pub key: String,
    /// Empty where the template and not the user wrote the value.
    pub span: Range<usize>,
}

impl KeyPlace {
    /// An error about the value that stands here: "`key = value`: why".
    pub fn error(&self, kind: ErrorKind, why: impl AsRef<str>) -> CaseError {
        let why = why.as_ref();
        let text = self
            .source
            .text()
            .get(self.span.clone())
            .unwrap_or_default();
        // The value is told where it is short, and not where it is the key itself or the header
        // of its table.
        let name = text.trim_matches(['[', ']']);
        let is_key = self.key.ends_with(name);
        let is_header = text.starts_with('[') && self.key.starts_with(name);
        let named = if is_key || is_header || text.len() > 60 || text.contains('\n') {
            self.key.clone()
        } else {
            format!("{} = {text}", self.key)
        };
        let error = CaseError::new(kind, format!("`{named}`: {why}"));
        if self.span.is_empty() {
            error
        } else {
            error.at(&self.source, self.span.clone(), "here")
        }
    }

    /// An error about the `name` that stands here and is none of those `known`.
    pub(super) fn unknown<'a>(
        &self,
        why: impl AsRef<str>,
        name: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> CaseError {
        let error = self.error(ErrorKind::UnknownName, why);
        error.help(advice(name, known))
    }
}

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Located<T> {
    /// What was read.
    pub value: T,
    /// Where it stands.
    pub place: KeyPlace,
}

impl<T> Located<T> {
    /// Another value at the same place.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Located<U> {
        Located {
            value: f(self.value),
            place: self.place,
        }
    }

    /// The value where `holds`, else an error that says `why`.
    pub fn require(
        self,
        holds: impl FnOnce(&T) -> bool,
        why: impl AsRef<str>,
    ) -> Result<Self, CaseError> {
        if holds(&self.value) {
            Ok(self)
        } else {
            Err(self.place.error(ErrorKind::Value, why))
        }
    }
}

impl Located<f64> {
    /// Itself, if it is positive.
    ///
    /// # Errors
    /// [`CaseError`] marks the value.
    pub fn positive(self) -> Result<Self, CaseError> {
        self.require(|v| *v > 0.0, "must be positive")
    }

    /// Itself, if it is not negative.
    ///
    /// # Errors
    /// [`CaseError`] marks the value.
    pub fn not_negative(self) -> Result<Self, CaseError> {
        self.require(|v| *v >= 0.0, "must not be negative")
    }
}
