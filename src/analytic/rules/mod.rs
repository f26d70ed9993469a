//! Design rules for rollers as engineers know them, beside each other: what load per length each allows, and what
//! peak pressure that is.
//!
//! Each file is one rule. Rules whose standard was not read by those who wrote this are *indicative*: their formulas
//! are those that books and papers give, they carry no clause number, and their verdict is never "met".
//!
//! | rule | where |
//! |---|---|
//! | p0 ≤ 1.65 σ_y, (2-49) of the reference study | [`pressure_limit`] |
//! | D L ≥ P E_s / 8 σ_y², (2-50) | [`study_sizing`] |
//! | AASHTO LRFD, contact of cylinders | [`aashto_lrfd`] |
//! | AASHTO and AREMA of old, load per inch | [`aashto_line_load`] |
//! | EN 1337-4 | [`en_1337_4`] |
//! | EN 13001-3-3, static and fatigue | [`en_13001`] |
//! | ISO 76 | [`iso_76`] |
//! | first yield, elastic shakedown | [`onset_of_yield`], [`shakedown`] |
//!
//! ```
//! use brinell::analytic::rules::{LoadError, RuleInput, RuleSteel, RuleVerdict, rules};
//! use brinell::ground::units::UnitSystem;
//!
//! // A roller of 160 mm on a plate, both S355, under 1500 N/mm.
//! let steel = RuleSteel { yield_stress: Some(355.0), ultimate_strength: Some(470.0), ..RuleSteel::elastic(210e3, 0.3) };
//! let input = RuleInput::new(UnitSystem::MmNMPa, 160.0, 400.0, [steel, steel]);
//! let all = rules(&input)?;
//! let rule = all.iter().find(|rule| rule.name == "EN 1337-4").ok_or("no such rule")?;
//! let judged = rule.judge(1500.0, LoadError::None).ok_or("it does not apply")?;
//! assert!((judged.utilisation - 1500.0 / 1935.5).abs() < 1e-4);
//! assert_eq!(judged.verdict, RuleVerdict::IndicativeWithin);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod aashto_line_load;
pub mod aashto_lrfd;
pub mod en_13001;
pub mod en_1337_4;
pub mod iso_76;
pub mod onset_of_yield;
pub mod pressure_limit;
pub mod shakedown;
pub mod study_sizing;

mod input;
mod rule;
mod verdict;

pub use input::{RuleInput, RuleSteel};
pub use rule::{Bound, Limit, Rule, RuleMeasure};
pub use verdict::{Judged, LoadError, RuleVerdict, Standing};

use super::error::DomainError;
use input::RuleContact;

/// Every rule for a roller on a plate: its limit, or why it has none here.
///
/// # Errors
/// [`DomainError`] where the roller itself is none, by the name of the argument; what only one rule asks for is told in
/// its [`Limit`].
pub fn rules(input: &RuleInput) -> Result<Vec<Rule>, DomainError> {
    let contact = RuleContact::new(input)?;
    Ok(vec![
        pressure_limit::rule(&contact),
        study_sizing::rule(&contact),
        aashto_lrfd::rule(&contact),
        aashto_line_load::rule(&contact),
        en_1337_4::rule(&contact),
        en_13001::statics(&contact),
        en_13001::fatigue(&contact),
        iso_76::rule(&contact),
        onset_of_yield::rule(&contact),
        shakedown::rule(&contact),
    ])
}
