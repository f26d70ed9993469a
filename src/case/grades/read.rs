//! Reads a file of grades, marking what is wrong with it.

use super::grade::{Grade, Strength};
use crate::case::error::{CaseError, ErrorKind};
use crate::case::source::Source;
use crate::ground::units::{Dimension, Quantity, UnitSystem};
use serde::Deserialize;
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GradeFile {
    grade: Vec<GradeEntry>,
}

/// The keys of a `[[grade]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GradeEntry {
    name: Spanned<String>,
    #[serde(default)]
    also: Vec<String>,
    source: String,
    note: Option<String>,
    youngs_modulus: Spanned<String>,
    poissons_ratio: Spanned<f64>,
    yield_stress: Option<Spanned<StrengthEntry>>,
    ultimate_strength: Option<Spanned<StrengthEntry>>,
    hardness: Option<Spanned<f64>>,
}

#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "a stress such as \"355 MPa\" is wanted, or a list of { up_to = \"16 mm\", value = \"355 MPa\" }"
)]
enum StrengthEntry {
    Every(String),
    ByThickness(Vec<StepEntry>),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StepEntry {
    up_to: String,
    value: String,
}

/// The grades of the file `source`.
///
/// # Errors
/// [`CaseError`] marks the place in that file.
pub fn grades(source: &Source) -> Result<Vec<Grade>, CaseError> {
    let file: GradeFile = toml::from_str(source.text()).map_err(|error| {
        let message = error.message().trim().replace('\n', ", ");
        let report = CaseError::new(ErrorKind::Syntax, format!("{}: {message}", source.name()));
        match error.span() {
            Some(span) => report.at(source, span, "here"),
            None => report,
        }
    })?;
    let reader = Reader { source };
    file.grade.into_iter().map(|g| reader.grade(g)).collect()
}

struct Reader<'s> {
    source: &'s Source,
}

impl Reader<'_> {
    fn wrong<T>(&self, what: &Spanned<T>, why: &str) -> CaseError {
        CaseError::new(ErrorKind::Value, why).at(self.source, what.span(), "here")
    }

    fn grade(&self, entry: GradeEntry) -> Result<Grade, CaseError> {
        let name = entry.name.get_ref().trim().to_owned();
        if name.is_empty() {
            return Err(self.wrong(&entry.name, "a grade has a name"));
        }
        let nu = *entry.poissons_ratio.get_ref();
        if !(nu > -1.0 && nu < 0.5) {
            let why = "Poisson's ratio must lie between -1 and 0.5";
            return Err(self.wrong(&entry.poissons_ratio, why));
        }
        let hardness = entry.hardness.map(|h| match *h.get_ref() {
            number if number.is_finite() && number > 0.0 => Ok(number),
            _ => Err(self.wrong(&h, "the hardness must be positive")),
        });
        let strength =
            |entry: Option<Spanned<StrengthEntry>>| entry.map(|e| self.strength(e)).transpose();
        Ok(Grade {
            youngs_modulus: self.positive(&entry.youngs_modulus, Dimension::STRESS)?.0,
            poissons_ratio: nu,
            yield_stress: strength(entry.yield_stress)?,
            ultimate_strength: strength(entry.ultimate_strength)?,
            hardness: hardness.transpose()?,
            name,
            also: entry.also,
            source: entry.source,
            note: entry.note,
        })
    }

    fn strength(&self, entry: Spanned<StrengthEntry>) -> Result<Strength, CaseError> {
        // Places within are not known: an entry may be of two kinds.
        let at = entry.span();
        let within = |text: String| Spanned::new(at.clone(), text);
        let steps = match entry.into_inner() {
            StrengthEntry::Every(value) => {
                let (value, _) = self.positive(&within(value), Dimension::STRESS)?;
                vec![(None, value)]
            }
            StrengthEntry::ByThickness(entries) => {
                let mut steps = Vec::new();
                let mut before = 0.0;
                for step in entries {
                    let up_to = within(step.up_to);
                    let (thickness, size) = self.positive(&up_to, Dimension::LENGTH)?;
                    if size <= before {
                        return Err(self.wrong(&up_to, "thicknesses must ascend"));
                    }
                    before = size;
                    let (value, _) = self.positive(&within(step.value), Dimension::STRESS)?;
                    steps.push((Some(thickness), value));
                }
                steps
            }
        };
        if steps.is_empty() {
            return Err(self.wrong(&Spanned::new(at, ()), "a strength has at least one step"));
        }
        Ok(Strength { steps })
    }

    /// A quantity, and its size in SI units.
    fn positive(
        &self,
        text: &Spanned<String>,
        dimension: Dimension,
    ) -> Result<(Quantity, f64), CaseError> {
        let wrong = |why: String| self.wrong(text, &why);
        let quantity = Quantity::parse(text.get_ref()).map_err(|error| wrong(error.to_string()))?;
        let size = quantity.value_in(UnitSystem::MNPa, dimension);
        match size.map_err(|error| wrong(error.to_string()))? {
            size if size > 0.0 => Ok((quantity, size)),
            _ => Err(wrong(format!("`{quantity}` must be positive"))),
        }
    }
}
