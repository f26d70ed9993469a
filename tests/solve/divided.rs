//! How linear systems are solved does not show in the answer.

use crate::bearing::{case, figures, state};
use brinell::model::scene::SolverKind;
use brinell::product::job;

#[test]
fn a_divided_model_has_the_answer_of_the_whole() {
    let mut case = case();
    let mesh = job::find_mesh(&case, None, &mut |_| ()).expect("the shipped mesh");
    let [direct, divided] = [SolverKind::Direct, SolverKind::Divided].map(|solver| {
        case.set_solver(solver);
        state(&case, mesh.clone())
    });
    let contacts = direct.1.contacts.iter();
    let statuses: Vec<u8> = contacts.flat_map(|c| c.status.iter().copied()).collect();
    assert!(
        statuses.contains(&1) && statuses.contains(&2),
        "{statuses:?}"
    );
    // Forces balance to 1e-11; the bounds of friction are settled to 1e-5 of the largest.
    for ((name, a), (_, b)) in figures(&direct).iter().zip(figures(&divided)) {
        assert!((a - b).abs() <= 1e-5 * a.abs(), "{name}: {a} and {b}");
    }
}
