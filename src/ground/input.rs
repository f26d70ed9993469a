//! Files that are read: nothing that is no file, and nothing beyond all reason.

use crate::ground::memory;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// Bytes that a text which somebody writes by hand, or a table of cases, may have.
pub const TEXT: u64 = 256 << 20;

/// A file of at most this size, in bytes, is read however little memory is left: whether the rest is enough
/// to solve is for the solution to say.
const READ_IN_ANY_CASE: u64 = 4 << 20;

/// The bytes of the file at `path`, which may be as many as half of the memory that is left.
///
/// # Errors
/// As [`bounded`].
pub fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    bounded(
        path,
        memory::available()
            .map_or(u64::MAX - 1, |left| (0.5 * left) as u64)
            .max(READ_IN_ANY_CASE),
    )
}

/// The text of the file at `path`, of [`TEXT`] bytes at most.
///
/// # Errors
/// As [`bounded`], and where it is not UTF-8.
pub fn text(path: &Path) -> io::Result<String> {
    let bytes = bounded(path, TEXT)?;
    String::from_utf8(bytes)
        .map_err(|_| io::Error::new(ErrorKind::InvalidData, "it is no text (not valid UTF-8)"))
}

/// The bytes of the file at `path`, `most` at most. Devices and pipes, which may never end, are not opened.
///
/// # Errors
/// Where it cannot be read, is no file, or is larger.
pub fn bounded(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let refused = |why: String| Err(io::Error::new(ErrorKind::InvalidInput, why));
    let about = fs::metadata(path)?;
    if !about.is_file() {
        return refused(format!("it is {}, and no file", kind(&about)));
    }
    let too_large = |size: u64| format!("it has {size} bytes, and may have {most} at most");
    if about.len() > most {
        return refused(too_large(about.len()));
    }
    let mut bytes = Vec::with_capacity(about.len() as usize);
    // Some files, as of the kernel, say nothing of their size, and some grow.
    File::open(path)?.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        refused(too_large(bytes.len() as u64))
    } else {
        Ok(bytes)
    }
}

fn kind(about: &fs::Metadata) -> &'static str {
    if about.is_dir() {
        return "a folder";
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let of = about.file_type();
        if of.is_fifo() {
            return "a pipe";
        }
        if of.is_socket() {
            return "a socket";
        }
    }
    "a device"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_or_no_file_is_refused_as_what_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("five");
        fs::write(&path, "12345").unwrap();
        assert_eq!(bounded(&path, 5).unwrap(), b"12345");
        let why = |path: &Path| bounded(path, 4).unwrap_err().to_string();
        assert_eq!(why(&path), "it has 5 bytes, and may have 4 at most");
        assert_eq!(why(folder.path()), "it is a folder, and no file");
        fs::write(&path, [0xff]).unwrap();
        assert!(text(&path).unwrap_err().to_string().contains("no text"));
        #[cfg(target_os = "linux")]
        assert_eq!(why(Path::new("/dev/zero")), "it is a device, and no file");
    }
}
