//! A study as JSON: its levels and its curves. What is not a number is null.

use super::study::Study;
use crate::ground::file::FileError;
use crate::ground::file::write_json;
use serde_json::{Value, json};
use std::path::Path;

/// The study with its curves.
pub fn value(study: &Study) -> Value {
    json!({
        "case": study.case,
        "brinell_version": env!("CARGO_PKG_VERSION"),
        "series": study.series,
        "threads": study.threads,
        "quantities": study.quantities,
        "levels": study.levels,
        "curves": study.curves(),
    })
}

/// Writes the study, indented, whole or not at all.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn write(study: &Study, path: &Path) -> Result<(), FileError> {
    write_json(path, &value(study))
}

#[cfg(test)]
mod tests {
    use super::super::sample::study;
    use super::*;

    #[test]
    fn levels_and_curves_are_there() {
        let value = value(&study());
        assert_eq!(value["levels"].as_array().unwrap().len(), 3);
        assert_eq!(value["levels"][2]["dofs"], 24 * 64);
        assert!(value["levels"][0]["cpu_s"].is_number());
        assert_eq!(value["curves"][0]["reference"]["kind"], "extrapolated");
        assert_eq!(value["curves"][1]["errors"][2], Value::Null);
    }
}
