//! What can stop a sweep, rather than one of its rows.

use crate::case::CaseError;
use crate::ground::file::FileError;
use crate::render::OutputError;
use miette::{Diagnostic, NamedSource, SourceSpan};
use std::ops::Range;
use std::path::{Path, PathBuf};
use thiserror::Error;

#[derive(Debug, Error, Diagnostic)]
pub enum SweepError {
    #[error("{} cannot be read: {error}", path.display())]
    #[diagnostic(code(brinell::sweep::read))]
    Read {
        path: PathBuf,
        error: std::io::Error,
    },
    #[error(transparent)]
    #[diagnostic(transparent)]
    File(Box<FileMistake>),
    #[error("{}: {message}", path.display())]
    #[diagnostic(
        code(brinell::sweep::csv),
        help(
            "the first line names keys of the case, such as bearing.load; each further line has \
              one value for each of them"
        )
    )]
    Csv { path: PathBuf, message: String },
    #[error("{wrong} of {all} rows cannot be run; nothing was")]
    #[diagnostic(code(brinell::sweep::rows))]
    Rows {
        wrong: usize,
        all: usize,
        #[related]
        errors: Vec<RowError>,
    },
    #[error("there is no row {row}: the sweep has {rows}")]
    #[diagnostic(code(brinell::sweep::no_such_row), help("rows are counted from 1"))]
    NoSuchRow { row: usize, rows: usize },
    #[error("{} cannot stand in a job script", path.display())]
    #[diagnostic(
        code(brinell::sweep::script),
        help("choose a path without line breaks, quotes, backslashes and percent signs")
    )]
    Script { path: PathBuf },
    #[error("another sweep writes into {}", path.display())]
    #[diagnostic(
        code(brinell::sweep::busy),
        help("wait for it, or name another folder with --out")
    )]
    Busy { path: PathBuf },
    #[error("{} holds {rows} rows of an earlier sweep", path.display())]
    #[diagnostic(
        code(brinell::sweep::there),
        help(
            "--resume goes on with it, and runs anew only what has changed; to start from the \
              first row, name another folder with --out or remove this one"
        )
    )]
    There { path: PathBuf, rows: usize },
    #[error("row {row} is not what has been prepared in {}", path.display())]
    #[diagnostic(
        code(brinell::sweep::changed),
        help(
            "nothing has been, or the sweep or its case has changed since: prepare the rows by \
              --emit slurm --resume"
        )
    )]
    Changed { row: usize, path: PathBuf },
    #[error("{} cannot be used: {error}", path.display())]
    #[diagnostic(
        code(brinell::sweep::folder),
        help("name another folder with --out, or make room and give write permission")
    )]
    Folder {
        path: PathBuf,
        error: std::io::Error,
    },
    #[error("a run of a row cannot be started: {error}")]
    #[diagnostic(code(brinell::sweep::start))]
    Start { error: std::io::Error },
    #[error(transparent)]
    #[diagnostic(code(brinell::sweep::output))]
    Output(#[from] OutputError),
}

impl From<FileError> for SweepError {
    fn from(error: FileError) -> Self {
        Self::Output(error.into())
    }
}

/// What is wrong with a sweep file, and where.
#[derive(Debug, Error, Diagnostic)]
#[error("{message}")]
#[diagnostic(code(brinell::sweep::file))]
pub struct FileMistake {
    pub message: String,
    #[source_code]
    text: NamedSource<String>,
    #[label("here")]
    span: SourceSpan,
    #[help]
    help: Option<String>,
}

/// What is wrong with a row.
#[derive(Debug, Error, Diagnostic)]
#[error("row {row}, {place}")]
#[diagnostic(code(brinell::sweep::row))]
pub struct RowError {
    /// Counted from 1.
    pub row: usize,
    /// Column and value that are to blame, or all of them where none is alone.
    pub place: String,
    #[source]
    #[diagnostic_source]
    pub error: CaseError,
}

impl SweepError {
    pub(super) fn folder(path: &Path, error: std::io::Error) -> Self {
        Self::Folder {
            path: path.to_owned(),
            error,
        }
    }

    /// An error that marks the bytes `span` of the sweep file `name`.
    pub(super) fn at(
        (name, text): (&Path, &str),
        span: Range<usize>,
        message: impl Into<String>,
        help: Option<String>,
    ) -> Self {
        Self::File(Box::new(FileMistake {
            message: message.into(),
            text: NamedSource::new(name.to_string_lossy(), text.to_owned()),
            span: span.into(),
            help,
        }))
    }
}
