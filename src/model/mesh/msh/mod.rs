//! Reading gmsh's MSH 4.1 and 2.2: text or binary, plain or gzip-compressed.
//!
//! ```text
//!  bytes --inflate--> cursor (ascii | binary) --v4 | v2--> Raw --build--> Mesh
//! ```
//!
//! The compression and the encoding are recognised by content, not by the file's name. Sections
//! that are not needed are passed over. Nothing in a file makes the reader panic, or allocate more
//! than the file's length warrants.

mod ascii;
mod binary;
mod build;
mod completeness;
mod cursor;
mod error;
mod faces;
mod file;
mod groups;
mod header;
mod hexes;
mod kind;
mod names;
mod place;
mod raw;
mod reading;
mod records;
mod sections;
mod tags;
mod usage;
mod v2;
mod v4;
pub mod write;

use std::io::Read;
use std::path::Path;

use flate2::read::MultiGzDecoder;

pub use error::MeshError;
pub use place::{At, FilePlace};
pub use reading::Reading;

use super::Mesh;
use cursor::{Cursor, Encoding};
use header::{Version, find_fingerprint, mesh_format};
use raw::{Places, Raw};

/// Reads the mesh file `path`.
///
/// Nodes get indices in the order of the file; those that no hexahedron uses are left out. Bodies
/// are the physical volumes in order of first appearance, surfaces the physical surfaces in order
/// of their tags, both with `volume_<tag>` and `surface_<tag>` for names where the file has none.
///
/// # Errors
/// A [`MeshError`] that says where the file is wrong and what to do about it.
pub fn read(path: &Path) -> Result<Mesh, MeshError> {
    Ok(read_with_notes(path)?.mesh)
}

/// As [`read`], telling also what was changed.
///
/// # Errors
/// As [`read`].
pub fn read_with_notes(path: &Path) -> Result<Reading, MeshError> {
    let source_name = path.display().to_string();
    match crate::ground::input::bytes(path) {
        Ok(bytes) => parse_with_notes(&bytes, &source_name),
        Err(source) => Err(MeshError::Read {
            source_name,
            source,
        }),
    }
}

/// Reads a mesh from the bytes of a file called `source`.
///
/// # Errors
/// As [`read`].
pub fn parse(bytes: &[u8], source: &str) -> Result<Mesh, MeshError> {
    Ok(parse_with_notes(bytes, source)?.mesh)
}

/// As [`parse`], telling also what was changed.
///
/// # Errors
/// As [`read`].
pub fn parse_with_notes(bytes: &[u8], source: &str) -> Result<Reading, MeshError> {
    if bytes.starts_with(&[0x1f, 0x8b]) {
        let inflated = inflate(bytes, source)?;
        return parse_plain(&inflated, source);
    }
    parse_plain(bytes, source)
}

/// Decompresses, but not a file that grows beyond all reason.
fn inflate(bytes: &[u8], source: &str) -> Result<Vec<u8>, MeshError> {
    // Text meshes shrink 3 to 20 times; 1000 times is what a file of nothing but zeros does.
    let limit = (bytes.len() as u64)
        .saturating_mul(200)
        .saturating_add(1 << 20);
    let failed = |reason: String| MeshError::Gzip {
        source_name: source.to_owned(),
        reason,
    };
    let mut inflated = Vec::new();
    let mut stream = MultiGzDecoder::new(bytes).take(limit + 1);
    stream
        .read_to_end(&mut inflated)
        .map_err(|e| failed(e.to_string()))?;
    if inflated.len() as u64 > limit {
        return Err(failed(format!(
            "it is a gzip bomb: {} bytes would grow to more than {limit}",
            bytes.len()
        )));
    }
    Ok(inflated)
}

fn parse_plain(bytes: &[u8], source: &str) -> Result<Reading, MeshError> {
    if !bytes.trim_ascii_start().starts_with(b"$") {
        return Err(MeshError::NotMsh {
            source_name: source.to_owned(),
        });
    }
    let mut cursor = Cursor::new(bytes, source);
    let mut raw = Raw::default();
    let mut version = None;
    let mut seen: Vec<&str> = Vec::new();
    while let Some(section) = cursor.open_section()? {
        let known = [
            "MeshFormat",
            "PhysicalNames",
            "Entities",
            "Nodes",
            "Elements",
        ];
        if !known.contains(&section) {
            let inside = cursor.skip_section()?;
            if section == "Comments" {
                find_fingerprint(inside, &mut raw);
            }
            continue;
        }
        if seen.contains(&section) {
            return Err(MeshError::RepeatedSection {
                place: cursor.place(),
            });
        }
        seen.push(section);
        match (section, version) {
            ("MeshFormat", _) => version = Some(mesh_format(&mut cursor)?),
            ("PhysicalNames", _) => names::read(&mut cursor, &mut raw)?,
            (_, None) => return Err(missing(source, "MeshFormat")),
            ("Nodes", Some(Version::Two)) => raw.nodes = v2::nodes(&mut cursor)?,
            ("Elements", Some(Version::Two)) => raw.elements = v2::elements(&mut cursor)?,
            ("Nodes", Some(Version::Four)) => raw.nodes = v4::nodes(&mut cursor)?,
            ("Elements", Some(Version::Four)) => raw.elements = v4::elements(&mut cursor)?,
            (_, Some(Version::Four)) => v4::entities(&mut cursor, &mut raw)?,
            (_, Some(Version::Two)) => {
                cursor.skip_section()?;
                continue;
            }
        }
        cursor.close_section()?;
    }
    for section in ["MeshFormat", "Nodes", "Elements"] {
        if !seen.contains(&section) {
            return Err(missing(source, section));
        }
    }
    let places = Places {
        source,
        text: cursor.encoding == Encoding::Text,
    };
    build::build(raw, &places)
}

fn missing(source: &str, section: &'static str) -> MeshError {
    MeshError::MissingSection {
        source_name: source.to_owned(),
        section,
    }
}
