//! What a file says about itself: its format, and the fingerprint of what made it.

use super::cursor::{Cursor, Encoding, quoted};
use super::error::MeshError;
use super::raw::Raw;

/// The layouts that are read.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    Two,
    Four,
}

/// `$MeshFormat`: version, encoding, size of numbers.
pub(super) fn mesh_format(cursor: &mut Cursor<'_>) -> Result<Version, MeshError> {
    cursor.begin("the version of the format")?;
    let place = cursor.place();
    let line = String::from_utf8_lossy(cursor.rest_of_line()).into_owned();
    let words: Vec<&str> = line.split_whitespace().collect();
    let [version, encoding, size] = words.as_slice() else {
        let expected = "version, encoding and size of numbers".to_owned();
        return Err(MeshError::Syntax {
            place,
            expected,
            found: quoted(line.as_bytes()),
        });
    };
    let refused = |what: String| {
        Err(MeshError::Version {
            place: place.clone(),
            what,
        })
    };
    let version = match *version {
        "2.2" => Version::Two,
        "4.1" => Version::Four,
        other => return refused(quoted(other.as_bytes())),
    };
    match *encoding {
        "0" => {}
        "1" => {
            cursor.encoding = Encoding::Binary { big_endian: false };
            let one = cursor.int("the number one in binary")?;
            match one {
                1 => {}
                0x0100_0000 => cursor.encoding = Encoding::Binary { big_endian: true },
                _ => {
                    return Err(
                        cursor.syntax("the number one in binary", one.to_string().as_bytes())
                    );
                }
            }
        }
        other => return refused(format!("with encoding {}", quoted(other.as_bytes()))),
    }
    if *size != "8" {
        return refused(format!("with numbers of {} bytes", quoted(size.as_bytes())));
    }
    Ok(version)
}

/// The fingerprint, in a line `brinell-fingerprint: <text>` of a `$Comments` section.
pub(super) fn find_fingerprint(comments: &[u8], raw: &mut Raw) {
    for line in comments.split(|b| *b == b'\n') {
        if let Some(text) = line.trim_ascii().strip_prefix(b"brinell-fingerprint:") {
            let text = String::from_utf8_lossy(text.trim_ascii()).into_owned();
            raw.fingerprint = Some(text).filter(|text| !text.is_empty());
        }
    }
}
