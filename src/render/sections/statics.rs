//! Where forces act, what is left unbalanced, and the checks of the solution.

use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};

/// Where the resultants act, and what contact leaves unbalanced on bodies that nothing else holds.
pub fn statics(summary: &Summary) -> Vec<Table> {
    let units = &summary.units;
    let mut centres = Table::new("")
        .words(&format!("resultant acts at, {}", units.length))
        .figures([""]);
    for (name, interface) in &summary.answer.interfaces.0 {
        centres.row([name.into(), Cell::Place(interface.centre_of_force)]);
    }
    let mut balance = Table::new("").words("held by contact alone").figures([
        format!("sum of forces, {}", units.force),
        format!("of moments, {} {}", units.force, units.length),
    ]);
    let largest = |v: &[f64; 3]| v.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    for (name, body) in &summary.answer.balance.0 {
        let [force, moment] = [&body.force, &body.moment].map(|v| Cell::Tiny(largest(v)));
        balance.row([name.into(), force, moment]);
    }
    vec![centres, balance]
}

/// How well the solution keeps to its own equations.
pub fn checks(summary: &Summary) -> Table {
    let checks = &summary.answer.checks;
    let mut table = Table::new("").words("Checks").figures([""]);
    for (name, value) in [
        ("force balance, of the load", checks.force_balance),
        (
            "penetration, of the descent",
            checks.max_penetration_relative,
        ),
        ("Coulomb violation, of μ p", checks.coulomb_violation),
        ("energy balance, of the work", checks.energy_imbalance),
        (
            "carried by stabilisation, of the load",
            checks.stabilisation_share,
        ),
    ] {
        table.row([name.into(), value.map_or("not computed".into(), Cell::Tiny)]);
    }
    table
}
