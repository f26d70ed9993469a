//! Families of the ladder at the extent that ends in seconds: every claim holds.

use brinell::proof::verify::{Extent, LadderClaim, families, matrix};

/// Solves the fast part of `suite`; fails where a claim does not hold.
#[track_caller]
fn holds(suite: &str) -> Vec<LadderClaim> {
    let mut claims = Vec::new();
    for family in families(Some(suite)).expect("exists") {
        claims.extend(family.measure(Extent::Fast).expect("solves"));
    }
    for claim in &claims {
        println!("{}", matrix::line(claim));
    }
    let failed: Vec<String> = claims
        .iter()
        .filter(|c| !c.holds())
        .map(matrix::line)
        .collect();
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    claims
}

/// Says of every claim with a tolerance where its reference comes from and why it is so wide.
#[track_caller]
fn explains(claims: &[LadderClaim]) {
    assert!(!claims.is_empty());
    for claim in claims {
        assert!(!claim.source.is_empty(), "{}: no source", claim.claim);
        assert!(
            claim.is_shown() || !claim.why.is_empty(),
            "{}: no reason",
            claim.claim
        );
    }
}

#[test]
fn patch() {
    explains(&holds("patch"));
}

#[test]
fn uniaxial() {
    explains(&holds("uniaxial"));
}

#[test]
fn dents() {
    explains(&holds("dents"));
}

#[test]
fn bending() {
    explains(&holds("bending"));
}

#[test]
fn ring() {
    explains(&holds("ring"));
}

#[test]
fn tube() {
    explains(&holds("tube"));
}

#[test]
fn punch() {
    explains(&holds("punch"));
}

/// Slow: none of its claims is fast.
#[test]
fn sphere_plastic() {
    assert!(holds("sphere-plastic").is_empty());
}

/// Estimated errors are of the size of the true ones.
#[test]
fn certificate() {
    explains(&holds("certificate"));
}

/// Contact of surfaces that are round alike.
#[test]
fn press_fit() {
    explains(&holds("press-fit"));
}

/// What a mesh does not show is not claimed.
#[test]
fn rounded_punch() {
    explains(&holds("rounded-punch"));
}
