//! Tables, and the pages that hold them.

use std::path::Path;

/// The pages, from the root of the project.
pub const PERFORMANCE: &str = "docs/performance.md";
pub const CONVERGENCE: &str = "docs/convergence.md";
pub const CROSS_CHECK: &str = "docs/cross-check.md";

/// A Markdown table.
pub struct Table {
    text: String,
}

impl Table {
    pub fn new(head: &[&str]) -> Self {
        let rule = vec!["---"; head.len()].join(" | ");
        Self {
            text: format!("| {} |\n| {rule} |\n", head.join(" | ")),
        }
    }

    pub fn row(&mut self, cells: &[String]) {
        self.text.push_str(&format!("| {} |\n", cells.join(" | ")));
    }

    pub fn render(&self) -> &str {
        &self.text
    }
}

/// `value` with three significant digits, or four where it is a result.
pub fn number(value: f64, digits: usize) -> String {
    brinell::render::text::significant(value, digits)
}

/// `value` over `reference`, less one, in per cent.
pub fn error(value: f64, reference: f64) -> String {
    format!("{:+.2} %", 100.0 * (value / reference - 1.0))
}

/// How many times `ours` is `theirs`.
pub fn times(theirs: f64, ours: f64) -> String {
    format!("{:.1}", theirs / ours)
}

/// The machine, in words.
pub fn machine(ccx: &str) -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|l| l.strip_prefix("model name"));
    let model = model.map_or("an unknown processor", |m| {
        m.trim_start_matches([' ', '\t', ':'])
    });
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get());
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = load
        .split_whitespace()
        .next()
        .unwrap_or("unknown")
        .to_string();
    format!(
        "{model}, {cores} cores; CalculiX {ccx}, Brinell {}; load of the machine before: {load}.",
        env!("CARGO_PKG_VERSION")
    )
}

/// Puts `text` between the markers of `scenario` in `page`.
///
/// # Errors
/// Where the page cannot be read or written, or has no such markers.
pub fn write(page: &str, scenario: &str, text: &str) -> Result<(), String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(page);
    let failed = |e: std::io::Error| format!("{page}: {e}");
    let old = std::fs::read_to_string(&path).map_err(failed)?;
    let [begin, end] = ["begin", "end"].map(|word| format!("<!-- {word} {scenario} -->"));
    let missing = || format!("{page} has no place for {scenario}: {begin} ... {end}");
    let (head, rest) = old.split_once(&begin).ok_or_else(missing)?;
    let (_, tail) = rest.split_once(&end).ok_or_else(missing)?;
    std::fs::write(&path, format!("{head}{begin}\n\n{text}\n{end}{tail}")).map_err(failed)
}
