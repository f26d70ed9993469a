//! The matrix of claims, for the terminal and for the documentation.

use super::LadderClaim;
use crate::ground::markdown::table;

/// A number with five digits, as short as it goes.
fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let size = x.abs();
    if (1e-3..1e5).contains(&size) {
        let digits = (4 - size.log10().floor() as i32).clamp(0, 7) as usize;
        format!("{x:.digits$}")
    } else {
        format!("{x:.3e}")
    }
}

/// A relative error in percent, or as a power of ten where it is tiny.
fn share(x: f64) -> String {
    if x.is_infinite() {
        "no tolerance".into()
    } else if x != 0.0 && x < 1e-5 {
        format!("{x:.0e}")
    } else {
        format!("{:.2} %", 100.0 * x)
    }
}

fn verdict(claim: &LadderClaim) -> &'static str {
    match (claim.holds(), claim.is_shown()) {
        (false, _) => "FAILS",
        (true, true) => "shown",
        (true, false) => "ok",
    }
}

/// How many claims have a tolerance, how many of them fail, and how many values are only shown, in words.
pub fn tally(claims: &[LadderClaim]) -> String {
    let shown = claims.iter().filter(|c| c.is_shown()).count();
    let failed = claims.iter().filter(|c| !c.holds()).count();
    format!(
        "{} claims, {failed} outside their tolerance; {shown} values more are shown, no tolerance",
        claims.len() - shown
    )
}

/// A line for the terminal.
pub fn line(c: &LadderClaim) -> String {
    format!(
        "{:5} {:17} {:58} {:>12} {:>12} {:>9} {:>12} {:>8} {:>7.2}",
        verdict(c),
        c.family,
        c.claim,
        number(c.reference),
        number(c.value),
        share(c.error),
        share(c.tolerance),
        c.dofs,
        c.seconds
    )
}

/// The head of the lines.
pub fn head() -> String {
    format!(
        "{:5} {:17} {:58} {:>12} {:>12} {:>9} {:>12} {:>8} {:>7}",
        "", "family", "claim", "reference", "value", "error", "allowed", "dofs", "s"
    )
}

/// The page `docs/verification.md`.
pub fn page(claims: &[LadderClaim]) -> String {
    format!(
        "# Verification\n\n\
         Written by `brinell verify --all --write`; do not edit. Each claim is solved afresh.\n\
         Errors are relative to the reference unless the claim says otherwise; `shown` marks values\n\
         that stand beside the claims, have no tolerance and are counted apart. Seconds are wall-clock, those of the\n\
         solution that the value was read from.\n\n\
         {}.\n\n{}\n\
         ## Sources and tolerances\n\n{}",
        tally(claims),
        table(HEADINGS, claims.iter().map(solved)),
        table(
            ["family", "claim", "reference from", "why this tolerance"],
            claims.iter().map(|c| [c.family, &c.claim, c.source, c.why]),
        )
    )
}

const HEADINGS: [&str; 9] = [
    "",
    "family",
    "claim",
    "reference",
    "value",
    "error",
    "allowed",
    "unknowns",
    "s",
];

fn solved(c: &LadderClaim) -> [String; 9] {
    [
        verdict(c).to_owned(),
        c.family.to_owned(),
        c.claim.clone(),
        number(c.reference),
        number(c.value),
        share(c.error),
        share(c.tolerance),
        c.dofs.to_string(),
        format!("{:.2}", c.seconds),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_that_fails_says_so() {
        let mut claim = LadderClaim::relative("p0", 103.0, 100.0, 0.01);
        assert!(line(&claim).starts_with("FAILS") && page(&[claim.clone()]).contains("| FAILS |"));
        claim.tolerance = 0.05;
        assert!(line(&claim).starts_with("ok"));
        let nan = LadderClaim::relative("p0", f64::NAN, 100.0, 0.01);
        assert!(line(&nan).starts_with("FAILS"));
    }

    #[test]
    fn what_is_shown_is_no_claim() {
        let claims = [
            LadderClaim::relative("p0", 100.0, 100.0, 0.01),
            LadderClaim::shown("p0, nodal", 150.0, 100.0),
        ];
        assert!(line(&claims[1]).starts_with("shown"));
        assert!(tally(&claims).starts_with("1 claims, 0 outside their tolerance; 1 values more"));
    }
}
