//! The hardening line of a steel: three ways to give it, and the modulus that follows.

use crate::case::assumption::Assumption;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::keys;
use crate::case::parse::{Field, Table};
use crate::case::place::Located;
use crate::ground::units::{Dimension, UnitSystem};

/// Ways to give the hardening line, of which a steel has one.
pub(super) const HARDENING_KEYS: &[&str] = &["hardening", "hardening_modulus", "tangent_modulus"];

/// What the strain of the second point of the hardening line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrainIs {
    /// Elastic and plastic strain together.
    Total,
    /// Plastic strain alone.
    Plastic,
}

/// The straight line beyond yield, as it was given.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Hardening {
    /// From yield through a second point of uniaxial tension.
    Point {
        stress: Located<f64>,
        strain: Located<f64>,
        strain_is: StrainIs,
    },
    /// H = dσ/dε_p.
    Modulus(Located<f64>),
    /// E_t = dσ/dε.
    Tangent(Located<f64>),
}

impl Hardening {
    pub fn read(
        table: &Table,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<Option<Self>, CaseError> {
        let given: Vec<Field> = HARDENING_KEYS
            .iter()
            .filter_map(|key| table.get(key))
            .collect();
        if let [first, second, ..] = given.as_slice() {
            let why = format!("the hardening is given already by `{}`", first.place().key);
            let help = "keep one of hardening, hardening_modulus, tangent_modulus";
            return Err(second.place().error(ErrorKind::Conflict, why).help(help));
        }
        let modulus = |field: &Field| field.quantity(Dimension::STRESS)?.not_negative();
        if let Some(modulus) = table.maybe("hardening_modulus", modulus)? {
            return Ok(Some(Self::Modulus(modulus)));
        }
        if let Some(modulus) = table.maybe("tangent_modulus", modulus)? {
            return Ok(Some(Self::Tangent(modulus)));
        }
        table.maybe("hardening", |field| {
            Self::point(&field.table()?, assumptions)
        })
    }

    fn point(table: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
        let table = table.clone().only(&keys::HARDENING)?;
        let stress = table
            .need("stress")?
            .quantity(Dimension::STRESS)?
            .positive()?;
        let strain = table.need("strain")?.ratio()?.positive()?;
        let choices = [("total", StrainIs::Total), ("plastic", StrainIs::Plastic)];
        let given = table.maybe("strain_is", |field| field.choice(&choices))?;
        let strain_is = given.as_ref().map_or(StrainIs::Total, |given| given.value);
        let word = if strain_is == StrainIs::Total {
            "total"
        } else {
            "plastic"
        };
        let key = format!("{}.strain_is", table.place().key);
        let why = "the strain of the second hardening point is the total strain unless said \
                   otherwise; as plastic strain the hardening modulus differs";
        assumptions.push(Assumption::new(&key, word, why, given.is_some()));
        Ok(Self::Point {
            stress,
            strain,
            strain_is,
        })
    }

    /// H of the steel of `body`, of Young's modulus `e` and yield stress `yields`; either may stand in another table than the
    /// hardening does.
    pub fn modulus(
        &self,
        body: &str,
        [e, yields]: [f64; 2],
        units: UnitSystem,
    ) -> Result<f64, CaseError> {
        let show = |stress: f64| units.show(stress, Dimension::STRESS);
        match self {
            Self::Modulus(modulus) => Ok(modulus.value),
            Self::Tangent(modulus) if modulus.value < e => Ok(series(e, modulus.value)),
            Self::Tangent(modulus) => {
                let why = format!("must be less than Young's modulus of `{body}`, {}", show(e));
                Err(modulus.place.error(ErrorKind::Value, why))
            }
            Self::Point {
                stress,
                strain,
                strain_is,
            } => {
                if stress.value <= yields {
                    let why = format!("lies below the yield stress of `{body}`, {}", show(yields));
                    let help = "the second point of the hardening line lies beyond yield";
                    return Err(stress.place.error(ErrorKind::Value, why).help(help));
                }
                let rise = stress.value - yields;
                let plastic = match strain_is {
                    StrainIs::Plastic => return Ok(rise / strain.value),
                    StrainIs::Total => strain.value - stress.value / e,
                };
                if plastic <= 0.0 {
                    let why = format!(
                        "is no more than the elastic strain of `{body}` at that stress, {:.6}",
                        stress.value / e
                    );
                    return Err(strain.place.error(ErrorKind::Value, why));
                }
                Ok(rise / plastic)
            }
        }
    }
}

/// H from the tangent modulus E_t: 1/E_t = 1/E + 1/H.
fn series(e: f64, tangent: f64) -> f64 {
    e * tangent / (e - tangent)
}
