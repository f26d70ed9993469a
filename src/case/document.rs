//! The TOML document of a case file, before its keys are looked at.

use toml::Spanned;
use toml::de::DeTable;

use super::error::{CaseError, ErrorKind};
use super::source::Source;
use crate::ground::units::UnitSystem;

/// What every table of a file shares.
#[derive(Clone, Copy)]
pub(super) struct Context<'a> {
    pub source: &'a Source,
    /// The system of the file: what bare numbers are in, and what quantities are turned into.
    pub units: UnitSystem,
}

/// The document of `source`.
pub(super) fn document(source: &Source) -> Result<Spanned<DeTable<'_>>, CaseError> {
    DeTable::parse(source.text()).map_err(|error| {
        let message = error.message().trim().replace('\n', ", ");
        let line = error.span().map_or(1, |s| line_of(source.text(), s.start));
        let report = CaseError::new(ErrorKind::Syntax, format!("line {line}: {message}"));
        match error.span() {
            Some(span) => report.at(source, span, "here"),
            None => report,
        }
    })
}

fn line_of(text: &str, offset: usize) -> usize {
    text.bytes().take(offset).filter(|b| *b == b'\n').count() + 1
}
