//! Entering, leaving and passing over the sections of a mesh file.

use super::cursor::{Cursor, Encoding, quoted};
use super::error::MeshError;

impl<'a> Cursor<'a> {
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
}
