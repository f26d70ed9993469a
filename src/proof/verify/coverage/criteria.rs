//! What is asked of the claims.

use super::exclusion::share_excluded;
use super::measure::ClaimRecord;
use super::quantile::quantile;
use super::tally::Tally;
use crate::ground::order::ascending;

/// A demand, what was found, and whether that will do.
#[derive(Debug, Clone, PartialEq)]
pub struct CoverageCriterion {
    pub what: String,
    pub wanted: f64,
    /// None where there is nothing to judge by.
    pub found: Option<f64>,
    /// At least as much is wanted, or at most.
    pub least: bool,
}

impl CoverageCriterion {
    pub fn holds(&self) -> Option<bool> {
        let found = self.found?;
        Some(if self.least {
            found >= self.wanted
        } else {
            found <= self.wanted
        })
    }
}

/// What is asked of errors on `auto`.
struct Accuracy {
    /// Figures that say the same: where no edge decides a peak, the peak itself is away from edges.
    figures: &'static [&'static str],
    elastic_only: bool,
    middle: Option<f64>,
    nine_of_ten: Option<f64>,
}

const fn asked(
    figures: &'static [&'static str],
    middle: Option<f64>,
    nine_of_ten: Option<f64>,
) -> Accuracy {
    Accuracy {
        figures,
        elastic_only: false,
        middle,
        nine_of_ten,
    }
}

const ACCURACY: [Accuracy; 6] = [
    asked(&["peak_pressure", "pressure_away"], Some(0.02), Some(0.05)),
    asked(&["hertz_pressure"], None, Some(0.02)),
    Accuracy {
        elastic_only: true,
        ..asked(&["mises_away", "peak_mises"], Some(0.025), Some(0.07))
    },
    asked(&["line_load", "line_load_away"], Some(0.01), None),
    asked(&["bore_mises"], Some(0.025), None),
    asked(&["descent"], Some(0.025), None),
];

/// Kinds and presets in the order in which they come.
pub fn groups(records: &[ClaimRecord], key: impl Fn(&ClaimRecord) -> String) -> Vec<String> {
    ascending(records.iter().map(key))
}

/// All demands.
pub fn criteria(records: &[ClaimRecord]) -> Vec<CoverageCriterion> {
    let all = Tally::of(records);
    let mut list = vec![
        least("of all claims hold", 0.95, all.covered()),
        most("of all claims cannot be decided", 0.1, all.undecided()),
        most(
            "of pairs of claims of two meshes exclude each other",
            0.05,
            share_excluded(records),
        ),
    ];
    let presets = groups(records, |r| r.preset.clone());
    for preset in &presets {
        let of = |r: &&ClaimRecord| r.preset == *preset;
        let tally = Tally::of(records.iter().filter(of));
        let limit = if preset == "h025" { 0.4 } else { 0.1 };
        let text = |what: &str| format!("{preset}: {what}");
        list.push(most(text("are not resolved"), limit, tally.without_bar()));
        if preset == "h0125" {
            let seen = Tally::of(records.iter().filter(of).filter(|r| has_nodes(r)));
            list.push(most(
                text("are not resolved, of strips with three nodes across and more"),
                limit,
                seen.without_bar(),
            ));
        }
        list.push(most(
            text("bar over error, in the middle"),
            4.0,
            tally.width(),
        ));
    }
    for preset in &presets {
        for what in groups(records, |r| r.reading.what.clone()) {
            let of = |r: &&ClaimRecord| r.preset == *preset && r.reading.what == what;
            let tally = Tally::of(records.iter().filter(of));
            list.push(least(
                format!("{preset}: {what} hold"),
                0.9,
                tally.covered(),
            ));
        }
    }
    let lines = |what: &str| {
        let of = |r: &&ClaimRecord| r.elastic && r.reading.what == what;
        let has = |r: &&ClaimRecord| match what {
            "hertz_pressure" => r.reading.bar.is_some(),
            _ => r.strip.is_none_or(|strip| !strip.no_hertz),
        };
        records.iter().filter(of).filter(has).count()
    };
    // Every interface in contact has an area.
    let interfaces = lines("contact_area");
    let claimed = (interfaces > 0).then(|| lines("hertz_pressure") as f64 / interfaces as f64);
    list.push(least(
        "of the elastic lines that neither merge nor carry at an edge have hertz_p0",
        0.8,
        claimed,
    ));
    for asked in ACCURACY {
        let of = |r: &&ClaimRecord| {
            let kind = asked.figures.contains(&r.reading.what.as_str());
            let steel = r.elastic || !asked.elastic_only;
            r.preset == "auto" && kind && steel && r.reading.bar.is_some()
        };
        for (share, name, limit) in [
            (0.5, "in the middle", asked.middle),
            (0.9, "nine of ten", asked.nine_of_ten),
        ] {
            let Some(limit) = limit else { continue };
            let errors = records.iter().filter(of).filter_map(|r| error(r, limit));
            let found = quantile(errors.collect(), share);
            let what = asked.figures[0];
            list.push(most(format!("auto: error of {what}, {name}"), limit, found));
        }
    }
    list
}

/// Does the mesh have three nodes across the strip below which the figure is? A preset of one size has none
/// across the strips of light loads, and nothing that it reads there is worth a bar.
fn has_nodes(record: &ClaimRecord) -> bool {
    (record.strip).is_none_or(|strip| strip.half_width >= 1.5 * strip.middle)
}

/// Where the true value is known to a third of `limit`, as a bar is judged: below that nothing can be measured.
fn error(record: &ClaimRecord, limit: f64) -> Option<f64> {
    let truth = record.truth?;
    let known = truth.uncertainty <= limit / 3.0 * truth.value.abs();
    record.error().filter(|_| known)
}

fn least(what: impl Into<String>, wanted: f64, found: Option<f64>) -> CoverageCriterion {
    CoverageCriterion {
        what: what.into(),
        wanted,
        found,
        least: true,
    }
}

fn most(what: impl Into<String>, wanted: f64, found: Option<f64>) -> CoverageCriterion {
    CoverageCriterion {
        least: false,
        ..least(what, wanted, found)
    }
}
