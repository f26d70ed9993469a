//! One grade: what its standard says of it.

use crate::ground::units::{Dimension, Quantity, UnitError, UnitSystem};

/// A strength that depends on the thickness of the product as delivered.
#[derive(Debug, Clone, PartialEq)]
pub struct Strength {
    /// Largest thickness and the strength up to it, from the thinnest on; one without a thickness holds for all.
    pub(super) steps: Vec<(Option<Quantity>, Quantity)>,
}

/// A steel grade.
#[derive(Debug, Clone, PartialEq)]
pub struct Grade {
    /// Its name, as it is printed.
    pub name: String,
    /// Other names that it goes by.
    pub also: Vec<String>,
    /// Where its numbers are from.
    pub source: String,
    /// What else is to be known of it.
    pub note: Option<String>,
    /// Brinell hardness.
    pub hardness: Option<f64>,
    pub(super) youngs_modulus: Quantity,
    pub(super) poissons_ratio: f64,
    pub(super) yield_stress: Option<Strength>,
    pub(super) ultimate_strength: Option<Strength>,
}

/// The numbers of a grade for one thickness, in one system of units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GradeSteel {
    /// Young's modulus.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
    /// Yield stress, where the grade has one.
    pub yield_stress: Option<f64>,
    /// Ultimate strength, where the grade has one.
    pub ultimate_strength: Option<f64>,
    /// Brinell hardness, where the grade has one.
    pub hardness: Option<f64>,
}

/// Why a name or a thickness gives no steel.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, miette::Diagnostic)]
pub enum GradeError {
    /// No grade has this name.
    #[error("no steel is called `{name}`")]
    #[diagnostic(code(brinell::grade::unknown), help("{advice}"))]
    Unknown {
        /// The name.
        name: String,
        /// The nearest names.
        advice: String,
    },
    /// The strength depends on a thickness that is not given.
    #[error("the strength of `{name}` depends on the thickness of the product")]
    #[diagnostic(
        code(brinell::grade::thickness),
        help("give the thickness or diameter as delivered: {steps}")
    )]
    NoThickness {
        /// The grade.
        name: String,
        /// Thicknesses and strengths.
        steps: String,
    },
    /// Thicker than the grade goes.
    #[error("`{name}` is made up to {most}, and not {thickness} thick")]
    #[diagnostic(
        code(brinell::grade::too_thick),
        help("take another grade, or give its numbers: {steps}")
    )]
    TooThick {
        /// The grade.
        name: String,
        /// The thickness, with its unit.
        thickness: String,
        /// The largest thickness of the grade.
        most: String,
        /// Thicknesses and strengths.
        steps: String,
    },
    /// A number of the grade is none.
    #[error("the steel `{name}`: {error}")]
    #[diagnostic(code(brinell::grade::quantity))]
    Quantity {
        /// The grade.
        name: String,
        /// What is wrong.
        error: UnitError,
    },
}

impl Grade {
    /// Its numbers in `units`, of a product of this thickness or diameter (in the same units).
    ///
    /// # Errors
    /// Where the strength depends on a thickness that is not given, or is beyond all of the grade's.
    pub fn in_units(
        &self,
        units: UnitSystem,
        thickness: Option<f64>,
    ) -> Result<GradeSteel, GradeError> {
        let strength = |strength: &Option<Strength>| {
            let found = strength.as_ref().map(|s| self.at(s, units, thickness));
            found.transpose()
        };
        Ok(GradeSteel {
            youngs_modulus: self.value(&self.youngs_modulus, units, Dimension::STRESS)?,
            poissons_ratio: self.poissons_ratio,
            yield_stress: strength(&self.yield_stress)?,
            ultimate_strength: strength(&self.ultimate_strength)?,
            hardness: self.hardness,
        })
    }

    /// Does a strength depend on the thickness?
    pub fn is_by_thickness(&self) -> bool {
        let strengths = self.yield_stress.iter().chain(&self.ultimate_strength);
        strengths
            .flat_map(|s| &s.steps)
            .any(|(up_to, _)| up_to.is_some())
    }

    /// Has it a yield stress?
    pub fn yields(&self) -> bool {
        self.yield_stress.is_some()
    }

    fn at(
        &self,
        strength: &Strength,
        units: UnitSystem,
        thickness: Option<f64>,
    ) -> Result<f64, GradeError> {
        /// Thicknesses are converted from other units.
        const HAIR: f64 = 1e-9;
        let mut most = None;
        for (up_to, value) in &strength.steps {
            let holds = match (up_to, thickness) {
                (None, _) => true,
                (Some(_), None) => {
                    let (name, steps) = (self.name.clone(), strength.to_string());
                    return Err(GradeError::NoThickness { name, steps });
                }
                (Some(up_to), Some(thickness)) => {
                    most = Some(up_to);
                    thickness <= self.value(up_to, units, Dimension::LENGTH)? * (1.0 + HAIR)
                }
            };
            if holds {
                return self.value(value, units, Dimension::STRESS);
            }
        }
        Err(GradeError::TooThick {
            name: self.name.clone(),
            thickness: units.show(thickness.unwrap_or_default(), Dimension::LENGTH),
            most: most.map_or_else(String::new, ToString::to_string),
            steps: strength.to_string(),
        })
    }

    fn value(
        &self,
        quantity: &Quantity,
        units: UnitSystem,
        dimension: Dimension,
    ) -> Result<f64, GradeError> {
        let value = quantity.value_in(units, dimension);
        value.map_err(|error| GradeError::Quantity {
            name: self.name.clone(),
            error,
        })
    }
}

impl std::fmt::Display for Strength {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (i, (up_to, value)) in self.steps.iter().enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            match up_to {
                None => write!(f, "{comma}{value}")?,
                Some(up_to) => write!(f, "{comma}{value} to {up_to}")?,
            }
        }
        Ok(())
    }
}
