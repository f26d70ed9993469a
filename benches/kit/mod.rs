//! What the long benchmarks share: the machine in words, and the page that their tables go to.

pub use brinell::render::page::insert;
use brinell::render::text::significant;

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
