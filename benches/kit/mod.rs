//! What the long benchmarks share: the machine in words, and the page that their tables go to.

use brinell::output::file::write_atomically;
use brinell::output::text::significant;
use std::path::Path;

pub type Failure = Box<dyn std::error::Error>;

/// Processors and memory, as Linux describes them.
pub fn machine() -> String {
    let of = |file: &str, key: &str| {
        let text = std::fs::read_to_string(file).unwrap_or_default();
        let line = text.lines().find(|l| l.starts_with(key));
        let value = line.and_then(|l| l.split(':').nth(1));
        value.map(|v| v.trim().to_owned()).unwrap_or_default()
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let kib = of("/proc/meminfo", "MemTotal");
    let kib: f64 = kib.trim_end_matches(" kB").parse().unwrap_or(f64::NAN);
    format!(
        "{cores} cores of {}, {} GiB",
        of("/proc/cpuinfo", "model name"),
        significant(kib / 1024.0 / 1024.0, 2)
    )
}

/// Puts `text` between the markers `name` of the page, which is made where it is missing.
pub fn insert(path: &Path, name: &str, text: &str) -> Result<(), Failure> {
    let old = match std::fs::read_to_string(path) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => "# Performance\n".into(),
        other => other?,
    };
    let [begin, end] = [format!("<!-- {name} -->"), format!("<!-- /{name} -->")];
    let section = format!("{begin}\n{}\n{end}", text.trim_end());
    let new = match (old.find(&begin), old.find(&end)) {
        (Some(from), Some(to)) if from < to => {
            format!("{}{section}{}", &old[..from], &old[to + end.len()..])
        }
        (None, None) => format!("{}\n\n{section}\n", old.trim_end()),
        _ => return Err(format!("{}: the markers do not pair", path.display()).into()),
    };
    Ok(write_atomically(path, |out| out.write_all(new.as_bytes()))?)
}
