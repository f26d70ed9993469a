//! The records of a section and their numbers, in text or binary.

use super::cursor::{Cursor, Encoding};
use super::error::MeshError;

impl Cursor<'_> {
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
