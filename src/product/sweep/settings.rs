//! What a row sets.

use toml::Value;

/// Values by dotted key of the case, in the order in which they were written.
pub type KeyValues = Vec<(String, Value)>;
