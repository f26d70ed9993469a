//! The fingerprint that ties a mesh file to the bearing it was made for.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

use flate2::{Compression, GzBuilder};

use super::geometry::BearingGeometry;
use super::parameters::parameters;
use super::preset::MeshRequest;
use super::template::TEMPLATE_VERSION;

/// A hash of everything that the mesh of a bearing depends on: 16 hexadecimal digits.
///
/// Lengths enter in diameters and all numbers rounded to 12 digits, so that a bearing has one
/// fingerprint whatever its unit. The end shape of the rollers does not enter (beyond the element
/// sizes it asks for): meshes have square ends and are shaped after reading.
pub fn fingerprint(geometry: &BearingGeometry, request: &MeshRequest) -> String {
    let mut text = format!("brinell bearing {TEMPLATE_VERSION}\n");
    for parameter in parameters(geometry, request) {
        let value = if parameter.is_length {
            parameter.value / geometry.diameter
        } else {
            parameter.value
        };
        // Adding zero turns -0 into 0. Writing to a string cannot fail.
        let _ = writeln!(text, "{} {:.11e}", parameter.name, value + 0.0);
    }
    format!("{:016x}", fnv1a(text.as_bytes()))
}

/// The 64-bit hash of Fowler, Noll and Vo, variant 1a.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Compresses the mesh file `raw_msh` into `out`, with the fingerprint in a `$Comments` section
/// at its end. The same input gives the same bytes: no time is written.
///
/// # Errors
/// Where one of the files cannot be read or written.
pub fn write_with_fingerprint(raw_msh: &Path, fingerprint: &str, out: &Path) -> io::Result<()> {
    let mut raw = File::open(raw_msh)?;
    let file = io::BufWriter::new(File::create(out)?);
    let mut gzip = GzBuilder::new().mtime(0).write(file, Compression::best());
    io::copy(&mut raw, &mut gzip)?;
    write!(
        gzip,
        "$Comments\nbrinell-fingerprint: {fingerprint}\n$EndComments\n"
    )?;
    gzip.finish()?.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hash_is_that_of_the_published_test_vectors() {
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}
