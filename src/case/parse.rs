//! Tables and fields of the TOML document, read with their places.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::document::Context;
use super::error::{CaseError, ErrorKind};
use super::keys::Keys;
use super::nearest::advice;
use super::place::{KeyPlace, Located};
use super::source::Source;
use crate::ground::units::UnitSystem;

/// A table whose keys have been checked against those it may have.
#[derive(Clone)]
pub(super) struct Table<'a> {
    context: Context<'a>,
    /// Dotted path of the table, empty for the whole file.
    key: String,
    span: Range<usize>,
    entries: &'a DeTable<'a>,
}

/// One value of a table or an array.
#[derive(Clone)]
pub(super) struct Field<'a> {
    context: Context<'a>,
    key: String,
    value: &'a Spanned<DeValue<'a>>,
}

impl<'a> Table<'a> {
    /// The whole file.
    pub fn root(context: Context<'a>, document: &'a Spanned<DeTable<'a>>) -> Self {
        let (span, entries) = (document.span(), document.get_ref());
        Self {
            context,
            key: String::new(),
            span,
            entries,
        }
    }

    /// The same table, its quantities read into `units`.
    pub fn with_units(self, units: UnitSystem) -> Self {
        Self {
            context: Context {
                units,
                ..self.context
            },
            ..self
        }
    }

    pub fn units(&self) -> UnitSystem {
        self.context.units
    }

    pub fn source(&self) -> &'a Source {
        self.context.source
    }

    /// Where the table begins.
    pub fn place(&self) -> KeyPlace {
        let key = self.key.clone();
        KeyPlace {
            source: self.context.source.clone(),
            key,
            span: self.header(),
        }
    }

    /// An error about the whole table.
    pub fn error(&self, kind: ErrorKind, message: impl Into<String>) -> CaseError {
        let error = CaseError::new(kind, message);
        match self.header() {
            span if span.is_empty() => error,
            span => error.at(self.context.source, span, "here"),
        }
    }

    /// The first line of the table: its span may cover all of its lines.
    fn header(&self) -> Range<usize> {
        let text = self
            .context
            .source
            .text()
            .get(self.span.clone())
            .unwrap_or_default();
        let first = text.lines().next().unwrap_or_default();
        if self.key.is_empty() {
            0..0
        } else {
            self.span.start..self.span.start + first.len()
        }
    }

    fn path(&self, key: &str) -> String {
        if self.key.is_empty() {
            key.to_string()
        } else {
            format!("{}.{key}", self.key)
        }
    }

    /// Refuses keys that are not in `known`.
    pub fn only(self, known: &Keys) -> Result<Self, CaseError> {
        self.only_either(&[known])
    }

    /// Refuses keys that are in none of `known`.
    pub fn only_either(self, known: &[&Keys]) -> Result<Self, CaseError> {
        let known: Vec<&str> = known.iter().flat_map(|keys| keys.names()).collect();
        self.unknown(&known, |_| false)?;
        Ok(self)
    }

    /// Refuses keys that are neither in `known` nor hold a table.
    pub fn only_or_tables(self, known: &Keys) -> Result<Self, CaseError> {
        self.unknown(&known.names(), |value| value.is_table())?;
        Ok(self)
    }

    fn unknown(&self, known: &[&str], fine: fn(&DeValue) -> bool) -> Result<(), CaseError> {
        let strange = |(key, value): &(&Spanned<_>, &Spanned<DeValue>)| {
            !known.contains(&name(key)) && !fine(value.get_ref())
        };
        let first = self
            .entries
            .iter()
            .filter(strange)
            .min_by_key(|(key, _)| key.span().start);
        let Some((key, _)) = first else { return Ok(()) };
        let path = self.path(name(key));
        Err(CaseError::new(
            ErrorKind::UnknownKey,
            format!("`{path}` is not a key of a case"),
        )
        .at(self.context.source, key.span(), "not known")
        .help(advice(name(key), known.iter().copied())))
    }

    /// The names of all keys, in the order of the file.
    pub fn keys(&self) -> Vec<&'a str> {
        let mut keys: Vec<_> = self.entries.keys().collect();
        keys.sort_by_key(|key| key.span().start);
        keys.into_iter().map(name).collect()
    }

    /// The place of a key itself, not of its value.
    pub fn place_of_key(&self, key: &str) -> KeyPlace {
        let found = self.entries.keys().find(|k| name(k) == key);
        let span = found.map_or(0..0, Spanned::span);
        KeyPlace {
            source: self.context.source.clone(),
            key: self.path(key),
            span,
        }
    }

    pub fn get(&self, key: &str) -> Option<Field<'a>> {
        let (_, value) = self.entries.iter().find(|(k, _)| name(k) == key)?;
        Some(Field {
            context: self.context,
            key: self.path(key),
            value,
        })
    }

    /// What `read` makes of the value of `key`, where there is one.
    pub fn maybe<T>(
        &self,
        key: &str,
        read: impl FnOnce(&Field<'a>) -> Result<T, CaseError>,
    ) -> Result<Option<T>, CaseError> {
        self.get(key).map(|field| read(&field)).transpose()
    }

    pub fn need(&self, key: &str) -> Result<Field<'a>, CaseError> {
        self.get(key).ok_or_else(|| {
            let path = self.path(key);
            self.error(
                ErrorKind::MissingKey,
                format!("the key `{path}` is missing"),
            )
        })
    }

    /// The place of the value at the dotted `path`, or of the nearest value around it where the
    /// file does not go so deep.
    pub fn deepest(&self, path: &str) -> KeyPlace {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        let Some(field) = self.get(first) else {
            return KeyPlace {
                key: self.path(path),
                ..self.place()
            };
        };
        match field.table() {
            Ok(table) if !rest.is_empty() => table.deepest(rest),
            _ => field.place(),
        }
    }

    /// The tables of `[[key]]`; none where the key is missing.
    pub fn tables(&self, key: &str) -> Result<Vec<Table<'a>>, CaseError> {
        let Some(field) = self.get(key) else {
            return Ok(Vec::new());
        };
        let help = format!("each begins with a line [[{}]]", self.path(key));
        let items = field.list().map_err(|error| error.help(help))?;
        items.iter().map(Field::table).collect()
    }
}

