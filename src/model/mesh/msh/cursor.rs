//! A position in the bytes of a mesh file, and the errors that name it.
//!
//! Numbers are read by [`ascii`](super::ascii) or [`binary`](super::binary), whichever the
//! header of the file asks for; the layouts of [`v2`](super::v2) and [`v4`](super::v4) do not
//! care which.

use super::error::MeshError;
use super::place::{At, Place};

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
    section: &'a str,
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

    pub fn place(&self) -> Place {
        self.place_of(self.mark())
    }

    pub fn place_of(&self, mark: u64) -> Place {
        let (source, section) = (self.source(), self.section.to_owned());
        Place {
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

    /// Enters the next section and returns its name, or `None` at the end of the file.
    pub fn open_section(&mut self) -> Result<Option<&'a str>, MeshError> {
        self.section = "";
        self.skip_blank();
        if self.rest().is_empty() {
            return Ok(None);
        }
        let before = (self.offset, self.line);
        let line = self.rest_of_line();
        let name = line
            .strip_prefix(b"$")
            .and_then(|name| std::str::from_utf8(name).ok());
        match name {
            Some(name) if !name.is_empty() && !name.starts_with("End") => {
                self.section = name;
                Ok(Some(name))
            }
            _ => {
                (self.offset, self.line) = before;
                Err(self.syntax("the heading of a section such as `$Nodes`", line))
            }
        }
    }

    /// Passes the `$End...` of the present section.
    pub fn close_section(&mut self) -> Result<(), MeshError> {
        self.skip_blank();
        let end = format!("$End{}", self.section);
        if self.rest().is_empty() {
            return Err(self.truncated(&format!("`{end}`")));
        }
        let before = (self.offset, self.line);
        let line = self.rest_of_line();
        if line == end.as_bytes() {
            return Ok(());
        }
        (self.offset, self.line) = before;
        if end.as_bytes().starts_with(line) && self.rest().len() == line.len() {
            return Err(self.truncated(&format!("`{end}`")));
        }
        if line.starts_with(b"$") {
            return Err(self.syntax(&format!("`{end}`"), line));
        }
        Err(MeshError::Surplus {
            place: self.place(),
            found: quoted(line),
        })
    }

    /// Everything up to the `$End...` of the present section, both passed.
    pub fn skip_section(&mut self) -> Result<&'a [u8], MeshError> {
        let end = format!("$End{}", self.section);
        let body = self.rest();
        let mut from = 0;
        while let Some(dollar) = body[from..].iter().position(|b| *b == b'$') {
            let start = from + dollar;
            let begins_line = start == 0 || body.get(start - 1) == Some(&b'\n');
            if begins_line && body[start..].starts_with(end.as_bytes()) {
                let inside = &body[..start];
                self.offset += start;
                if self.encoding == Encoding::Text {
                    self.line += inside.iter().filter(|b| **b == b'\n').count() as u64;
                }
                self.close_section()?;
                return Ok(inside);
            }
            from = start + 1;
        }
        Err(self.truncated(&format!("`{end}`")))
    }

    /// Begins a record and returns its mark. In text it begins with the next line that is not
    /// empty, and must not be the end of the section.
    pub fn begin(&mut self, expected: &str) -> Result<u64, MeshError> {
        if self.encoding == Encoding::Text {
            self.skip_blank();
            let rest = self.rest();
            if rest.starts_with(b"$") {
                let line = rest.split(|b| *b == b'\n').next().unwrap_or_default();
                return Err(self.syntax(expected, line.trim_ascii()));
            }
        }
        if self.rest().is_empty() {
            return Err(self.truncated(expected));
        }
        Ok(self.mark())
    }

    /// Ends a record: in text, nothing more may stand on its line.
    pub fn finish(&mut self) -> Result<(), MeshError> {
        match self.encoding {
            Encoding::Text => self.end_line(),
            Encoding::Binary { .. } => Ok(()),
        }
    }

    /// A four-byte integer.
    pub fn int(&mut self, expected: &str) -> Result<i64, MeshError> {
        match self.encoding {
            Encoding::Text => self.text_int(expected),
            Encoding::Binary { big_endian } => self.binary_int(big_endian, expected),
        }
    }

    /// A four-byte integer that counts or numbers something.
    pub fn natural(&mut self, expected: &str) -> Result<u64, MeshError> {
        let value = self.int(expected)?;
        u64::try_from(value).map_err(|_| {
            self.syntax(
                &format!("{expected}, not negative,"),
                value.to_string().as_bytes(),
            )
        })
    }

    /// An eight-byte unsigned integer.
    pub fn size(&mut self, expected: &str) -> Result<u64, MeshError> {
        match self.encoding {
            Encoding::Text => self.text_size(expected),
            Encoding::Binary { big_endian } => self.binary_size(big_endian, expected),
        }
    }

    /// A floating-point number of eight bytes.
    pub fn real(&mut self, expected: &str) -> Result<f64, MeshError> {
        match self.encoding {
            Encoding::Text => self.text_real(expected),
            Encoding::Binary { big_endian } => self.binary_real(big_endian, expected),
        }
    }

    /// The coordinates of node `node`, which must be finite.
    pub fn point(&mut self, node: u64) -> Result<[f64; 3], MeshError> {
        let mut point = [0.0; 3];
        for (value, axis) in point.iter_mut().zip(['x', 'y', 'z']) {
            *value = self.real("a coordinate")?;
            if !value.is_finite() {
                return Err(MeshError::NotFinite {
                    place: self.place(),
                    node,
                    axis,
                    value: *value,
                });
            }
        }
        Ok(point)
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
