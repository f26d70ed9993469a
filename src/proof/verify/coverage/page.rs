//! The page `docs/coverage.md`, and the lines of the terminal.

use super::criteria::{CoverageCriterion, criteria, groups};
use super::exclusion::ClaimPair;
use super::measure::{BarVerdict, ClaimRecord};
use super::set::Set;
use super::tally::Tally;
use crate::ground::markdown::table;
use crate::render::text::significant;

/// How many of the worst are named.
const WORST_LISTED: usize = 10;

fn percent(share: Option<f64>) -> String {
    share.map_or("-".to_owned(), |s| {
        format!("{} %", significant(100.0 * s, 3))
    })
}

/// Demands and what was found of them.
pub fn demands(criteria: &[CoverageCriterion]) -> String {
    table(["", "", "wanted", "found"], criteria.iter().map(demand))
}

fn demand(c: &CoverageCriterion) -> [String; 4] {
    let [wanted, found] = [Some(c.wanted), c.found].map(|value| match c.wanted > 1.0 {
        true => value.map_or("-".to_owned(), |v| significant(v, 3)),
        false => percent(value),
    });
    let mark = match c.holds() {
        Some(true) => "ok",
        Some(false) => "MISSED",
        None => "-",
    };
    let sense = if c.least { "at least" } else { "at most" };
    [
        mark.to_owned(),
        c.what.clone(),
        format!("{sense} {wanted}"),
        found,
    ]
}

/// A table of groups of claims that make a claim at all.
fn groups_by(title: &str, records: &[ClaimRecord], key: impl Fn(&ClaimRecord) -> String) -> String {
    let headings = [
        title,
        "claims",
        "hold",
        "undecidable",
        "unresolved",
        "true error",
        "nine of ten",
        "bar",
        "bar / error",
    ];
    let rows = groups(records, &key).into_iter().filter_map(|name| {
        let tally = Tally::of(records.iter().filter(|r| key(r) == name));
        (tally.claims > 0).then(|| {
            let width = tally.width().map_or("-".to_owned(), |w| significant(w, 2));
            let shares = [
                tally.covered(),
                tally.undecided(),
                tally.without_bar(),
                tally.error,
                tally.error_90,
                tally.bar,
            ];
            let counted = [name, tally.claims.to_string()].into_iter();
            counted.chain(shares.map(percent)).chain([width])
        })
    });
    table(headings, rows)
}

/// The claims that are farthest outside of their bars.
fn worst(records: &[ClaimRecord]) -> String {
    let outside = |r: &&ClaimRecord| r.verdict == BarVerdict::Missed;
    let ratio = |r: &ClaimRecord| {
        r.error()
            .zip(r.bar())
            .map_or(0.0, |(error, bar)| error / bar)
    };
    let mut missed: Vec<&ClaimRecord> = records.iter().filter(outside).collect();
    missed.sort_by(|a, b| ratio(b).total_cmp(&ratio(a)));
    let headings = [
        "bearing",
        "mesh",
        "steel",
        "figure",
        "where",
        "true error",
        "bar",
        "error / bar",
    ];
    let row = |record: &ClaimRecord| {
        let steel = if record.elastic {
            "elastic"
        } else {
            "as drawn"
        };
        [
            record.bearing.clone(),
            record.preset.clone(),
            steel.to_owned(),
            record.reading.what.clone(),
            record.reading.place.clone(),
            percent(record.error()),
            percent(record.bar()),
            significant(ratio(record), 2),
        ]
    };
    table(headings, missed.into_iter().take(WORST_LISTED).map(row))
}

