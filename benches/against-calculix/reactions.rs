//! The forces that CalculiX prints: on contact pairs and at node sets, those of the last step.

use std::collections::BTreeMap;
use std::path::Path;

/// Forces by the names that the deck gives, in upper case.
#[derive(Debug, Default)]
pub struct Forces {
    /// On the carrier of each contact pair, by the name of its law.
    pub pairs: BTreeMap<String, [f64; 3]>,
    /// On the nodes of a set.
    pub sets: BTreeMap<String, [f64; 3]>,
}

/// Reads the file at `path`.
///
/// # Errors
/// Where it cannot be read, or a total is not three numbers.
pub fn read(path: &Path) -> Result<Forces, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let mut forces = Forces::default();
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    while let Some(line) = lines.next() {
        let after = |key: &str| {
            let rest = line.split(key).nth(1)?;
            let name = rest.split([',', ' ']).find(|w| !w.is_empty())?;
            Some(name.to_owned())
        };
        let wrong = || format!("{}: not understood below: {line}", path.display());
        if let Some(name) = after("statistics for slave set") {
            // A heading, then the force and its moment.
            let force = lines.nth(1).and_then(vector).ok_or_else(wrong)?;
            let name = name.trim_end_matches("_CARRIER").to_owned();
            forces.pairs.insert(name, force);
        } else if line.starts_with("total force")
            && let Some(name) = after("for set")
        {
            let force = lines.next().and_then(vector).ok_or_else(wrong)?;
            forces.sets.insert(name, force);
        }
    }
    Ok(forces)
}

fn vector(line: &str) -> Option<[f64; 3]> {
    let mut words = line.split_whitespace().map(|w| w.parse::<f64>().ok());
    Some([words.next()??, words.next()??, words.next()??])
}
