//! The families of claims.
//!
//! One file a family. Each says what is solved, where its answer is known from, and why its
//! tolerance is what it is.

mod bending;
mod cattaneo_mindlin;
mod certificate;
mod crossed_cylinders;
mod dents;
mod equal_steels;
mod full_sliding;
mod hertz_line;
mod hertz_sphere;
mod patch;
mod penalty;
mod press_fit;
mod punch;
mod ring;
mod rounded_punch;
mod sphere_plastic;
mod tube;
mod uniaxial;
mod v_groove;

use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// A family of claims.
#[derive(Debug, Clone, Copy)]
pub struct ClaimFamily {
    pub name: &'static str,
    measure: fn(Extent) -> Result<Vec<LadderClaim>, VerifyError>,
}

/// All families, simple ones first.
pub const FAMILIES: [ClaimFamily; 20] = [
    family("patch", patch::claims),
    family("uniaxial", uniaxial::claims),
    family("bending", bending::claims),
    family("ring", ring::claims),
    family("tube", tube::claims),
    family("punch", punch::claims),
    family("hertz-line", hertz_line::claims),
    family("hertz-sphere", hertz_sphere::claims),
    family("crossed-cylinders", crossed_cylinders::claims),
    family("v-groove", v_groove::claims),
    family("sphere-plastic", sphere_plastic::claims),
    family("dents", dents::claims),
    family("equal-steels", equal_steels::claims),
    family("cattaneo-mindlin", cattaneo_mindlin::claims),
    family("full-sliding", full_sliding::claims),
    family("certificate", certificate::claims),
    family("rounded-punch", rounded_punch::claims),
    family("press-fit", press_fit::claims),
    family("penalty", penalty::claims),
    family("penalty-bearing", penalty::claims_of_bearing),
];

const fn family(
    name: &'static str,
    measure: fn(Extent) -> Result<Vec<LadderClaim>, VerifyError>,
) -> ClaimFamily {
    ClaimFamily { name, measure }
}

impl ClaimFamily {
    /// Solves the problems of the family.
    ///
    /// # Errors
    /// [`VerifyError`] where a problem could not be solved or read.
    pub fn measure(&self, extent: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
        let mut claims = (self.measure)(extent)?;
        for claim in &mut claims {
            claim.family = self.name;
        }
        Ok(claims)
    }
}

/// The family called `name`, or all.
///
/// # Errors
/// [`VerifyError::Suite`] with the names that exist.
pub fn families(name: Option<&str>) -> Result<Vec<ClaimFamily>, VerifyError> {
    let Some(name) = name else {
        return Ok(FAMILIES.to_vec());
    };
    let found: Vec<ClaimFamily> = FAMILIES.into_iter().filter(|s| s.name == name).collect();
    if found.is_empty() {
        return Err(VerifyError::Suite {
            name: name.into(),
            known: FAMILIES.map(|s| s.name).join(", "),
        });
    }
    Ok(found)
}
