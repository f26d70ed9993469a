//! Bearings that cannot be built, and meshes that cannot be asked for.

use miette::Diagnostic;
use thiserror::Error;

/// A dimension outside of its range.
#[derive(Debug, Clone, PartialEq, Error, Diagnostic)]
#[error("{key} = {value}: {range}")]
#[diagnostic(code(brinell::case::geometry), help("{help}"))]
pub struct GeometryError {
    /// The key of the case file, for example `roller_wall`.
    pub key: &'static str,
    /// In the unit of the geometry; an angle in degrees.
    pub value: f64,
    /// What is allowed.
    pub range: String,
    /// Why.
    pub help: &'static str,
}

impl GeometryError {
    /// `Ok` where `within`, else the error. A value that is not a number is never within.
    pub(super) fn unless(
        within: bool,
        key: &'static str,
        value: f64,
        range: impl FnOnce() -> String,
        help: &'static str,
    ) -> Result<(), Self> {
        if within && value.is_finite() {
            return Ok(());
        }
        let range = range();
        Err(Self {
            key,
            value,
            range,
            help,
        })
    }

    pub(super) fn positive(key: &'static str, value: f64) -> Result<(), Self> {
        let help = "lengths and sizes are positive";
        Self::unless(
            value > 0.0,
            key,
            value,
            || "must be more than 0".into(),
            help,
        )
    }
}