/// The pairs of claims that exclude each other by most.
fn excluded(records: &[ClaimRecord]) -> String {
    let mut pairs = ClaimPair::all(records);
    pairs.retain(ClaimPair::exclude_each_other);
    pairs.sort_by(|a, b| b.distance().total_cmp(&a.distance()));
    let headings = [
        "bearing",
        "figure",
        "where",
        "one mesh",
        "another",
        "distance / sum of bars",
    ];
    let claim = |record: &ClaimRecord| {
        let value = significant(record.reading.value, 3);
        let bar = significant(record.reading.bar.unwrap_or(0.0), 3);
        format!("{}: {value} ± {bar}", record.preset)
    };
    let row = |pair: ClaimPair| {
        let [a, b] = pair.records();
        [
            a.bearing.clone(),
            a.reading.what.clone(),
            a.reading.place.clone(),
            claim(a),
            claim(b),
            significant(pair.distance(), 2),
        ]
    };
    table(headings, pairs.into_iter().take(WORST_LISTED).map(row))
}

/// The page. `unsolved` says of the runs that failed, or are beyond a limit, why, `unknown` names bearings without true values.
pub fn page(
    records: &[ClaimRecord],
    sets: &[Set],
    unsolved: &[String],
    unknown: &[String],
) -> String {
    let sets: Vec<String> = sets.iter().map(Set::to_string).collect();
    let missing = match unknown {
        [] => String::new(),
        names => format!(
            "\nWithout stored true values, so that one mesh's claims are judged only by another's: {}.\n",
            names.join(", ")
        ),
    };
    let failed: String = unsolved.iter().map(|text| format!("- {text}\n")).collect();
    let failed = match failed.is_empty() {
        true => String::new(),
        false => format!("\nNot solved, or not to be relied upon:\n\n{failed}"),
    };
    format!(
        "# Do the bars hold?\n\n\
         Written by `brinell verify --suite coverage --write`; do not edit. Every bearing of the sets\n\
         {} is solved on each mesh as a user's case is, with elastic steel{}, and every\n\
         claim of its certificate is set beside the true value: two fine meshes, their difference\n\
         extrapolated by half, uncertain by that difference or by what the figure scatters in the\n\
         middle of all bearings, whichever is more ([`cases/coverage`](../cases/coverage)). A claim\n\
         is *missed* where |value - true value| exceeds bar plus uncertainty; else it is *undecidable* where the\n\
         uncertainty exceeds a third of the bar, and *holds* where it does not; *unresolved* where it says so itself. Shares that hold\n\
         are of those that can be decided, undecidable ones of bearings that have true values. Errors and bars are relative, in the middle of the group.\n\
         Errors of `auto` that a limit is set for are counted where the true value is known to a third of the limit.\n\
         {missing}{failed}\n\
         ## What is asked\n\n{}\n\
         ## By mesh\n\n{}\n## By figure\n\n{}\n## By figure and mesh\n\n{}\n## By bearing\n\n{}\n\
         ## The worst\n\n{}\n\
         ## Claims that exclude each other\n\nOne of the two at least is wrong, whatever is true.\n\n{}",
        sets.join(", "),
        if records.iter().all(|r| r.elastic) {
            ""
        } else {
            " and as it is"
        },
        demands(&criteria(records)),
        groups_by("mesh", records, |r| r.preset.clone()),
        groups_by("figure", records, |r| r.reading.what.clone()),
        groups_by("figure, mesh", records, |r| format!(
            "{}, {}",
            r.reading.what, r.preset
        )),
        groups_by("bearing", records, |r| r.bearing.clone()),
        worst(records),
        excluded(records),
    )
}

/// Of a run, in a line.
pub fn line(name: &str, records: &[ClaimRecord]) -> String {
    let tally = Tally::of(records);
    let first = records.first();
    format!(
        "{name:44} {:>8} unknowns {:>7.1} s  {:3} claims: {:3} hold, {:2} missed, {:2} undecidable, {:2} unresolved{}",
        first.map_or(0, |r| r.unknowns),
        first.map_or(0.0, |r| r.cpu_s),
        tally.claims,
        tally.holds,
        tally.missed,
        tally.undecidable,
        tally.unresolved,
        if tally.compared == 0 {
            "; no true values"
        } else {
            ""
        },
    )
}
