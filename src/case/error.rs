//! What is wrong with a case file, where, and what would help.

use std::fmt;
use std::sync::Arc;

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode, SourceSpan};

use super::source::Source;

/// The kinds of mistakes, each with a stable code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorKind {
    /// The file cannot be read.
    Read,
    /// The file is not TOML.
    Syntax,
    /// A key that no case has.
    UnknownKey,
    /// A key that is needed.
    MissingKey,
    /// A string where a number is wanted, and the like.
    WrongType,
    /// A quantity whose unit is missing, not known, or of the wrong dimension.
    Unit,
    /// A value outside of what is physical or supported.
    Value,
    /// Two entries that contradict each other.
    Conflict,
    /// Something is said twice.
    Duplicate,
    /// A body, surface or load that does not exist.
    UnknownName,
    /// The mesh does not fit the case.
    Mesh,
}

impl ErrorKind {
    /// The code that is printed and can be searched for.
    pub fn code(self) -> &'static str {
        match self {
            Self::Read => "brinell::case::read",
            Self::Syntax => "brinell::case::syntax",
            Self::UnknownKey => "brinell::case::unknown_key",
            Self::MissingKey => "brinell::case::missing_key",
            Self::WrongType => "brinell::case::wrong_type",
            Self::Unit => "brinell::case::unit",
            Self::Value => "brinell::case::value",
            Self::Conflict => "brinell::case::conflict",
            Self::Duplicate => "brinell::case::duplicate",
            Self::UnknownName => "brinell::case::unknown_name",
            Self::Mesh => "brinell::case::mesh",
        }
    }
}

/// One mistake in a case, with the culprit marked where the file is at hand.
#[derive(Clone)]
pub struct CaseError(Box<Report>);

#[derive(Clone)]
struct Report {
    kind: ErrorKind,
    message: String,
    label: String,
    help: Option<String>,
    source: Option<NamedSource<Arc<str>>>,
    span: Option<SourceSpan>,
}

impl CaseError {
    /// An error without a place.
    pub fn new(kind: ErrorKind, message: impl Into<String>) -> Self {
        let message = message.into();
        Self(Box::new(Report {
            kind,
            message,
            label: String::new(),
            help: None,
            source: None,
            span: None,
        }))
    }

    /// Marks the bytes `span` of the file with `label`.
    pub(super) fn at(
        mut self,
        source: &Source,
        span: std::ops::Range<usize>,
        label: impl Into<String>,
    ) -> Self {
        self.0.source = Some(NamedSource::new(source.name(), source.shared_text()));
        self.0.span = Some(span.into());
        self.0.label = label.into();
        self
    }

    /// The same of a text that goes by another name.
    pub(super) fn of_file(mut self, name: &str) -> Self {
        let text = self.0.source.take();
        self.0.source = text.map(|text| NamedSource::new(name, text.inner().clone()));
        self
    }

    /// Adds advice.
    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    /// The kind of mistake.
    pub fn kind(&self) -> ErrorKind {
        self.0.kind
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.message)
    }
}

impl fmt::Debug for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.0.kind.code(), self.0.message)
    }
}

impl std::error::Error for CaseError {}

impl Diagnostic for CaseError {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.0.kind.code()))
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.0
            .help
            .as_ref()
            .map(|help| Box::new(help) as Box<dyn fmt::Display + 'a>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.0
            .source
            .as_ref()
            .map(|source| source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let span = self.0.span?;
        let label = LabeledSpan::new_with_span(Some(self.0.label.clone()), span);
        Some(Box::new(std::iter::once(label)))
    }
}
