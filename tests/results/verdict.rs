//! What the verdict and the digest say of limits and figures that the mesh does not tell.

use crate::summary::{loaded, summarise};
use brinell::analytic::rules::{RuleVerdict, Standing};
use brinell::answer::certify::{Errors, Figure, Quantity};
use brinell::render::digest::digest;
use brinell::render::summary::{EvenLoad, SizedLine, Sizing, Summary};
use brinell::render::verdict::{News, verdict};

/// A line that uses 99.4 % of (2-49) meets it, misses it, or leaves it open, as its error has it.
#[test]
fn a_limit_within_the_error_is_open() {
    let (scene, state) = loaded();
    let mut summary = summarise(&scene, &state);
    let mut said = |used: f64, error: Option<f64>| {
        let open = RuleVerdict::Unresolved;
        let of = |error| RuleVerdict::of(Standing::Rule, used - error, used + error);
        let line = SizedLine {
            interface: "block-plate".into(),
            across: 0.0,
            images: 1,
            relative_radius: 1.5,
            not_hertz: None,
            merged: false,
            peak_line_load: 8.0,
            at: 0.0,
            from_end: 4.0,
            hertz_pressure: 165.0 * used,
            limit: Some(165.0),
            utilisation: Some(used),
            error,
            met: Some(used <= 1.0),
            verdict: Some(error.map_or(open, of)),
            even: EvenLoad {
                line_load: 8.0,
                hertz_pressure: 160.0,
                utilisation: None,
                met: None,
            },
        };
        summary.sizing = Some(Sizing {
            lines: vec![line],
            ..Sizing::default()
        });
        let verdict = verdict(&summary, &[]);
        (verdict.news, verdict.head, verdict.rest[0].clone())
    };
    let (_, _, met) = said(0.994, Some(0.005));
    assert_eq!(met, "The pressure limit (2-49) is met.");
    for (used, error, tells) in [
        (0.994, Some(0.014), "99.4 ± 1.4 %"),
        (1.001, Some(0.014), "100.1 ± 1.4 %"),
        (0.5, None, "NOT RESOLVED"),
    ] {
        let (news, _, open) = said(used, error);
        assert!(
            news == News::Care && open.contains("is open") && open.contains(tells),
            "{open}"
        );
    }
    let (news, head, _) = said(1.03, Some(0.014));
    assert!(news == News::Bad && head.contains("FAILS"), "{head}");
}

/// The digest shows the largest pressure that is resolved, and tells of a larger one that is not.
#[test]
fn a_larger_figure_that_is_not_resolved_is_told() {
    let (scene, state) = loaded();
    let mut summary = summarise(&scene, &state);
    let figure = |place: &str, value: f64, discretisation: Option<f64>| Figure {
        what: Quantity::PeakPressure,
        place: place.into(),
        value,
        error: Errors {
            discretisation,
            ..Errors::default()
        },
        note: None,
        at_edge: false,
    };
    let line = |summary: &Summary| {
        let text = digest(summary, &[]);
        let line = text.lines().find(|line| line.contains("p max")).unwrap();
        line.to_owned()
    };
    summary.answer.certificate = vec![
        figure("known", 100.0, Some(5.0)),
        figure("coarse", 400.0, None),
    ];
    let told = line(&summary);
    assert!(told.contains("100 ± 5 ksi, known"), "{told}");
    assert!(
        told.ends_with("; 400.0 ksi, NOT RESOLVED, on coarse"),
        "{told}"
    );
    summary.answer.certificate[1].value = 90.0;
    assert!(!line(&summary).contains("coarse"));
}
