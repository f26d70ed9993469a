//! Everything that is printed of a run, as plain data: its answer, and what the run adds to it.
//! `summary.json` and the table are made from it.

mod hand_checks;
mod rules;
mod sizing;
mod values;

pub use hand_checks::HandCheck;
pub use rules::{JudgedRule, RuleSheet, SteelAfter};
pub use sizing::{Demand, EvenLoad, SizedLine, SizedPatch, Sizing, SizingRule};
pub use values::{Comparison, Counters, ElasticTwin, Reported, Timing};

use super::left_out::LeftOut;
use super::warnings::Warning;
use crate::answer::{Answer, Named};
use crate::ground::file::{FileError, write_json};
use crate::ground::units::UnitLabels;
use schemars::generate::{Contract, SchemaSettings};
use serde::Serialize;
use std::path::Path;

/// Everything that is said of a run. What is missing is null in JSON, never "not a number".
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Summary {
    pub case: String,
    /// Whose calculation it is: what the case says, and null for what it leaves blank.
    pub title_block: Named<Option<String>>,
    pub units: UnitLabels,
    pub brinell_version: String,
    #[serde(flatten)]
    pub answer: Answer,
    #[serde(flatten)]
    pub counters: Counters,
    pub timing: Timing,
    pub peak_memory_bytes: Option<u64>,
    /// The elastic solution that elastic figures are of, where it has a mesh of its own; null where it has that of the
    /// case.
    pub elastic_twin: Option<ElasticTwin>,
    pub comparison: Vec<Comparison>,
    /// The sizing rules, for bearings and for lines and patches of contact that are recognised.
    pub sizing: Option<Sizing>,
    /// Design rules beside the loads that were found, for lines of contact.
    pub rules: Option<RuleSheet>,
    /// What can be recomputed by hand.
    pub hand_checks: Vec<HandCheck>,
    pub assumptions: Vec<String>,
    pub left_out: Vec<LeftOut>,
    pub warnings: Vec<Warning>,
}

/// The JSON schema of `summary.json`: made from these types and what is said of them.
pub fn schema() -> serde_json::Value {
    let mut settings = SchemaSettings::draft2020_12();
    settings.contract = Contract::Serialize;
    let mut schema = settings.into_generator().into_root_schema_for::<Summary>();
    schema.insert(
        "title".to_owned(),
        "summary.json of a run of Brinell".into(),
    );
    schema.to_value()
}

impl Summary {
    /// Writes `summary.json`, indented, atomically.
    ///
    /// # Errors
    /// [`FileError::Write`] names the path.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write_json(path, self)
    }
}
