//! The verification ladder: problems with known answers, and how far off Brinell is.
//!
//! One file a family. Each says what is solved, where its answer is known from, and why its
//! tolerance is what it is; [`suites`] lists them.

pub mod claim;
pub mod coverage;
mod drawn;
mod error;
pub mod extreme;
pub mod kit;
pub mod matrix;
pub mod problem_h;
pub mod random;
pub mod stability;
mod stream;

mod bending;
mod bumps;
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
mod profile;
mod punch;
mod ring;
mod rounded_punch;
mod rubbing;
mod sphere_plastic;
mod tube;
mod uniaxial;
mod v_groove;

pub use claim::Claim;
pub use error::VerifyError;

/// How much of the ladder is climbed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// Claims of a few seconds each.
    Fast,
    All,
}

/// A family of claims.
#[derive(Debug, Clone, Copy)]
pub struct Suite {
    pub name: &'static str,
    measure: fn(Extent) -> Result<Vec<Claim>, VerifyError>,
}

/// All families, simple ones first.
pub const SUITES: [Suite; 19] = [
    suite("patch", patch::claims),
    suite("uniaxial", uniaxial::claims),
    suite("bending", bending::claims),
    suite("ring", ring::claims),
    suite("tube", tube::claims),
    suite("punch", punch::claims),
    suite("hertz-line", hertz_line::claims),
    suite("hertz-sphere", hertz_sphere::claims),
    suite("crossed-cylinders", crossed_cylinders::claims),
    suite("v-groove", v_groove::claims),
    suite("sphere-plastic", sphere_plastic::claims),
    suite("dents", dents::claims),
    suite("equal-steels", equal_steels::claims),
    suite("cattaneo-mindlin", cattaneo_mindlin::claims),
    suite("full-sliding", full_sliding::claims),
    suite("certificate", certificate::claims),
    suite("rounded-punch", rounded_punch::claims),
    suite("penalty", penalty::claims),
    suite("penalty-bearing", penalty::claims_of_bearing),
];

const fn suite(
    name: &'static str,
    measure: fn(Extent) -> Result<Vec<Claim>, VerifyError>,
) -> Suite {
    Suite { name, measure }
}

impl Suite {
    /// Solves the problems of the family.
    ///
    /// # Errors
    /// [`VerifyError`] where a problem could not be solved or read.
    pub fn measure(&self, extent: Extent) -> Result<Vec<Claim>, VerifyError> {
        let mut claims = (self.measure)(extent)?;
        for claim in &mut claims {
            claim.family = self.name;
        }
        Ok(claims)
    }
}

/// The suite called `name`, or all.
///
/// # Errors
/// [`VerifyError::Suite`] with the names that exist.
pub fn suites(name: Option<&str>) -> Result<Vec<Suite>, VerifyError> {
    let Some(name) = name else {
        return Ok(SUITES.to_vec());
    };
    let found: Vec<Suite> = SUITES.into_iter().filter(|s| s.name == name).collect();
    if found.is_empty() {
        return Err(VerifyError::Suite {
            name: name.into(),
            known: SUITES.map(|s| s.name).join(", "),
        });
    }
    Ok(found)
}
