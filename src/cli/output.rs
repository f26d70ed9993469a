//! Standard output.

use std::io::{ErrorKind, Write};
use std::path::PathBuf;
use std::sync::OnceLock;

/// Why standard output could not be written, the first time.
static WRITE_ERROR: OnceLock<String> = OnceLock::new();

/// Prints a line. A reader that has gone, such as `head`, stops nothing; what else cannot be written makes the
/// command fail at its end.
pub fn say(text: &str) {
    if let Err(error) = writeln!(std::io::stdout(), "{text}")
        && error.kind() != ErrorKind::BrokenPipe
    {
        WRITE_ERROR.get_or_init(|| error.to_string());
    }
}

/// Prints the names of files that were written.
pub fn say_written(paths: &[PathBuf]) {
    let names: Vec<String> = paths.iter().map(|p| p.display().to_string()).collect();
    say(&format!("written: {}", names.join(", ")));
}

/// Why standard output could not be written, where it could not.
pub fn write_error() -> Option<&'static str> {
    WRITE_ERROR.get().map(String::as_str)
}
