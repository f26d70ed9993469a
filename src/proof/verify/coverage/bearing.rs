//! A bearing that is solved.

use crate::case::{self, Case, CaseError, Kind};

/// A bearing, as the text of its case file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bearing {
    pub name: String,
    pub text: String,
}

impl Bearing {
    /// # Errors
    /// As [`case::parse`].
    pub fn case(&self) -> Result<Case, CaseError> {
        case::parse(&format!("{}.toml", self.name), &self.text)
    }

    /// The same of elastic steel, which unloading leaves as it was.
    ///
    /// # Errors
    /// As [`case::parse`].
    pub fn twin(&self) -> Result<Case, CaseError> {
        let mut case = self.case()?;
        case.set_elastic();
        if let Kind::Bearing(bearing) = &mut case.kind {
            bearing.unload_to = None;
        }
        Ok(case)
    }

    /// Is it elastic itself?
    ///
    /// # Errors
    /// As [`case::parse`].
    pub fn is_elastic(&self) -> Result<bool, CaseError> {
        Ok(!self.case()?.controls.plasticity)
    }

    /// Is it displaced, and so modelled as a whole?
    ///
    /// # Errors
    /// As [`case::parse`].
    pub fn is_displaced(&self) -> Result<bool, CaseError> {
        Ok(matches!(self.case()?.kind, Kind::Bearing(bearing) if bearing.is_whole()))
    }
}
