//! The fingerprint that ties a mesh file to the bearing it was made for.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

use flate2::{Compression, GzBuilder};

use super::layout::Layout;
use super::parameters::parameters;
use super::request::MeshRequest;
use crate::ground::file::FileError;
use crate::ground::file::write_atomically;
use crate::ground::hash::Fnv;

/// A hash of everything that the mesh of a bearing depends on: 16 hexadecimal digits.
///
/// Lengths enter in diameters and all numbers rounded to 12 digits, so that a bearing has one
/// fingerprint whatever its unit. The end shape of the rollers does not enter (beyond the element
/// sizes and the plane of nodes that it asks for), nor does a curved face: meshes have square ends and flat faces and are shaped after reading.
pub fn fingerprint(geometry: &dyn Layout, request: &MeshRequest) -> String {
    let template = geometry.template();
    let mut text = format!("brinell {} {}\n", template.name, template.version);
    for parameter in parameters(geometry, request) {
        let value = if parameter.is_length {
            parameter.value / geometry.diameter()
        } else {
            parameter.value
        };
        // Adding zero turns -0 into 0. Writing to a string cannot fail.
        let _ = writeln!(text, "{} {:.11e}", parameter.name, value + 0.0);
    }
    Fnv::hex(&text)
}

/// Copies the mesh file `raw_msh` into `out`, with the fingerprint in a `$Comments` section at its end: compressed where
/// the name of `out` ends in `.gz`, else as it is. The same input gives the same bytes: no time is written.
///
/// # Errors
/// Where one of the files cannot be read or written.
pub fn write_with_fingerprint(
    raw_msh: &Path,
    fingerprint: &str,
    out: &Path,
) -> Result<(), FileError> {
    let comment = format!("$Comments\nbrinell-fingerprint: {fingerprint}\n$EndComments\n");
    let compressed = out.extension().is_some_and(|ending| ending == "gz");
    write_atomically(out, |mut file| {
        let mut raw = File::open(raw_msh)?;
        if !compressed {
            io::copy(&mut raw, &mut file)?;
            return file.write_all(comment.as_bytes());
        }
        let mut gzip = GzBuilder::new().mtime(0).write(file, Compression::best());
        io::copy(&mut raw, &mut gzip)?;
        gzip.write_all(comment.as_bytes())?;
        gzip.finish()?.flush()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::bearing::Preset;
    use crate::case::bearing::sample::initial;

    #[test]
    fn one_bearing_has_one_fingerprint_in_any_unit() {
        let inch = initial();
        let mut millimetre = inch.clone();
        for length in [
            &mut millimetre.roller.diameter,
            &mut millimetre.roller.length,
            &mut millimetre.intermediate_thickness,
            &mut millimetre.upper_thickness,
            &mut millimetre.lower_thickness,
        ] {
            *length *= 25.4;
        }
        millimetre.roller.wall = Some(0.75 * 25.4);
        millimetre.plan = [8.0 * 25.4; 2];
        for preset in Preset::ALL {
            let request = MeshRequest {
                preset,
                ..MeshRequest::default()
            };
            let print = fingerprint(&inch, &request);
            assert_eq!(print, fingerprint(&millimetre, &request));
            assert_eq!(print.len(), 16);
        }
    }

    #[test]
    fn whatever_changes_the_mesh_changes_the_fingerprint() {
        let request = MeshRequest::default();
        let mut seen = vec![fingerprint(&initial(), &request)];
        let mut longer = initial();
        longer.roller.length += 1e-6;
        seen.push(fingerprint(&longer, &request));
        let mut solid = initial();
        solid.roller.wall = None;
        seen.push(fingerprint(&solid, &request));
        for preset in [Preset::H025, Preset::H0125] {
            let request = MeshRequest {
                preset,
                ..MeshRequest::default()
            };
            seen.push(fingerprint(&initial(), &request));
        }
        let full = MeshRequest {
            full: true,
            ..MeshRequest::default()
        };
        seen.push(fingerprint(&initial(), &full));
        let finer = MeshRequest {
            overrides: vec![("end_size".into(), 0.1)],
            ..MeshRequest::default()
        };
        seen.push(fingerprint(&initial(), &finer));
        let count = seen.len();
        seen.sort();
        seen.dedup();
        assert_eq!(seen.len(), count);
    }

    #[test]
    fn a_displaced_bearing_is_whole_whether_asked_for_or_not() {
        let mut displaced = initial();
        displaced.offset = 1.25;
        let prints = [false, true].map(|full| {
            let request = MeshRequest {
                full,
                ..MeshRequest::default()
            };
            fingerprint(&displaced, &request)
        });
        assert_eq!(prints[0], prints[1]);
    }
}
