//! Reads the value of a field: a string, true or false, a count, one of a few words.

use super::error::{CaseError, ErrorKind};
use super::nearest::{advice, list};
use super::parse::Field;
use super::place::Located;

impl Field<'_> {
    pub fn string(&self) -> Result<Located<String>, CaseError> {
        let text = self
            .raw()
            .as_str()
            .ok_or_else(|| self.wrong_type("a string"))?;
        let named = self.located(text.to_string());
        named.require(|text| !text.trim().is_empty(), "must not be empty")
    }

    pub fn boolean(&self) -> Result<Located<bool>, CaseError> {
        let value = self
            .raw()
            .as_bool()
            .ok_or_else(|| self.wrong_type("true or false"))?;
        Ok(self.located(value))
    }

    /// A whole number of things, at least one.
    pub fn count(&self) -> Result<Located<usize>, CaseError> {
        let integer = self
            .raw()
            .as_integer()
            .ok_or_else(|| self.wrong_type("a whole number"))?;
        let value = usize::from_str_radix(integer.as_str(), integer.radix()).ok();
        match value.filter(|v| *v > 0) {
            Some(value) => Ok(self.located(value)),
            None => Err(self
                .place()
                .error(ErrorKind::Value, "must be a whole number, 1 or more")),
        }
    }

    /// One of a few words.
    pub fn choice<T: Copy>(&self, choices: &[(&str, T)]) -> Result<Located<T>, CaseError> {
        let word = self.string()?;
        let names = || choices.iter().map(|(name, _)| *name);
        match choices.iter().find(|(name, _)| *name == word.value) {
            Some((_, value)) => Ok(word.map(|_| *value)),
            None => {
                let why = format!("must be one of: {}", list(names()));
                let help = advice(&word.value, names());
                Err(word.place.error(ErrorKind::Value, why).help(help))
            }
        }
    }
}
