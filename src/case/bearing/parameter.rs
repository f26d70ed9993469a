//! A number of a gmsh template.

/// A number of the template, with what it measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// In the template.
    pub name: &'static str,
    /// In the unit of the bearing; an angle in radians.
    pub value: f64,
    /// Is it a length?
    pub is_length: bool,
}

impl Parameter {
    /// A length.
    pub fn length(name: &'static str, value: f64) -> Self {
        Self {
            name,
            value,
            is_length: true,
        }
    }

    /// An angle, a count or a choice.
    pub fn number(name: &'static str, value: f64) -> Self {
        Self {
            name,
            value,
            is_length: false,
        }
    }
}
