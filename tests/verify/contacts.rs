//! The families of the ladder about contact and friction, as far as they are fast.

use brinell::proof::verify::{Extent, families, matrix};

/// Every claim of the suite holds.
fn holds(name: &str) {
    for suite in families(Some(name)).expect("a suite") {
        let claims = suite.measure(Extent::Fast).expect("solves");
        let failed: Vec<String> = claims
            .iter()
            .filter(|claim| !claim.holds())
            .map(matrix::line)
            .collect();
        assert!(!claims.is_empty() && failed.is_empty(), "{failed:#?}");
    }
}

#[test]
fn line_contact() {
    holds("hertz-line");
}

#[test]
fn point_contact() {
    holds("hertz-sphere");
}

#[test]
fn elliptic_contact() {
    holds("crossed-cylinders");
}

#[test]
fn two_lines_in_a_groove() {
    holds("v-groove");
}

#[test]
fn equal_bodies_feel_no_shear() {
    holds("equal-steels");
}

#[test]
fn partial_slip() {
    holds("cattaneo-mindlin");
}

#[test]
fn full_sliding() {
    holds("full-sliding");
}

#[test]
fn the_penalty_moves_nothing() {
    holds("penalty");
}