fn name<'a>(key: &'a Spanned<toml::de::DeString<'_>>) -> &'a str {
    key.get_ref().as_ref()
}

impl<'a> Field<'a> {
    pub fn place(&self) -> KeyPlace {
        let source = self.context.source.clone();
        KeyPlace {
            source,
            key: self.key.clone(),
            span: self.value.span(),
        }
    }

    pub fn units(&self) -> UnitSystem {
        self.context.units
    }

    pub(super) fn raw(&self) -> &'a DeValue<'a> {
        self.value.get_ref()
    }

    pub fn wrong_type(&self, wanted: &str) -> CaseError {
        let found = match self.raw().type_str() {
            vowel if vowel.starts_with(['a', 'i', 'o']) => format!("an {vowel}"),
            other => format!("a {other}"),
        };
        let why = format!("{wanted} is wanted, this is {found}");
        self.place().error(ErrorKind::WrongType, why)
    }

    pub fn located<T>(&self, value: T) -> Located<T> {
        Located {
            value,
            place: self.place(),
        }
    }

    pub fn list(&self) -> Result<Vec<Field<'a>>, CaseError> {
        let items = self
            .raw()
            .as_array()
            .ok_or_else(|| self.wrong_type("an array"))?;
        let item = |(i, value)| {
            let key = format!("{}#{}", self.key, i + 1);
            Field {
                context: self.context,
                key,
                value,
            }
        };
        Ok(items.iter().enumerate().map(item).collect())
    }

    pub fn is_table(&self) -> bool {
        self.raw().is_table()
    }

    pub fn is_text(&self) -> bool {
        self.raw().is_str()
    }

    pub fn is_list(&self) -> bool {
        self.raw().is_array()
    }

    pub fn table(&self) -> Result<Table<'a>, CaseError> {
        let entries = self
            .raw()
            .as_table()
            .ok_or_else(|| self.wrong_type("a table"))?;
        let (context, key) = (self.context, self.key.clone());
        Ok(Table {
            context,
            key,
            span: self.value.span(),
            entries,
        })
    }
}
