//! Where in a mesh file something stands.

use std::fmt;

/// A place in a mesh file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FilePlace {
    /// The file.
    pub source: String,
    /// The section, without the dollar sign; empty between sections.
    pub section: String,
    /// The line of a text, or the byte of a binary.
    pub at: At,
}

/// A position: a line of a text file, a byte of a binary one (after decompression).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum At {
    /// Counted from one.
    Line(u64),
    /// Counted from zero.
    Byte(u64),
}

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            At::Line(line) => write!(f, "line {line}"),
            At::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

impl fmt::Display for FilePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.source, self.at)?;
        if self.section.is_empty() {
            Ok(())
        } else {
            write!(f, " in ${}", self.section)
        }
    }
}
