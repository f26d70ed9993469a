//! A position in the bytes of a mesh file, and the errors that name it.
//!
//! Numbers are read by [`ascii`](super::ascii) or [`binary`](super::binary), whichever the
//! header of the file asks for (`records` chooses); the layouts of [`v2`](super::v2) and
//! [`v4`](super::v4) do not care which.

use super::error::MeshError;
use super::place::{At, FilePlace};

/// How numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Binary { big_endian: bool },
}

/// Reads a mesh file from front to back.
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    pub(super) offset: usize,
    /// Lines passed; only kept in text.
    pub(super) line: u64,
    pub(super) encoding: Encoding,
    /// Name of the present section.
    pub(super) section: &'a str,
    source: &'a str,
}

impl<'a> Cursor<'a> {
    pub fn new(bytes: &'a [u8], source: &'a str) -> Self {
        Self {
            bytes,
            offset: 0,
            line: 1,
            encoding: Encoding::Text,
            section: "",
            source,
        }
    }

    pub fn source(&self) -> String {
        self.source.to_owned()
    }

    /// The bytes not read yet.
    pub fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.offset..).unwrap_or_default()
    }

    /// A number that [`at`](Self::at) turns into a position: a line or an offset.
    pub fn mark(&self) -> u64 {
        match self.encoding {
            Encoding::Text => self.line,
            Encoding::Binary { .. } => self.offset as u64,
        }
    }

    /// The position that `mark` stands for.
    pub fn at(&self, mark: u64) -> At {
        match self.encoding {
            Encoding::Text => At::Line(mark),
            Encoding::Binary { .. } => At::Byte(mark),
        }
    }

    pub fn place(&self) -> FilePlace {
        self.place_of(self.mark())
    }

    pub fn place_of(&self, mark: u64) -> FilePlace {
        let (source, section) = (self.source(), self.section.to_owned());
        FilePlace {
            source,
            section,
            at: self.at(mark),
        }
    }

    pub fn syntax(&self, expected: &str, found: &[u8]) -> MeshError {
        let (place, expected) = (self.place(), expected.to_owned());
        MeshError::Syntax {
            place,
            expected,
            found: quoted(found),
        }
    }

    pub fn truncated(&self, expected: &str) -> MeshError {
        MeshError::Truncated {
            place: self.place(),
            expected: expected.to_owned(),
        }
    }

    /// `count` as a size, if that many records of at least `numbers` numbers taking `bytes` bytes
    /// in binary can still come; so no count is believed that the file is too short for.
    pub fn bounded(
        &self,
        count: u64,
        what: &'static str,
        numbers: usize,
        bytes: usize,
    ) -> Result<usize, MeshError> {
        // In text a number takes a digit and a separator at least.
        let record = match self.encoding {
            Encoding::Text => numbers.saturating_mul(2),
            Encoding::Binary { .. } => bytes,
        };
        let left = self.rest().len();
        let possible = (left + 1) / record.max(1);
        match usize::try_from(count) {
            Ok(count) if count <= possible => Ok(count),
            _ => Err(MeshError::Count {
                place: self.place(),
                what,
                count,
                found: format!("but the {left} bytes left have room for {possible} at most"),
            }),
        }
    }

    /// Passes white space, line ends too.
    pub fn skip_blank(&mut self) {
        for byte in self.rest() {
            match byte {
                b'\n' => self.line += 1,
                b' ' | b'\t' | b'\r' => {}
                _ => break,
            }
            self.offset += 1;
        }
    }

    /// The rest of the present line without its end, passed.
    pub fn rest_of_line(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let length = rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
        let (line, after) = rest.split_at(length);
        self.offset += length;
        if !after.is_empty() {
            self.offset += 1;
            self.line += 1;
        }
        line.trim_ascii()
    }
}

/// What was found, for a message: short and printable.
pub(super) fn quoted(found: &[u8]) -> String {
    /// Characters that a message quotes.
    const MOST_CHARACTERS: usize = 40;
    if found.is_empty() {
        return "nothing".to_owned();
    }
    let shown: Vec<char> = String::from_utf8_lossy(&found[..found.len().min(4 * MOST_CHARACTERS)])
        .chars()
        .map(|c| if c.is_control() { '.' } else { c })
        .collect();
    let cut = if shown.len() > MOST_CHARACTERS {
        "..."
    } else {
        ""
    };
    format!(
        "`{}{cut}`",
        shown.iter().take(MOST_CHARACTERS).collect::<String>()
    )
}
