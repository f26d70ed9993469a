//! What an answer must keep to, whatever the case.

use crate::case::{Case, Kind};
use crate::output::summary::Checks;
use crate::output::text::percent;
use crate::output::warnings::NOTABLE_SHARE;

/// The checks that are beyond their limit, in words.
pub fn missed(case: &Case, checks: &Checks) -> Vec<String> {
    // The bodies of a bearing stand on each other, so that each interface carries the whole load;
    // in a general scene they may stand side by side.
    let balance = match case.kind {
        Kind::Bearing(_) => checks.force_balance,
        Kind::General(_) => None,
    };
    [
        ("the force balance of an interface", balance),
        ("penetration over descent", checks.max_penetration_relative),
        ("the violation of Coulomb's law", checks.coulomb_violation),
        (
            "the load that stabilisation carries",
            checks.stabilisation_share,
        ),
    ]
    .into_iter()
    .filter_map(|(what, value)| Some((what, value.filter(|v| *v > NOTABLE_SHARE)?)))
    .map(|(what, value)| {
        let (value, limit) = (percent(value), percent(NOTABLE_SHARE));
        format!("{what} is {value}, and the limit is {limit}")
    })
    .collect()
}
