//! Names of physical groups.

use super::cursor::{Cursor, quoted};
use super::error::MeshError;
use super::raw::{Key, Raw};

/// What entities and physical groups are called, by dimension.
pub(super) const ENTITIES: [&str; 4] = ["point", "curve", "surface", "volume"];

/// `$PhysicalNames`: lines `dimension tag "name"`, in text even in a binary file.
pub(super) fn read(cursor: &mut Cursor<'_>, raw: &mut Raw) -> Result<(), MeshError> {
    cursor.skip_blank();
    cursor.begin("the number of physical names")?;
    let count = cursor.text_size("the number of physical names")?;
    cursor.rest_of_line();
    for _ in 0..count {
        cursor.skip_blank();
        let mark = cursor.begin("a physical name")?;
        let rest = cursor.rest();
        if rest.starts_with(b"$End") {
            return Err(cursor.syntax("a physical name", b"the end of the section"));
        }
        let line = cursor.rest_of_line();
        let Some((key, name)) = name(line) else {
            let place = cursor.place_of(mark);
            let expected = "`dimension tag \"name\"`".to_owned();
            let found = quoted(line);
            return Err(MeshError::Syntax {
                place,
                expected,
                found,
            });
        };
        if let Some((first, _)) = raw.names.insert(key, (mark, name)) {
            let (place, first) = (cursor.place_of(mark), cursor.at(first));
            let what = [
                "physical point",
                "physical curve",
                "physical surface",
                "physical volume",
            ][usize::from(key.0)];
            return Err(MeshError::DuplicateTag {
                place,
                what,
                tag: key.1.to_string(),
                first,
            });
        }
    }
    Ok(())
}

fn name(line: &[u8]) -> Option<(Key, String)> {
    let line = std::str::from_utf8(line).ok()?;
    let (numbers, name) = line.strip_suffix('"')?.split_once('"')?;
    let mut numbers = numbers.split_whitespace();
    let dimension: u8 = numbers.next()?.parse().ok().filter(|d| *d <= 3)?;
    let tag: i32 = numbers.next()?.parse().ok()?;
    let key = (dimension, i64::from(tag).abs());
    numbers.next().is_none().then(|| (key, name.to_owned()))
}

/// The name of a group, or one made of its tag.
pub(super) fn name_of(raw: &Raw, (dimension, tag): Key) -> String {
    match raw.names.get(&(dimension, tag)) {
        Some((_, name)) if !name.trim().is_empty() => name.clone(),
        _ => format!("{}_{tag}", ENTITIES[usize::from(dimension.min(3))]),
    }
}
