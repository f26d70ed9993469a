//! Numbers and quantities of a case: a bare number in the units of the file, or a string.

use toml::de::DeValue;

use super::error::{CaseError, ErrorKind};
use super::parse::Field;
use super::place::Located;
use crate::ground::units::{Dimension, Quantity};

impl Field<'_> {
    /// A quantity of `dimension` in the units of the file. A bare number is taken to be in those
    /// units already, an angle in degrees; angles come out in radians.
    pub fn quantity(&self, dimension: Dimension) -> Result<Located<f64>, CaseError> {
        let value = match self.raw() {
            DeValue::String(text) => Quantity::parse(text)
                .and_then(|quantity| quantity.value_in(self.units(), dimension))
                .map_err(|error| {
                    let span = self.place();
                    let message = format!("`{}`: {error}", span.key);
                    let report = CaseError::new(ErrorKind::Unit, message);
                    report.at(&span.source, span.span, format!("{dimension} is wanted"))
                })?,
            _ => {
                let number = self.number(dimension)?;
                if dimension == Dimension::ANGLE {
                    number.to_radians()
                } else {
                    number
                }
            }
        };
        Ok(self.located(value))
    }

    /// A finite number without a unit, or a string such as `"15 %"`.
    pub fn ratio(&self) -> Result<Located<f64>, CaseError> {
        self.quantity(Dimension::RATIO)
    }

    /// Three numbers or quantities.
    pub fn vector(&self, dimension: Dimension) -> Result<Located<[f64; 3]>, CaseError> {
        let items = self.list()?;
        let [x, y, z] = items.as_slice() else {
            let why = format!("three components are wanted, these are {}", items.len());
            return Err(self.place().error(ErrorKind::Value, why));
        };
        let part = |field: &Field| field.quantity(dimension).map(|q| q.value);
        Ok(self.located([part(x)?, part(y)?, part(z)?]))
    }

    fn number(&self, wanted: Dimension) -> Result<f64, CaseError> {
        let number = match self.raw() {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(int) => i128::from_str_radix(int.as_str(), int.radix())
                .ok()
                .map(|i| i as f64),
            _ if wanted == Dimension::RATIO => return Err(self.wrong_type("a number")),
            _ => {
                let example = self.units().write(1.0, wanted);
                let text = format!("a number or a string such as \"{example}\"");
                return Err(self.wrong_type(&text));
            }
        };
        number
            .filter(|n: &f64| n.is_finite())
            .ok_or_else(|| self.place().error(ErrorKind::Value, "is not finite"))
    }
}
