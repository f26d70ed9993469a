//! Numbers in text: separated by blanks, a record a line.

use super::cursor::Cursor;
use super::error::MeshError;

impl<'a> Cursor<'a> {
    /// The next word of the present line.
    fn word(&mut self, expected: &str) -> Result<&'a [u8], MeshError> {
        let rest = self.rest();
        let blank = |b: &u8| matches!(b, b' ' | b'\t' | b'\r');
        let from = rest.iter().position(|b| !blank(b)).unwrap_or(rest.len());
        let rest = &rest[from..];
        let length = rest
            .iter()
            .position(|b| blank(b) || *b == b'\n')
            .unwrap_or(rest.len());
        self.offset += from + length;
        match rest.first() {
            None => Err(self.truncated(expected)),
            Some(b'\n') => Err(self.syntax(expected, b"the end of the line")),
            Some(_) => Ok(&rest[..length]),
        }
    }

    pub(super) fn text_size(&mut self, expected: &str) -> Result<u64, MeshError> {
        let word = self.word(expected)?;
        digits(word).ok_or_else(|| self.syntax(expected, word))
    }

    pub(super) fn text_int(&mut self, expected: &str) -> Result<i64, MeshError> {
        let word = self.word(expected)?;
        let value = match word.strip_prefix(b"-") {
            Some(rest) => digits(rest).and_then(|v| i64::try_from(v).ok()).map(|v| -v),
            None => digits(word).and_then(|v| i64::try_from(v).ok()),
        };
        value.ok_or_else(|| self.syntax(expected, word))
    }

    pub(super) fn text_real(&mut self, expected: &str) -> Result<f64, MeshError> {
        let word = self.word(expected)?;
        let value = std::str::from_utf8(word)
            .ok()
            .and_then(|word| word.parse().ok());
        value.ok_or_else(|| self.syntax(expected, word))
    }

    /// Passes the end of the present line, on which nothing more may stand.
    pub(super) fn end_line(&mut self) -> Result<(), MeshError> {
        let line = self.line;
        self.skip_blank();
        if self.line > line || self.rest().is_empty() {
            return Ok(());
        }
        let word = self.word("the end of the line")?;
        Err(self.syntax("the end of the line", word))
    }
}

/// The value of a word of decimal digits, if it fits.
fn digits(word: &[u8]) -> Option<u64> {
    if word.is_empty() {
        return None;
    }
    word.iter().try_fold(0u64, |value, byte| {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        value.checked_mul(10)?.checked_add(u64::from(digit))
    })
}
