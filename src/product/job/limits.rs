//! What an answer must keep to, whatever the case.

use crate::answer::Checks;
use crate::case::{Case, Kind};
use crate::render::text::percent;
use crate::render::warnings::NOTABLE_SHARE;

/// The checks that are beyond their limit, in words.
pub fn missed(case: &Case, checks: &Checks) -> Vec<String> {
    let values = [
        checks.force_balance,
        checks.max_penetration_relative,
        checks.coulomb_violation,
        checks.stabilisation_share,
    ];
    let limited = LIMITED.into_iter().zip(values).skip(first(case));
    let beyond = limited.filter_map(|(what, v)| Some((what, v.filter(|v| *v > NOTABLE_SHARE)?)));
    beyond
        .map(|(what, value)| {
            let (value, limit) = (percent(value), percent(NOTABLE_SHARE));
            format!("{what} is {value}, and the limit is {limit}")
        })
        .collect()
}

/// The limits that a run of `case` will be held to, in words.
pub fn all(case: &Case) -> Vec<String> {
    let limit = percent(NOTABLE_SHARE);
    let limited = LIMITED.into_iter().skip(first(case));
    limited.map(|what| format!("{what}: {limit}")).collect()
}

/// What is limited to [`NOTABLE_SHARE`].
const LIMITED: [&str; 4] = [
    "the force balance of an interface",
    "penetration over descent",
    "the violation of Coulomb's law",
    "the load that stabilisation carries",
];

/// The first limit that counts: what passes from level to level of a general scene may be less than its load.
fn first(case: &Case) -> usize {
    match &case.kind {
        Kind::Bearing(_) => 0,
        Kind::General(_) => 1,
    }
}
