//! What an answer must keep to, whatever the case.

use crate::answer::checks::NOTABLE_SHARE;
use crate::answer::{Answer, InterfaceFigures, Named};
use crate::case::{Case, Kind};
use crate::render::text::{percent, place};

/// The checks that are beyond their limit, in words.
pub fn missed(case: &Case, answer: &Answer) -> Vec<String> {
    let checks = &answer.checks;
    let values = [
        checks.force_balance,
        checks.max_penetration_relative,
        checks.coulomb_violation,
        checks.stabilisation_share,
        checks.energy_imbalance,
    ];
    let limited = LIMITED.into_iter().zip(values).skip(first(case));
    let beyond = limited.filter_map(|(what, v)| Some((what, v.filter(|v| *v > NOTABLE_SHARE)?)));
    beyond
        .map(|(what, value)| {
            let (value, limit) = (percent(value), percent(NOTABLE_SHARE));
            let advice = match what {
                PENETRATION => where_deepest(&answer.interfaces),
                _ => String::new(),
            };
            format!("{what} is {value}, and the limit is {limit}{advice}")
        })
        .collect()
}

/// Where bodies penetrate more than their facets explain, and what to do.
fn where_deepest(interfaces: &Named<InterfaceFigures>) -> String {
    let pairs = interfaces.0.iter();
    let beyond = pairs.filter_map(|(name, i)| {
        Some((
            name,
            i.unexplained_penetration,
            i.unexplained_penetration_at?,
        ))
    });
    let deepest = beyond.max_by(|a, b| a.1.total_cmp(&b.1));
    deepest.map_or_else(String::new, |(name, _, at)| {
        format!(
            "; it is deepest in {name} at {}, where faces are long beside what presses or bends there: shorter ones, of both sides, \
             make it less, though slowly where friction holds a sharp edge",
            place(at)
        )
    })
}

const PENETRATION: &str = "penetration over descent";

/// The limits that a run of `case` will be held to, in words.
pub fn all(case: &Case) -> Vec<String> {
    let limit = percent(NOTABLE_SHARE);
    let limited = LIMITED.into_iter().skip(first(case));
    limited.map(|what| format!("{what}: {limit}")).collect()
}

/// What is limited to [`NOTABLE_SHARE`].
const LIMITED: [&str; 5] = [
    "the force balance of an interface",
    PENETRATION,
    "the violation of Coulomb's law",
    "the load that stabilisation carries",
    "the work that is neither stored nor spent",
];

/// The first limit that counts: what passes from level to level of a general scene may be less than its load.
fn first(case: &Case) -> usize {
    match &case.kind {
        Kind::Bearing(_) => 0,
        Kind::General(_) => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_place_is_that_of_what_facets_do_not_explain() {
        let interface = |name: &str, overlap, unexplained, x| {
            let figures = InterfaceFigures {
                max_penetration: overlap,
                unexplained_penetration: unexplained,
                unexplained_penetration_at: (unexplained > 0.0).then_some([x, 0.0, 0.0]),
                ..InterfaceFigures::default()
            };
            (name.to_owned(), figures)
        };
        let round = interface("round", 0.3, 0.0, 1.0);
        let corner = interface("corner", 0.2, 0.1, 2.5);
        let said = where_deepest(&Named(vec![round.clone(), corner]));
        assert!(said.contains("corner at (2.5000, 0, 0)"), "{said}");
        assert_eq!(where_deepest(&Named(vec![round])), "");
    }
}
